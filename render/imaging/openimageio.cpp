#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <OpenImageIO/color.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include "base/error.h"
#include "render/imaging.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

const char* const key_name = "collage:key";

OIIO::ImageSpec file_spec(const Picture& picture, const fs::path& extension) {
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

OIIO::ImageSpec frame_spec(const Picture& frame, double frames_per_second) {
  OIIO::ImageSpec spec(frame.width, frame.height, frame.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:Movie", 1);
  spec.attribute("oiio:LoopCount", 0);
  const int rate[2] = {static_cast<int>(std::lround(frames_per_second * 1000)), 1000};
  spec.attribute("FramesPerSecond", OIIO::TypeRational, rate);
  return spec;
}

OIIO::ImageBuf wrapped(const Picture& picture) {
  return {OIIO::ImageSpec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::FLOAT),
          const_cast<float*>(picture.values.data())};
}

/// A picture as three linear channels; of a grey one the first thrice. Alpha is left out.
Picture linear_rgb(const Picture& picture) {
  Picture rgb = picture;
  rgb.channels = 3;
  rgb.values.resize(picture.pixels() * 3);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t pixel = 0; pixel < picture.pixels(); ++pixel) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = picture.values[pixel * channels + (channels < 3 ? 0 : c)];
      rgb.values[pixel * 3 + c] =
          picture.format == PictureFormat::png ? OIIO::sRGB_to_linear(value) : value;
    }
  }
  return rgb;
}

int scaled(int length, double scale) {
  return std::max(1, static_cast<int>(std::lround(length * scale)));
}

/// Reads from memory; OpenImageIO's own reader also reads what lies before it, where a damaged file
/// says so.
class Memory : public OIIO::Filesystem::IOProxy {
 public:
  explicit Memory(std::string_view bytes) : IOProxy("", Read), bytes_(bytes) {}

  [[nodiscard]] const char* proxytype() const override { return "memory"; }
  [[nodiscard]] std::size_t size() const override { return bytes_.size(); }
  std::size_t read(void* to, std::size_t size) override {
    const std::size_t done = pread(to, size, m_pos);
    m_pos += static_cast<std::int64_t>(done);
    return done;
  }
  std::size_t pread(void* to, std::size_t size, std::int64_t offset) override {
    if (offset < 0 || static_cast<std::uint64_t>(offset) >= bytes_.size()) {
      return 0;
    }
    return bytes_.copy(static_cast<char*>(to), size, static_cast<std::size_t>(offset));
  }

 private:
  std::string_view bytes_;
};

class Gif : public Imaging::Film {
 public:
  Gif(const fs::path& file, std::size_t frames, double frames_per_second, const fs::path& path)
      : file_(file.string()), path_(path), frames_(frames), frames_per_second_(frames_per_second) {
    check(writer_ != nullptr);
  }

  void append(const Picture& frame) override {
    const OIIO::ImageSpec spec = frame_spec(frame, frames_per_second_);
    if (specs_.empty()) {
      specs_.assign(frames_, spec);
      check(writer_->open(file_, static_cast<int>(frames_), specs_.data()));
    } else {
      check(writer_->open(file_, spec, OIIO::ImageOutput::AppendSubimage));
    }
    check(writer_->write_image(OIIO::TypeDesc::FLOAT, frame.values.data()));
  }

  void close() override { check(writer_->close()); }

 private:
  void check(bool is_done) const {
    if (!is_done) {
      throw Error({path_},
                  "cannot be written: " + (writer_ ? writer_->geterror() : OIIO::geterror()),
                  "check the folder's permissions and free space");
    }
  }

  std::string file_;
  fs::path path_;
  std::size_t frames_;
  double frames_per_second_;
  std::unique_ptr<OIIO::ImageOutput> writer_ = OIIO::ImageOutput::create("film.gif");
  std::vector<OIIO::ImageSpec> specs_;
};

class OpenImageIo : public Imaging {
 public:
  /// OpenEXR's core, as its older reader takes as much memory as a damaged header claims.
  OpenImageIo() { OIIO::attribute("openexr:core", 1); }

