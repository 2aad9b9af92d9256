#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "scene/composition.h"

namespace collage {

/// A picture for a surface's colour: linear-light RGB, rows from the top.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> texels;

  /// Bilinear, repeated all over; v counts from the bottom, as in OBJ.
  [[nodiscard]] glm::vec3 at(const dvec2& uv) const;
};

/// Reads a texture; nothing where it cannot be read.
using TextureReader = std::function<std::optional<Texture>(const std::filesystem::path&)>;

/// How a surface throws light back, as the macro Surface of templates/collage-finishes.inc has it.
struct Surface {
  glm::vec3 color{0.8F};
  glm::vec3 glow{0.0F};
  /// Share of the light thrown back all round.
  float body = 0.82F;
  /// Strength of the lamps' highlights, and how wide they are: 0.003 crisp, 0.1 broad.
  float shine = 0.1F;
  float shine_width = 0.09F;
  /// What is mirrored straight on and edge on (Schlick 1994).
  float mirror_facing = 0.0F;
  float mirror_edge = 0.0F;
  /// 1: highlights and mirror have the surface's colour.
  float metal = 0.0F;
  const Texture* texture = nullptr;
};

/// The surfaces of a composition: of its elements, then of its props. Glass and milk are shown as
/// if no light went through.
class SurfaceLooks {
 public:
  SurfaceLooks(const Composition& composition, const TextureReader& read_texture);
  SurfaceLooks(const SurfaceLooks&) = delete;
  SurfaceLooks& operator=(const SurfaceLooks&) = delete;

  [[nodiscard]] const Surface& of(std::uint32_t element, std::uint32_t triangle) const;

 private:
  struct Look {
    std::vector<Surface> surfaces;
    /// Of each triangle; nullptr: all have the first.
    const std::vector<std::uint32_t>* assignment = nullptr;
  };
  void append(const Composition::Element& element, std::size_t index,
              const TextureReader& read_texture);
  const Texture* texture(const Material& material, const Mesh& mesh,
                         const TextureReader& read_texture);

  std::vector<Look> looks_;
  std::map<std::filesystem::path, std::optional<Texture>> textures_;
};

}  // namespace collage
