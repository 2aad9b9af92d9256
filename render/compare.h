#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace collage {

/// When two pictures that are not equal still pass, in values of 0 to 1 as the files store them
/// (sRGB-encoded in a PNG). The defaults are those of OpenImageIO's own test suite.
struct Thresholds {
  /// A pixel fails where one of its channels differs by more.
  double fail = 0.004;
  /// This share of the pixels may fail.
  double failing_share = 0.0002;
  /// No pixel may differ by more.
  double hard_fail = 0.012;
};

enum class Verdict { same, within_tolerance, differs };

struct Comparison {
  Verdict verdict = Verdict::differs;
  /// One line for people: "3 of 3,072 pixels differ by more than 0.004; at most 0 may".
  std::string reason;

  /// What was measured; nullopt where the pictures cannot be laid over each other (another size,
  /// other channels) or hold a value that is not a number.
  struct Numbers {
    double mean_error = 0.0;
    double max_error = 0.0;
    int max_x = 0;  // where, in pixels from the upper left
    int max_y = 0;
    /// nullopt: the pixels are equal.
    std::optional<double> psnr_decibels;
    long long failing_pixels = 0;
    long long pixels = 0;
  };
  std::optional<Numbers> numbers;
};

/// Lays a picture over its reference. In this order: both are read (throws Error where one is
/// missing or cut short); size; channels; encoding; not-a-number or infinite values in either,
/// which differ even where both have them; equal pixels; thresholds.
Comparison compare_pictures(const std::filesystem::path& reference,
                            const std::filesystem::path& picture,
                            const Thresholds& thresholds = {});

/// Writes |reference - picture| · amplification as a PNG. Throws Error where they differ in size or
/// channels.
void write_difference(const std::filesystem::path& reference, const std::filesystem::path& picture,
                      const std::filesystem::path& output, double amplification = 16.0);

}  // namespace collage