  [[nodiscard]] Picture decoded(std::string_view bytes, const fs::path& path,
                                const SizeCheck& check_size) const override {
    Memory memory(bytes);
    // One reader alone: else all that OpenImageIO knows would try it in turn.
    const bool is_png = OIIO::Strutil::iequals(path.extension().string(), ".png");
    const bool is_exr = OIIO::Strutil::iequals(path.extension().string(), ".exr");
    const std::string type = is_png ? "png" : "openexr";
    const std::unique_ptr<OIIO::ImageInput> input =
        is_png || is_exr ? OIIO::ImageInput::create(type) : nullptr;
    OIIO::ImageSpec spec;
    if (!input || !input->set_ioproxy(&memory) || !input->open(type, spec)) {
      OIIO::geterror();  // else it would come up elsewhere
      throw Error({path}, "is not a picture that can be read", "name a PNG or EXR file");
    }
    check_size(spec.image_pixels(), spec.nchannels);
    Picture picture;
    picture.width = spec.width;
    picture.height = spec.height;
    picture.channels = spec.nchannels;
    picture.format = is_exr ? PictureFormat::exr : PictureFormat::png;
    picture.key = spec.get_string_attribute(key_name);
    picture.values.resize(picture.pixels() * static_cast<std::size_t>(picture.channels));
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, picture.values.data())) {
      const std::string reason = input->geterror();
      throw Error({path}, "is not a whole picture: " + reason.substr(0, reason.find('\n')),
                  "make it again");
    }
    return picture;
  }

  [[nodiscard]] std::string encoded(const Picture& picture, const fs::path& path) const override {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string type = "picture" + path.extension().string();
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(type, &memory);
    const bool is_made = output && output->open(type, file_spec(picture, path.extension())) &&
                         output->write_image(OIIO::TypeDesc::FLOAT, picture.values.data()) &&
                         output->close();
    if (!is_made) {
      throw Error({path}, "cannot be written: " + (output ? output->geterror() : OIIO::geterror()),
                  "choose .png or .exr and a smaller picture");
    }
    return {bytes.begin(), bytes.end()};
  }

  [[nodiscard]] Picture made_smaller(const Picture& picture, int side) const override {
    Picture result = linear_rgb(picture);
    const double scale = static_cast<double>(side) / std::max(picture.width, picture.height);
    if (scale < 1.0) {
      Picture small;
      small.width = scaled(picture.width, scale);
      small.height = scaled(picture.height, scale);
      small.values.resize(small.pixels() * 3);
      OIIO::ImageBuf to = wrapped(small);
      OIIO::ImageBufAlgo::resize(to, wrapped(result), "lanczos3");
      result = std::move(small);
    }
    for (float& value : result.values) {
      value = OIIO::linear_to_sRGB(std::clamp(value, 0.0F, 1.0F));  // lanczos3 may overshoot
    }
    result.format = PictureFormat::png;
    result.key.clear();
    return result;
  }

  [[nodiscard]] Comparison::Numbers compared(const Picture& reference, const Picture& picture,
                                             double fail) const override {
    const auto threshold = static_cast<float>(fail);
    const OIIO::ImageBufAlgo::CompareResults result =
        OIIO::ImageBufAlgo::compare(wrapped(reference), wrapped(picture), threshold, threshold);
    Comparison::Numbers numbers;
    numbers.mean_error = result.meanerror;
    numbers.max_error = result.maxerror;
    numbers.max_x = result.maxx;
    numbers.max_y = result.maxy;
    if (result.maxerror > 0.0) {
      numbers.psnr_decibels = result.PSNR;
    }
    numbers.failing_pixels = static_cast<long long>(result.nfail);
    numbers.pixels = static_cast<long long>(reference.pixels());
    return numbers;
  }

  [[nodiscard]] std::unique_ptr<Film> film(const fs::path& file, std::size_t frames,
                                           double frames_per_second,
                                           const fs::path& path) const override {
    return std::make_unique<Gif>(file, frames, frames_per_second, path);
  }
};

}  // namespace
}  // namespace collage

extern "C" __attribute__((visibility("default"))) const collage::Imaging* collage_imaging() {
  static const collage::OpenImageIo library;
  return &library;
}
