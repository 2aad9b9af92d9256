#include "scene/report_file.h"

#include <algorithm>
#include <cstdio>

#include "base/file.h"
#include "base/text.h"
#include "scene/json_reader.h"
#include "scene/json_text.h"

namespace collage {
namespace {

using json_reader::json;
using json_reader::natural;
using json_reader::number;
using json_reader::text;
using json_reader::within;
namespace fs = std::filesystem;

std::string elements_json(const std::vector<Report::Element>& elements) {
  std::string lines;
  for (const Report::Element& element : elements) {
    lines += (lines.empty() ? "\n" : ",\n");
    lines += "    {\"name\": " + json_text(element.name) +
             ", \"faces\": " + std::to_string(element.faces) +
             ", \"instances\": " + std::to_string(element.instances) + "}";
  }
  return "[" + lines + "\n  ]";
}

std::string seconds_json(const Report::Seconds& seconds) {
  return "{\"prepare\": " + number_text(seconds.prepare) +
         ", \"place\": " + number_text(seconds.place) +
         ", \"update\": " + number_text(seconds.update) +
         ", \"write\": " + number_text(seconds.write) +
         ", \"render\": " + number_text(seconds.render) + "}";
}

Report::Seconds seconds(const json& value) {
  return {within(value, "prepare", number), within(value, "place", number),
          within(value, "update", number), within(value, "write", number),
          within(value, "render", number)};
}

Report::Element element(const json& value) {
  return {within(value, "name", text), within(value, "faces", natural),
          within(value, "instances", natural)};
}

std::array<std::uint64_t, 3> voxels(const json& value) {
  if (!value.is_array() || value.size() != 3) {
    throw json_reader::Problem{"", "is not a list of 3 numbers"};
  }
  return {natural(value[0]), natural(value[1]), natural(value[2])};
}

Report report(const json& root) {
  Report result;
  result.seed = within(root, "seed", natural);
  if (root.contains("stopped")) {
    result.stopped = within(root, "stopped", text);
  }
  result.instances = within(root, "instances", natural);
  result.fill = within(root, "fill", number);
  result.fill_by_voxels = within(root, "fill_by_voxels", number);
  result.fill_by_spheres = within(root, "fill_by_spheres", number);
  result.largest_hole = within(root, "largest_hole", number);
  result.voxels = within(root, "voxels", voxels);
  result.seconds = within(root, "seconds", seconds);
  within(root, "elements", [&](const json& list) {
    json_reader::for_each_item(list,
                               [&](const json& item) { result.elements.push_back(element(item)); });
  });
  return result;
}

std::string rounded(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string percent(double share) { return rounded(100.0 * share, 2) + " %"; }

std::string left(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

/// A name from a file must not move the terminal's cursor.
std::string harmless(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return name;
}

std::string elements_text(const Report& report) {
  std::size_t width = 9;
  for (const Report::Element& element : report.elements) {
    width = std::max(width, element.name.size() + 2);
  }
  const auto row = [&](const std::string& name, const std::string& faces,
                       const std::string& instances, const std::string& placed_faces) {
    return left(name, width) + right(faces, 10) + right(instances, 12) + right(placed_faces, 14) +
           "\n";
  };
  std::string lines = row("element", "faces", "instances", "faces in all");
  std::uint64_t placed_faces = 0;
  for (const Report::Element& element : report.elements) {
    const std::uint64_t faces = element.faces * element.instances;
    lines += row(harmless(element.name), grouped(element.faces), grouped(element.instances),
                 grouped(faces));
    placed_faces += faces;
  }
  return lines + row("all", "", grouped(report.instances), grouped(placed_faces));
}

std::string line(const char* name, const std::string& value) {
  return left(name, 24) + value + "\n";
}

}  // namespace

void write_report(const fs::path& path, const Report& report) {
  write_file(path, "{\n  \"seed\": " + std::to_string(report.seed) +
                       stopped_members(report.stopped) +
                       ",\n  \"instances\": " + std::to_string(report.instances) +
                       ",\n  \"fill\": " + number_text(report.fill) +
                       ",\n  \"fill_by_voxels\": " + number_text(report.fill_by_voxels) +
                       ",\n  \"fill_by_spheres\": " + number_text(report.fill_by_spheres) +
                       ",\n  \"largest_hole\": " + number_text(report.largest_hole) +
                       ",\n  \"voxels\": [" + std::to_string(report.voxels[0]) + ", " +
                       std::to_string(report.voxels[1]) + ", " + std::to_string(report.voxels[2]) +
                       "],\n  \"seconds\": " + seconds_json(report.seconds) +
                       ",\n  \"elements\": " + elements_json(report.elements) + "\n}\n");
}

Report read_report(const fs::path& path) {
  const json root = json_reader::parsed_file(path);
  try {
    return report(root);
  } catch (const json_reader::Problem& problem) {
    throw json_reader::error_in(path, problem);
  }
}

std::string report_text(const Report& report) {
  const auto& [nx, ny, nz] = report.voxels;
  const Report::Seconds& s = report.seconds;
  return elements_text(report) + "\n" +
         line("voxels", std::to_string(nx) + " x " + std::to_string(ny) + " x " +
                            std::to_string(nz) + " = " + grouped(nx * ny * nz)) +
         line("fill by volume", percent(report.fill)) +
         line("fill by voxels", percent(report.fill_by_voxels)) +
         line("largest hole left", percent(report.largest_hole) + " of the longest side") +
         line("seconds", "prepare " + rounded(s.prepare, 2) + ", place " + rounded(s.place, 2) +
                             ", update " + rounded(s.update, 2) + ", write " + rounded(s.write, 2) +
                             ", render " + rounded(s.render, 2)) +
         line("seed", std::to_string(report.seed)) +
         (report.stopped ? line("not complete", "ended by " + harmless(*report.stopped)) : "");
}

}  // namespace collage
