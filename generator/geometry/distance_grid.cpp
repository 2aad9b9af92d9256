#include "geometry/distance_grid.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <tbb/parallel_for.h>

#include "base/error.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

namespace collage {
namespace {

/// Hands out the words of a text with the line that each stands on.
class Words {
 public:
  Words(const std::filesystem::path& file, std::string_view text) : file_(file), rest_(text) {}

  /// Empty at the end.
  std::string_view peek() {
    skip_space();
    return rest_.substr(0, rest_.find_first_of(" \t\r\n#"));
  }
  std::string_view next() {
    const std::string_view word = peek();
    rest_.remove_prefix(word.size());
    return word;
  }
  template <class Number>
  Number number(const char* what) {
    const std::string_view word = next();
    Number value{};
    const auto [end, error] = std::from_chars(word.begin(), word.end(), value);
    if (error != std::errc{} || end != word.end() || !std::isfinite(static_cast<double>(value))) {
      fail(word.empty() ? std::string("ends where ") + what + " should stand"
                        : "'" + std::string(word.substr(0, 40)) + "' is not " + what);
    }
    return value;
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw Error({file_, line_}, problem,
                "write the voxels along x, y and z, then one signed distance a voxel");
  }

 private:
  void skip_space() {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
        continue;
      }
      if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
        return;
      }
      line_ += c == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    }
  }

  std::filesystem::path file_;
  std::string_view rest_;
  int line_ = 1;
};

constexpr int largest_side = 2048;

DistanceGrid read_header(Words& words) {
  DistanceGrid grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[axis] = words.number<int>("a number of voxels");
    if (grid.size[axis] < 3 || grid.size[axis] > largest_side) {
      words.fail("a side of " + std::to_string(grid.size[axis]) + " voxels is not from 3 to " +
                 std::to_string(largest_side));
    }
  }
  if (words.peek() == "origin") {
    words.next();
    for (int axis = 0; axis < 3; ++axis) {
      grid.origin[axis] = words.number<double>("a coordinate of the origin");
    }
  }
  if (words.peek() == "voxel") {
    words.next();
    grid.voxel_side = words.number<double>("the side of a voxel");
    if (grid.voxel_side <= 0.0) {
      words.fail("the side of a voxel must be above 0");
    }
  }
  return grid;
}

bool on_border(const DistanceGrid& grid, const glm::ivec3& v) {
  return glm::any(glm::equal(v, glm::ivec3(0))) || glm::any(glm::equal(v, grid.size - 1));
}

/// The sign of the outermost voxels, which lie outside: +1, -1, or 0 where they disagree.
int border_sign(const DistanceGrid& grid) {
  bool positive = false;
  bool negative = false;
  glm::ivec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z) {
    for (v.y = 0; v.y < grid.size.y; ++v.y) {
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        if (on_border(grid, v)) {
          (grid.at(v) > 0.0F ? positive : negative) = true;
        }
      }
    }
  }
  return positive == negative ? 0 : (positive ? 1 : -1);
}

}  // namespace

DistanceGrid read_distance_grid(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  Words words(path, text);
  DistanceGrid grid = read_header(words);
  const std::size_t count = static_cast<std::size_t>(grid.size.x) * grid.size.y * grid.size.z;
  if (count > text.size()) {  // each value takes a character and a space
    throw Error({path}, "holds fewer than the " + grouped(count) + " distances that it announces",
                "write one signed distance a voxel");
  }
  grid.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    grid.values.push_back(words.number<float>("a signed distance"));
  }
  if (!words.peek().empty()) {
    words.fail("more distances than voxels");
  }
  const int sign = border_sign(grid);
  if (sign == 0) {
    throw Error({path}, "the outermost voxels are not all outside of the surface",
                "leave at least one voxel of space around the shape");
  }
  if (sign < 0) {
    for (float& value : grid.values) {
      value = -value;
    }
  }
  if (std::ranges::none_of(grid.values, [](float value) { return value < 0.0F; })) {
    throw Error({path}, "no voxel lies inside the surface", "use smaller voxels");
  }
  return grid;
}

void write_distance_grid(const std::filesystem::path& path, const DistanceGrid& grid) {
  FileWriter writer(path);
  std::string line =
      "# Signed distances, negative inside: voxels along x, y and z, then one a voxel, x "
      "fastest.\n";
  for (int axis = 0; axis < 3; ++axis) {
    line += std::to_string(grid.size[axis]) + (axis < 2 ? " " : "\norigin");
  }
  for (int axis = 0; axis < 3; ++axis) {
    line += " ";
    append_number(line, grid.origin[axis]);
  }
  line += "\nvoxel ";
  append_number(line, grid.voxel_side);
  line += "\n";
  writer.append(line);
  glm::ivec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z) {
    for (v.y = 0; v.y < grid.size.y; ++v.y) {
      line.clear();
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        append_number(line, grid.at(v));
        line += v.x + 1 < grid.size.x ? ' ' : '\n';
      }
      writer.append(line);
    }
  }
  writer.commit();
}

DistanceGrid sample_distance_grid(const Solid& solid, const Box& box, int resolution) {
  DistanceGrid grid;
  grid.voxel_side = box.longest_side() / resolution;
  grid.size = glm::ivec3(glm::ceil(box.extent() / grid.voxel_side - 1e-9)) + 2;
  grid.origin = box.center() - 0.5 * grid.voxel_side * dvec3(grid.size);
  const std::size_t count = static_cast<std::size_t>(grid.size.x) * grid.size.y * grid.size.z;
  require_memory(count * sizeof(float), "the grid", "--resolution");
  grid.values.resize(count);
  tbb::parallel_for(0, grid.size.z, [&](int z) {
    glm::ivec3 v(0, 0, z);
    float* value = &grid.values[static_cast<std::size_t>(z) * grid.size.y * grid.size.x];
    for (v.y = 0; v.y < grid.size.y; ++v.y) {
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        const dvec3 point = solid.unit_from_mesh(grid.center(v));
        const auto nearest = solid.surface().find(point, std::numeric_limits<double>::infinity());
        const double distance = nearest->distance * solid.radius();
        *value++ = static_cast<float>(solid.inside(point) ? -distance : distance);
      }
    }
  });
  return grid;
}

}  // namespace collage
