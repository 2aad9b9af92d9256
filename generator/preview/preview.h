#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "preview/exhibit.h"
#include "preview/framing.h"
#include "preview/surface.h"
#include "scene/composition.h"

namespace collage {

/// Linear-light RGB, rows from the top; 1 is white, and there may be more.
struct PreviewPicture {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;
};

struct PreviewShot {
  Bearing bearing;
  /// Pixels, at least 1.
  int width = 640;
  int height = 480;
  Framing framing = Framing::view;
};

/// Pictures of a sculpture in seconds, without POV-Ray: the camera, the lamps, the floor's shadow
/// and the finishes of templates/studio.inc, traced with Embree.
///
/// Four samples a pixel on a rotated grid; each is lit by a quarter of the lamps, in the same
/// directions all over the picture, so that a surface that fills a pixel gets the light of all of
/// them and there is no noise. Mirrors show the room and, unlit, what stands in it.
/// The same picture on any number of threads.
class Preview {
 public:
  /// `composition` must outlive the preview. Cost: 1 to 2 µs an instance.
  Preview(const Composition& composition, const TextureReader& read_texture,
          const PreviewShown& shown = {});
  ~Preview();
  Preview(Preview&&) noexcept;
  Preview& operator=(Preview&&) noexcept;

  /// On all threads. Cost: about 30 rays a pixel that shows the sculpture.
  [[nodiscard]] PreviewPicture picture(const PreviewShot& shot) const;

 private:
  struct Studio;
  std::unique_ptr<Studio> studio_;
};

}  // namespace collage
