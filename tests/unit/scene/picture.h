#pragma once

#include <array>
#include <string>

namespace collage::testing {

/// A small picture of the world's plane z = 0, 4 units wide and 3 high round the origin.
struct Picture {
  int width = 0;
  int height = 0;
  std::string pixels;

  /// "red", "green", … of the pixel at a point of the world's plane z = 0.
  [[nodiscard]] std::string color_at(double x, double y) const {
    const int column = static_cast<int>((x + 2.0) / 4.0 * width);
    const int row = static_cast<int>((1.5 - y) / 3.0 * height);
    const auto channel = [&](int c) {
      return static_cast<unsigned char>(
                 pixels.at(static_cast<std::size_t>(3 * (row * width + column) + c))) > 128;
    };
    constexpr std::array names{"black", "blue",    "green",  "cyan",
                               "red",   "magenta", "yellow", "white"};
    return names[(channel(0) ? 4U : 0U) + (channel(1) ? 2U : 0U) + (channel(2) ? 1U : 0U)];
  }
};

/// POV-Ray's PPM of the size that rendered() asks for; its header is of any length.
inline Picture parsed_ppm(const std::string& text) {
  Picture picture{64, 48, {}};
  picture.pixels = text.substr(text.size() - 3 * 64 * 48);
  return picture;
}

}  // namespace collage::testing
