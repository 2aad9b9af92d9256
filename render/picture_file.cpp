#include "render/picture_file.h"

#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "base/error.h"
#include "base/file.h"
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

/// A PNG without its last chunk was cut short. libpng would say so on stderr.
bool is_cut_short(std::string_view bytes) {
  constexpr std::string_view first_bytes = "\x89PNG";
  constexpr std::string_view last_bytes = "IEND\xAE\x42\x60\x82";
  return bytes.starts_with(first_bytes) && !bytes.ends_with(last_bytes);
}

[[noreturn]] void throw_not_whole(const fs::path& path, const std::string& reason) {
  throw Error({path}, "is not a whole picture: " + reason, "make it again");
}

}  // namespace

Picture read_picture(const fs::path& path) {
  const std::string bytes = read_file(path);
  if (is_cut_short(bytes)) {
    throw_not_whole(path, "its end is missing");
  }
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
  const std::unique_ptr<OIIO::ImageInput> input =
      OIIO::ImageInput::open("picture" + path.extension().string(), nullptr, &memory);
  if (!input) {
    OIIO::geterror();  // it would speak of a file named "picture"
    throw Error({path}, "is not a picture that can be read", "name a PNG or EXR file");
  }
  const OIIO::ImageSpec& spec = input->spec();
  Picture picture;
  picture.width = spec.width;
  picture.height = spec.height;
  picture.channels = spec.nchannels;
  picture.format =
      std::string_view(input->format_name()) == "openexr" ? PictureFormat::exr : PictureFormat::png;
  picture.key = spec.get_string_attribute(key_name);
  picture.values.resize(picture.pixels() * static_cast<std::size_t>(picture.channels));
  if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, picture.values.data())) {
    throw_not_whole(path, input->geterror());
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
