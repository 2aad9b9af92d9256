#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/status.h"
#include "render/shot.h"

namespace collage {

/// The floor's shadows for POV-Ray, which would trace them itself before each picture, in one
/// thread and many times as slowly. Holds what the last picture was made from; folders may change.
class TracedShadows {
 public:
  explicit TracedShadows(Status& status);
  ~TracedShadows();
  TracedShadows(TracedShadows&&) noexcept;
  TracedShadows& operator=(TracedShadows&&) noexcept;

  /// The declaration of Given_Shadow for templates/collage-floor.inc. Empty where `shot` has a
  /// template of the user's own, or the folder's scene.pov is not the one that was written with its
  /// sculpture.json: POV-Ray then traces what is really there.
  /// On all threads. Cost: reading the folder, once; 70,000 to 290,000 rays.
  std::string declaration(const std::filesystem::path& folder, const Shot& shot);

 private:
  struct Folder;
  Status* status_;
  std::unique_ptr<Folder> folder_;
};

}  // namespace collage
