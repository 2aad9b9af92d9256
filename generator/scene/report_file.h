#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace collage {

/// What a run came to: the columns of Muhm 2011, Tables I and II.
struct Report {
  struct Element {
    std::string name;
    std::uint64_t faces = 0;
    std::uint64_t instances = 0;
  };
  /// Wall time. `prepare`: reading the meshes and the first distances; `place`: choosing and
  /// turning elements; `update`: the distances to each new instance.
  struct Seconds {
    double prepare = 0.0;
    double place = 0.0;
    double update = 0.0;
    double write = 0.0;
    double render = 0.0;
  };

  std::uint64_t seed = 0;
  /// As Sculpture::stopped.
  std::optional<std::string> stopped{};
  std::uint64_t instances = 0;
  /// Shares of the target, 0 to 1: by the volumes of the meshes, of the voxels inside it, and by
  /// the volumes of the smallest spheres round the instances.
  double fill = 0.0;
  double fill_by_voxels = 0.0;
  double fill_by_spheres = 0.0;
  /// Radius as a fraction of the target's longest side.
  double largest_hole = 0.0;
  std::array<std::uint64_t, 3> voxels{};
  Seconds seconds;
  std::vector<Element> elements;
};

/// Writes report.json, whole or not at all, with the fields' names as above. Throws Error where it
/// cannot be written.
void write_report(const std::filesystem::path& path, const Report& report);

/// Reads what write_report() wrote, as for adding the seconds of the render stage. Throws Error
/// that names the JSON path of what is wrong.
Report read_report(const std::filesystem::path& path);

/// The report as a table for the terminal, several lines.
std::string report_text(const Report& report);

}  // namespace collage
