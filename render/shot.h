#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace collage {

/// Where the camera stands. Azimuth 0 looks at the front; positive moves the camera to the right.
struct View {
  std::string name;
  double azimuth_degrees = 0.0;
  double elevation_degrees = 0.0;  // above the horizon
};

/// "front", "back", "left", "right", "top", "three-quarter", or azimuth and elevation in degrees as
/// "30/15" (elevation -90 to 90). Throws Error for anything else.
View parse_view(const std::string& text);

/// The view's name as part of a file name: "front", "30_15".
std::string file_stem(const View& view);

/// What the templates make of it: more lamps, more of the reflections. Ours give equal pixels on
/// any number of threads; a template with radiosity would not.
enum class Quality { draft, standard, fine };
/// "draft", "standard", "fine". Throws Error for anything else.
Quality parse_quality(const std::string& text);

/// 8 bits a channel, sRGB-encoded; or half floats, linear.
enum class PictureFormat { png, exr };

/// One picture of a scene.
struct Shot {
  View view;
  /// The template's name, such as "studio"; `template` is a C++ keyword.
  std::string look = "studio";
  int width = 1280;
  int height = 960;
  Quality quality = Quality::draft;
  /// Share of the instances shown, in order of placement; above 0, at most 1.
  double stage = 1.0;
  /// Index of the one element shown; nullopt: all.
  std::optional<int> only_element;
  /// What has room in the picture: the sculpture as this view shows it, or as it turns all round,
  /// so that the pictures of all azimuths show it in one size and place.
  enum class Framing { view, all_round } framing = Framing::view;
  PictureFormat format = PictureFormat::png;
};

/// Throws Error where the folder has no such template, or a number is out of its range.
void check_shot(const Shot& shot, const std::filesystem::path& folder);

/// The text of the job file: declares what the shot chooses and includes scene.pov.
std::string job_text(const Shot& shot);

/// POV-Ray's options for size, format, bounding and antialiasing. Jitter is always off, so that
/// equal input gives equal pixels. +SU looks into the unions in which instances lie, without which
/// a picture takes three times as long. +BM1 takes less time than the trees of +BM2: chains a
/// third, most sculptures a tenth; only chairs a twentieth more.
std::vector<std::string> povray_options(const Shot& shot);

/// ".png" or ".exr".
std::string extension(PictureFormat format);

}  // namespace collage
