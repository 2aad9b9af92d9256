#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace collage {

using glm::dvec2;
using glm::dvec3;
using glm::uvec3;

/// How a surface looks. Colours are linear-light RGB from 0 to 1.
struct Material {
  std::string name;
  dvec3 color{0.8};
  dvec3 specular{0.0};
  /// MTL's Ns, 0 (dull) to 1000 (mirror-like).
  double shininess = 0.0;
  /// 1 opaque, 0 invisible.
  double opacity = 1.0;
  double refraction_index = 1.45;
  dvec3 emission{0.0};
  /// MTL's Pr, Pm, Ps and Pc, each 0 to 1; without a roughness the file has none of them, and
  /// `specular` and `shininess` count.
  std::optional<double> roughness;
  double metallic = 0.0;
  double sheen = 0.0;
  double clearcoat = 0.0;
  /// Picture for the colour, looked up by uv; empty for none. A path that exists, inside the folder
  /// of the mesh file.
  std::filesystem::path texture;
};

/// Axis-aligned box; `min` > `max` while nothing is in it.
struct Box {
  dvec3 min{1e300};
  dvec3 max{-1e300};

  void include(const dvec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  [[nodiscard]] dvec3 extent() const { return max - min; }
  [[nodiscard]] dvec3 center() const { return 0.5 * (min + max); }
  [[nodiscard]] double longest_side() const {
    const dvec3 e = extent();
    return glm::max(e.x, glm::max(e.y, e.z));
  }
};

/// Indexed triangles, counter-clockwise seen from outside. Positions, normals and uv are indexed
/// apart, as in OBJ; an index list is either empty or has one entry a triangle.
struct Mesh {
  std::vector<dvec3> positions;
  std::vector<uvec3> triangles;

  std::vector<dvec3> normals;
  std::vector<uvec3> normal_triangles;
  std::vector<dvec2> uvs;
  std::vector<uvec3> uv_triangles;

  std::vector<Material> materials;
  /// For each triangle an index into `materials`; empty where all triangles have material 0 or
  /// there is none.
  std::vector<std::uint32_t> triangle_materials;

  [[nodiscard]] dvec3 corner(std::size_t triangle, int k) const {
    return positions[triangles[triangle][k]];
  }
};

/// A position as models are written: rounded to a millionth, which keeps files short and makes
/// equal what should be.
inline dvec3 to_millionths(const dvec3& position) { return glm::round(position * 1e6) / 1e6; }

/// Box of all positions that a triangle uses.
Box bounding_box(const Mesh& mesh);

/// Volume by the divergence theorem, Σ a·(b×c)/6: right for closed, outward-oriented meshes
/// without overlap of their parts; see solid_volume() for all others.
double enclosed_volume(const Mesh& mesh);

/// Sum of the triangles' areas.
double surface_area(const Mesh& mesh);

/// Turns every triangle over, with its normals.
void reverse_orientation(Mesh& mesh);

}  // namespace collage
