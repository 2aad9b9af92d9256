#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/letters.h"
#include "geometry/mesh_check.h"
#include "packing/options.h"
#include "scene/finish.h"

namespace collage {

/// What a scene file says, with defaults filled in. Names, units, ranges and meaning of every key
/// stand in the options table (options_table.h); paths are resolved against the scene's folder.
struct Scene {
  struct Target {
    /// Exactly one of the three is set; letters by their string.
    std::filesystem::path mesh;
    std::filesystem::path sdf;
    LetterOptions text;
    Repair repair = Repair::full;
    int resolution = 100;
    double jitter = 0.5;
  };
  struct Element {
    /// Exactly one of the two is set; letters by their string.
    std::filesystem::path mesh;
    LetterOptions text;
    Repair repair = Repair::full;
    std::vector<double> scales{1.0};
    double weight = 1.0;
    double left = 0.0;
    double right = 1.0;
    /// "#rrggbb" in sRGB; empty: the mesh file's materials.
    std::string color;
    Finish finish = Finish::automatic;

    /// For people.
    [[nodiscard]] std::string name() const {
      return text.string.empty() ? mesh.stem().string() : text.string;
    }
  };
  struct Render {
    /// The template: one of ours by name, "studio", or the path of the user's .inc file.
    /// (`template` is a C++ keyword.)
    std::string look = "studio";
    std::array<int, 2> size{1280, 960};
    std::vector<std::string> stills{"front", "three-quarter"};
    std::string quality = "fine";
    bool exr = false;
    /// Paths of mesh files.
    std::vector<std::string> props;
  };
  struct Turntable {
    /// 0: no turntable.
    int frames = 0;
    std::array<int, 2> size{640, 480};
    std::string quality = "draft";
    double elevation_degrees = 15.0;
    double frames_per_second = 12.0;
  };
  struct ContactSheet {
    int columns = 6;
    /// Assembly stages shown, as shares of the number of instances; empty: no such sheet.
    std::vector<double> stages;
    std::string quality = "draft";
    /// Size of one picture on the sheet.
    std::array<int, 2> size{480, 360};
  };

  std::string name;
  /// The scene file itself.
  std::filesystem::path file;
  Target target;
  std::vector<Element> elements;
  PackingOptions packing;
  Render render;
  Turntable turntable;
  ContactSheet contact_sheet;
};

}  // namespace collage
