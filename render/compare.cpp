#include "render/compare.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/text.h"
#include "render/imaging.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::string size_text(const Picture& picture) {
  return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

bool has_same_shape(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels;
}

long long values_not_finite(const Picture& picture) {
  return std::ranges::count_if(picture.values, [](float value) { return !std::isfinite(value); });
}

/// Why the two cannot be compared value by value, or "".
std::string misfit(const Picture& reference, const Picture& picture) {
  if (reference.width != picture.width || reference.height != picture.height) {
    return "the reference has " + size_text(reference) + " pixels, the picture " +
           size_text(picture);
  }
  if (reference.channels != picture.channels) {
    return "the reference has " + std::to_string(reference.channels) + " channels, the picture " +
           std::to_string(picture.channels);
  }
  if (reference.format != picture.format) {
    return "one is sRGB-encoded (PNG), the other linear (EXR)";
  }
  const long long in_reference = values_not_finite(reference);
  const long long in_picture = values_not_finite(picture);
  if (in_reference + in_picture > 0) {
    return std::to_string(in_reference) + " values of the reference and " +
           std::to_string(in_picture) + " of the picture are infinite or not a number";
  }
  return "";
}

std::string number(double value) { return fmt::format("{:.4g}", value); }

Comparison judged(const Comparison::Numbers& numbers, const Thresholds& thresholds) {
  const auto allowed = static_cast<long long>(
      std::floor(thresholds.failing_share * static_cast<double>(numbers.pixels)));
  if (numbers.max_error > thresholds.hard_fail) {
    return {Verdict::differs,
            "pixel " + std::to_string(numbers.max_x) + ", " + std::to_string(numbers.max_y) +
                " differs by " + number(numbers.max_error) + "; at most " +
                number(thresholds.hard_fail) + " is allowed",
            numbers};
  }
  const std::string failing = grouped(static_cast<std::uint64_t>(numbers.failing_pixels)) + " of " +
                              grouped(static_cast<std::uint64_t>(numbers.pixels)) +
                              " pixels differ by more than " + number(thresholds.fail) +
                              "; at most " + grouped(static_cast<std::uint64_t>(allowed)) + " may";
  const bool is_within = numbers.failing_pixels <= allowed;
  return {is_within ? Verdict::within_tolerance : Verdict::differs, failing, numbers};
}

/// Equal alpha would make the difference invisible.
void make_opaque(Picture& picture) {
  const auto channels = static_cast<std::size_t>(picture.channels);
  if (channels == 2 || channels == 4) {
    for (std::size_t i = channels - 1; i < picture.values.size(); i += channels) {
      picture.values[i] = 1.0F;
    }
  }
}

}  // namespace

Comparison compare_pictures(const fs::path& reference_path, const fs::path& picture_path,
                            const Thresholds& thresholds) {
  Picture reference = read_picture(reference_path);
  Picture picture = read_picture(picture_path);
  if (std::string reason = misfit(reference, picture); !reason.empty()) {
    return {Verdict::differs, std::move(reason), std::nullopt};
  }
  const Comparison::Numbers numbers = imaging().compared(reference, picture, thresholds.fail);
  if (reference.values == picture.values) {
    return {Verdict::same, "all pixels are equal", numbers};
  }
  return judged(numbers, thresholds);
}

void write_difference(const fs::path& reference_path, const fs::path& picture_path,
                      const fs::path& output, double amplification) {
  const Picture reference = read_picture(reference_path);
  Picture difference = read_picture(picture_path);
  if (!has_same_shape(reference, difference)) {
    throw Error({picture_path}, "differs from its reference in size or channels",
                "there is no difference picture of the two");
  }
  std::ranges::transform(reference.values, difference.values, difference.values.begin(),
                         [&](float a, float b) {
                           const double amplified = std::abs(double{a} - b) * amplification;
                           return std::isfinite(amplified) ? static_cast<float>(amplified) : 1.0F;
                         });
  make_opaque(difference);
  difference.format = PictureFormat::png;
  difference.key.clear();
  write_picture(output, difference);
}

}  // namespace collage
