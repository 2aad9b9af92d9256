#include "render/picture_file.h"

#include <cstdint>
#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <zlib.h>

#include "base/error.h"
#include "base/file.h"
#include "base/memory.h"
#include "render/scratch.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

const char* const key_name = "collage:key";

OIIO::ImageSpec spec_of(const Picture& picture, const fs::path& extension) {
  const bool is_exr = extension == ".exr";
  OIIO::ImageSpec spec(picture.width, picture.height, picture.channels,
                       is_exr ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", is_exr ? "Linear" : "sRGB");
  spec.attribute("Software", "collage");
  if (is_exr) {
    spec.attribute("DateTime", "");  // else OpenImageIO puts in the time of writing
  }
  if (!picture.key.empty()) {
    spec.attribute(key_name, picture.key);
  }
  if (extension == ".jpg") {
    spec.attribute("Compression", "jpeg:90");
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  return spec;
}

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

/// Before memory is taken for what a picture claims to hold.
void check_size(const fs::path& path, const OIIO::ImageSpec& spec) {
  constexpr OIIO::imagesize_t most_pixels = OIIO::imagesize_t{1} << 28;
  if (spec.image_pixels() > most_pixels) {
    throw Error({path}, "has more than 2^28 pixels", "use a smaller picture");
  }
  require_memory(spec.image_pixels() * spec.nchannels * sizeof(float), path.string(), "its size");
}

[[noreturn]] void throw_not_whole(const fs::path& path, const std::string& reason) {
  throw Error({path}, "is not a whole picture: " + reason, "make it again");
}

}  // namespace

Picture read_picture(const fs::path& path) {
  const std::string bytes = read_file(path);
  if (const std::string flaw = flaw_in_chunks(bytes); !flaw.empty()) {
    throw_not_whole(path, flaw);
  }
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
  const std::unique_ptr<OIIO::ImageInput> input =
      OIIO::ImageInput::open("picture" + path.extension().string(), nullptr, &memory);
  if (!input) {
    OIIO::geterror();  // it would speak of a file named "picture"
    throw Error({path}, "is not a picture that can be read", "name a PNG or EXR file");
  }
  const OIIO::ImageSpec& spec = input->spec();
  check_size(path, spec);
  Picture picture;
  picture.width = spec.width;
  picture.height = spec.height;
  picture.channels = spec.nchannels;
  picture.format =
      std::string_view(input->format_name()) == "openexr" ? PictureFormat::exr : PictureFormat::png;
  picture.key = spec.get_string_attribute(key_name);
  picture.values.resize(picture.pixels() * static_cast<std::size_t>(picture.channels));
  if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, picture.values.data())) {
    const std::string reason = input->geterror();
    throw_not_whole(path, reason.substr(0, reason.find('\n')));
  }
  return picture;
}

std::string picture_bytes(const fs::path& path, const Picture& picture) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::string type = "picture" + path.extension().string();
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(type, &memory);
  const bool is_made = output && output->open(type, spec_of(picture, path.extension())) &&
                       output->write_image(OIIO::TypeDesc::FLOAT, picture.values.data()) &&
                       output->close();
  if (!is_made) {
    throw Error({path}, "cannot be written: " + (output ? output->geterror() : OIIO::geterror()),
                "choose .png or .exr and a smaller picture");
  }
  return {bytes.begin(), bytes.end()};
}

void write_picture(const fs::path& path, const Picture& picture) {
  if (path.extension() != extension(picture.format)) {
    throw Error({path}, "is not the name of such a picture",
                "let it end in " + extension(picture.format));
  }
  const std::string bytes = picture_bytes(path, picture);
  const Scratch scratch(path.has_parent_path() ? path.parent_path() : fs::path("."));
  write_file(scratch.path(".part"), bytes);
  move_into_place(scratch.path(".part"), path);
}

}  // namespace collage
