#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "render/picture_file.h"

namespace collage {

/// Writes lines of text into pictures, in DejaVu Sans. Text is UTF-8; what the font has not, or
/// what is no UTF-8, shows as a box.
class Lettering {
 public:
  /// `size`: height of the font in pixels, ≥ 1. Throws Error naming the Debian package where the
  /// font is missing.
  explicit Lettering(int size);
  ~Lettering();
  Lettering(Lettering&&) noexcept;
  Lettering& operator=(Lettering&&) noexcept;

  /// In pixels.
  [[nodiscard]] int width(std::string_view text) const;
  /// The text, or as much of its start as is no wider than `width` pixels with "…" behind it.
  [[nodiscard]] std::string fitted(std::string_view text, int width) const;
  /// Writes from `left` on the line `baseline`, in a grey of 0 to 1; what falls outside is cut off.
  void write(Picture& picture, int left, int baseline, std::string_view text, float grey) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace collage
