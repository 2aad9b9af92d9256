#include "render/shot.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/text.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

struct NamedView {
  const char* name;
  double azimuth_degrees;
  double elevation_degrees;
};

/// A little above the horizon, as one looks at a thing on a table.
constexpr std::array named_views = {
    NamedView{"front", 0, 10},  NamedView{"back", 180, 10}, NamedView{"left", -90, 10},
    NamedView{"right", 90, 10}, NamedView{"top", 0, 89},    NamedView{"three-quarter", 35, 20},
};

/// Of the templates that others include: they make no picture by themselves.
constexpr const char* shared_prefix = "collage";

constexpr std::array quality_names = {"draft", "standard", "fine"};

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = result.ec == std::errc() && result.ptr == text.data() + text.size();
  return is_number && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<View> view_by_angles(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) {
    return std::nullopt;
  }
  const auto azimuth = number_in(std::string_view(text).substr(0, slash));
  const auto elevation = number_in(std::string_view(text).substr(slash + 1));
  if (!azimuth || !elevation || std::abs(*azimuth) > 360 || std::abs(*elevation) > 90) {
    return std::nullopt;
  }
  return View{text, *azimuth, *elevation};
}

/// Only names that mean nothing to POV-Ray's parser.
bool is_plain(const std::string& name) {
  return std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
}

std::vector<std::string> templates_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".inc" && !name.starts_with(shared_prefix) && is_plain(name)) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

void append_declare(std::string& text, const char* name, double value) {
  text += std::string("#declare ") + name + " = " + number_text(value) + ";\n";
}

}  // namespace

View parse_view(const std::string& text) {
  std::vector<std::string> names;
  for (const NamedView& view : named_views) {
    if (view.name == text) {
      return {text, view.azimuth_degrees, view.elevation_degrees};
    }
    names.emplace_back(view.name);
  }
  if (const std::optional<View> view = view_by_angles(text)) {
    return *view;
  }
  const std::string guess = did_you_mean(text, names);
  throw Error("there is no view '" + text + "'",
              guess.empty() ? "views are front, back, left, right, top, three-quarter, or "
                              "azimuth/elevation in degrees such as 30/15 (elevation -90 to 90)"
                            : guess);
}

std::string file_stem(const View& view) {
  std::string stem = view.name;
  std::ranges::replace(stem, '/', '_');
  return stem;
}

Quality parse_quality(const std::string& text) {
  const auto* const found = std::ranges::find(quality_names, text);
  if (found == quality_names.end()) {
    const std::string guess = did_you_mean(text, quality_names);
    throw Error("there is no quality '" + text + "'",
                guess.empty() ? "choose draft, standard or fine" : guess);
  }
  return static_cast<Quality>(found - quality_names.begin());
}

void check_shot(const Shot& shot, const fs::path& folder) {
  const std::vector<std::string> templates = templates_in(folder);
  if (!std::ranges::binary_search(templates, shot.look)) {
    const std::string guess = did_you_mean(shot.look, templates);
    throw Error({folder}, "there is no template '" + shot.look + "'",
                guess.empty() ? "choose one of the .inc files there, without its ending" : guess);
  }
  constexpr int largest_side = 32768;
  if (std::min(shot.width, shot.height) < 1 || std::max(shot.width, shot.height) > largest_side) {
    throw Error("a picture of " + std::to_string(shot.width) + " x " + std::to_string(shot.height) +
                    " pixels cannot be made",
                "choose sides of 1 to 32768 pixels");
  }
  if (!(shot.stage > 0.0 && shot.stage <= 1.0)) {
    throw Error("a stage is a share of the instances, not " + std::to_string(shot.stage),
                "choose a number above 0, at most 1");
  }
  if (shot.only_element && *shot.only_element < 0) {
    throw Error("there is no element " + std::to_string(*shot.only_element),
                "elements count from 0");
  }
}

std::string job_text(const Shot& shot) {
  std::string text = "#version 3.7;\n";
  append_declare(text, "Azimuth", shot.view.azimuth_degrees);
  append_declare(text, "Elevation", shot.view.elevation_degrees);
  append_declare(text, "Quality", static_cast<int>(shot.quality));
  append_declare(text, "Stage", shot.stage);
  append_declare(text, "Only_Element", shot.only_element.value_or(-1));
  append_declare(text, "All_Round", shot.framing == Shot::Framing::all_round ? 1 : 0);
  text += "#declare Template = \"" + shot.look + ".inc\";\n";
  return text + "#include \"scene.pov\"\n";
}

std::vector<std::string> povray_options(const Shot& shot) {
  std::vector<std::string> options = {"+W" + std::to_string(shot.width),
                                      "+H" + std::to_string(shot.height),
                                      shot.format == PictureFormat::exr ? "+FE" : "+FN",
                                      "-D",
                                      "-J",
                                      "+SU",
                                      "+BM1",
                                      "-GA"};
  if (shot.quality == Quality::draft) {
    options.insert(options.end(), {"+A0.3", "+AM2", "+R1"});
  } else {
    options.insert(options.end(), {"+A0.5", "+AM2", "+R2"});
  }
  return options;
}

std::string extension(PictureFormat format) {
  return format == PictureFormat::exr ? ".exr" : ".png";
}

}  // namespace collage
