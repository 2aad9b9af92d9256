#include "render/picture_file.h"

#include <cstdint>

#include <zlib.h>

#include "base/error.h"
#include "base/file.h"
#include "base/memory.h"
#include "render/imaging.h"
#include "render/scratch.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::uint32_t big_endian(std::string_view four_bytes) {
  std::uint32_t value = 0;
  for (const char c : four_bytes) {
    value = value << 8 | static_cast<unsigned char>(c);
  }
  return value;
}

/// What is wrong with the chunks of a PNG, "length type data CRC" each (ISO/IEC 15948, 5.3); "" for
/// nothing, or another format. libpng would say it on stderr.
std::string flaw_in_chunks(std::string_view bytes) {
  constexpr std::string_view first_bytes = "\x89PNG\r\n\x1a\n";
  constexpr std::size_t frame = 12;  // a chunk without data
  if (!bytes.starts_with(first_bytes)) {
    return "";
  }
  bytes.remove_prefix(first_bytes.size());
  while (bytes.size() >= frame && big_endian(bytes.substr(0, 4)) <= bytes.size() - frame) {
    const std::size_t length = big_endian(bytes.substr(0, 4));
    const std::string_view content = bytes.substr(4, 4 + length);
    const auto* const start = reinterpret_cast<const Bytef*>(content.data());
    if (crc32_z(0, start, content.size()) != big_endian(bytes.substr(8 + length, 4))) {
      return "it is damaged";
    }
    if (content == "IEND") {
      return "";
    }
    bytes.remove_prefix(frame + length);
  }
  return "its end is missing";
}

}  // namespace

Picture read_picture(const fs::path& path) {
  const std::string bytes = read_file(path);
  if (const std::string flaw = flaw_in_chunks(bytes); !flaw.empty()) {
    throw Error({path}, "is not a whole picture: " + flaw, "make it again");
  }
  return imaging().decoded(bytes, path, [&path](std::uint64_t pixels, int channels) {
    constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;
    if (pixels > most_pixels) {
      throw Error({path}, "has more than 2^28 pixels", "use a smaller picture");
    }
    require_memory(pixels * static_cast<std::uint64_t>(channels) * sizeof(float), path.string(),
                   "its size");
  });
}

void write_picture(const fs::path& path, const Picture& picture) {
  if (path.extension() != extension(picture.format)) {
    throw Error({path}, "is not the name of such a picture",
                "let it end in " + extension(picture.format));
  }
  const std::string bytes = imaging().encoded(picture, path);
  const Scratch scratch(path.has_parent_path() ? path.parent_path() : fs::path("."));
  write_file(scratch.path(".part"), bytes);
  move_into_place(scratch.path(".part"), path);
}

}  // namespace collage
