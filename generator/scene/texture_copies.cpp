#include "scene/texture_copies.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <system_error>

#include "base/error.h"
#include "base/file.h"

namespace collage {
namespace {

using namespace std::string_view_literals;

constexpr std::uintmax_t largest_picture_bytes = std::uintmax_t{512} << 20;
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;

struct Mark {
  std::string_view first_bytes;
  std::string_view format;
};

constexpr std::array marks{Mark{"\x89PNG\r\n\x1a\n"sv, "png"sv},
                           Mark{"\xff\xd8\xff"sv, "jpeg"sv},
                           Mark{"GIF8"sv, "gif"sv},
                           Mark{"BM"sv, "bmp"sv},
                           Mark{"P6"sv, "ppm"sv},
                           Mark{"P3"sv, "ppm"sv},
                           Mark{"P5"sv, "pgm"sv},
                           Mark{"P2"sv, "pgm"sv},
                           Mark{"II*\0"sv, "tiff"sv},
                           Mark{"MM\0*"sv, "tiff"sv}};

std::string_view extension_of(std::string_view format) {
  return format == "jpeg" ? "jpg"sv : format == "tiff" ? "tif"sv : format;
}

/// An unsigned number of so many bytes; what is beyond the end counts as 0. `step` is 1 where the
/// most significant byte comes first, else -1.
std::uint64_t number_at(std::string_view content, std::size_t at, int bytes, int step) {
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) {
    const std::size_t place = at + static_cast<std::size_t>(step > 0 ? i : bytes - 1 - i);
    value = value << 8 | (place < content.size() ? static_cast<unsigned char>(content[place]) : 0);
  }
  return value;
}

/// Segments "FF type length …"; types C0 to CF but for three are frames.
std::uint64_t jpeg_pixels(std::string_view content) {
  const auto number = [&](std::size_t at, int bytes) { return number_at(content, at, bytes, 1); };
  for (std::size_t at = 2; at + 9 < content.size(); at += 2 + number(at + 2, 2)) {
    const std::uint64_t type = number(at + 1, 1);
    if (number(at, 1) != 0xff) {
      return 0;
    }
    if (type >= 0xc0 && type <= 0xcf && type != 0xc4 && type != 0xc8 && type != 0xcc) {
      return number(at + 5, 2) * number(at + 7, 2);
    }
  }
  return 0;
}

/// "P6", width and height between blanks and comments.
std::uint64_t pnm_pixels(std::string_view content) {
  const auto skip = [&content](std::size_t count) {
    content.remove_prefix(std::min(count, content.size()));
  };
  const auto skip_blanks = [&] { skip(content.find_first_not_of(" \t\r\n")); };
  std::uint64_t pixels = 1;
  skip(2);
  for (int side = 0; side < 2; ++side) {
    for (skip_blanks(); content.starts_with('#'); skip_blanks()) {
      skip(content.find('\n'));
    }
    std::uint32_t length = 0;
    const char* const start = content.data();
    const auto result = std::from_chars(start, start + content.size(), length);
    if (result.ec == std::errc::result_out_of_range) {
      length = std::numeric_limits<std::uint32_t>::max();
    }
    pixels *= length;
    skip(static_cast<std::size_t>(result.ptr - start));
  }
  return pixels;
}

}  // namespace

std::string_view picture_format(std::string_view content, const std::filesystem::path& name) {
  for (const Mark& mark : marks) {
    if (content.starts_with(mark.first_bytes)) {
      return mark.format;
    }
  }
  const std::string extension = name.extension().string();
  return extension == ".tga" || extension == ".TGA" ? "tga"sv : ""sv;
}

std::uint64_t claimed_pixels(std::string_view content, std::string_view format) {
  const auto big = [&](std::size_t at, int bytes) { return number_at(content, at, bytes, 1); };
  const auto little = [&](std::size_t at, int bytes) { return number_at(content, at, bytes, -1); };
  if (format == "png") {
    return big(16, 4) * big(20, 4);
  }
  if (format == "gif") {
    return little(6, 2) * little(8, 2);
  }
  if (format == "bmp") {
    const auto side = [&](std::size_t at) {  // a height below 0 counts from the top
      const auto value = static_cast<std::int32_t>(little(at, 4));
      return static_cast<std::uint64_t>(std::abs(std::int64_t{value}));
    };
    return side(18) * side(22);
  }
  if (format == "tga") {
    return little(12, 2) * little(14, 2);
  }
  if (format == "jpeg") {
    return jpeg_pixels(content);
  }
  return format == "ppm" || format == "pgm" ? pnm_pixels(content) : 0;
}

std::optional<std::string> TextureCopies::content_of(const std::filesystem::path& picture) {
  try {
    return read_file(picture, largest_picture_bytes);
  } catch (const Error& error) {
    status_.note(std::string(error.what()) + "; the material's colour is used");
    return std::nullopt;
  }
}

std::optional<TextureCopy> TextureCopies::add(const std::filesystem::path& picture) {
  const std::optional<std::string> content = content_of(picture);
  if (!content) {
    return std::nullopt;
  }
  const std::string_view format = picture_format(*content, picture);
  if (format.empty()) {
    status_.note(picture.string() + " is not a picture that POV-Ray reads (PNG, JPEG, GIF, TGA, " +
                 "BMP, PPM or TIFF); the material's colour is used");
    return std::nullopt;
  }
  if (claimed_pixels(*content, format) > most_pixels) {
    status_.note(picture.string() +
                 " claims more than 268 million pixels; the material's colour is used");
    return std::nullopt;
  }
  TextureCopy copy{
      "texture-" + std::to_string(by_hash_.size()) + "." + std::string(extension_of(format)),
      std::string(format)};
  const auto [known, is_new] = by_hash_.emplace(sha256(*content), std::move(copy));
  if (is_new) {
    write_file(folder_ / known->second.name, *content);
  }
  return known->second;
}

}  // namespace collage
