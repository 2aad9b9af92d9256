#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "render/compare.h"
#include "render/picture_file.h"

namespace collage {

/// What OpenImageIO does for us. It stands in a library of its own, opened when the first picture
/// is read or written: OpenImageIO brings some 240 others, which take 0.4 s to load. Errors name
/// `path` and what is wrong with it.
class Imaging {
 public:
  virtual ~Imaging() = default;

  /// Throws where a picture is too large, before memory is taken for it.
  using SizeCheck = std::function<void(std::uint64_t pixels, int channels)>;
  /// The picture in a file's content.
  [[nodiscard]] virtual Picture decoded(std::string_view bytes, const std::filesystem::path& path,
                                        const SizeCheck& check_size) const = 0;
  /// The content of the file `path`: PNG, EXR or JPEG, as its extension says. With the picture's
  /// key as metadata and without date. A JPEG is of high quality, with its colours at full
  /// resolution.
  [[nodiscard]] virtual std::string encoded(const Picture& picture,
                                            const std::filesystem::path& path) const = 0;
  /// See thumbnail().
  [[nodiscard]] virtual Picture made_smaller(const Picture& picture, int side) const = 0;
  /// Of pictures with equal size and channels, all values finite.
  [[nodiscard]] virtual Comparison::Numbers compared(const Picture& reference,
                                                     const Picture& picture, double fail) const = 0;

  class Film {
   public:
    virtual ~Film() = default;
    /// All frames have the first one's size and channels.
    virtual void append(const Picture& frame) = 0;
    virtual void close() = 0;
  };
  /// Writes an animated GIF of so many frames to `file`; what goes wrong is said of `path`.
  [[nodiscard]] virtual std::unique_ptr<Film> film(const std::filesystem::path& file,
                                                   std::size_t frames, double frames_per_second,
                                                   const std::filesystem::path& path) const = 0;
};

/// Opens the library, which then stays open. Throws Error (outside program) where it cannot be
/// loaded. Safe to call from several threads.
const Imaging& imaging();

/// What the library exports under the name of `imaging_symbol`.
using ImagingFunction = const Imaging*();
inline constexpr const char* imaging_symbol = "collage_imaging";

}  // namespace collage
