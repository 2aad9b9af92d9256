#include "geometry/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "geometry/material_file.h"
#include "geometry/obj_faces.h"
#include "geometry/obj_text.h"
#include "geometry/polygon.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t limit_bytes = std::uintmax_t{2} << 30;
constexpr double limit_coordinate = 1e18;
constexpr std::size_t limit_corners = 20000;
constexpr std::int64_t none = ObjCorner::none;

struct Triangle {
  std::array<ObjCorner, 3> corners;
  int material;
};

std::string read_text(const fs::path& path) {
  constexpr std::uint64_t memory_a_byte = 16;  // of the lists that a text of short faces turns into
  std::error_code unknown;  // a size that is not known is that of nothing to read
  const std::uintmax_t size = fs::file_size(path, unknown);
  if (!unknown && size <= limit_bytes) {
    require_memory(memory_a_byte * size, path.string(), "its number of faces");
  }
  std::string text = read_file(path, limit_bytes);
  if (text.find('\0') != std::string::npos) {
    throw Error({path}, "is not a text file", "name a Wavefront OBJ");
  }
  if (text.starts_with("\xef\xbb\xbf")) {
    text.erase(0, 3);
  }
  return text;
}

/// Turns the faces of a file into triangles, and those into a mesh.
class Assembler {
 public:
  Assembler(const fs::path& path, const ObjText& text, ObjFaces& faces, Status& status)
      : path_(path), text_(text), faces_(faces), status_(status) {}

  Mesh run();

 private:
  [[nodiscard]] Error missing_vertex(int line) const;
  void check_face(std::size_t face);
  void add_face(std::size_t face);
  void fill_normals();
  void note_repairs() const;
  void note(std::uint64_t count, const std::string& what) const;

  const fs::path& path_;
  const ObjText& text_;
  ObjFaces& faces_;
  Status& status_;

  std::vector<Triangle> triangles_;
  std::uint64_t flat_triangles_ = 0;
  std::uint64_t lost_attributes_ = 0;
  std::uint64_t small_faces_ = 0;
};

Error Assembler::missing_vertex(int line) const {
  return {{path_, line},
          "a face names a vertex that is not there (the file has " +
              grouped(text_.positions.size()) + ")",
          "export the mesh again"};
}

void Assembler::check_face(std::size_t face) {
  const auto count = std::ssize(text_.positions);
  const std::size_t end = faces_.starts[face + 1];
  for (std::size_t i = faces_.starts[face]; i < end; ++i) {
    ObjCorner& corner = faces_.corners[i];
    if (corner.position < 0 || corner.position >= count) {
      throw missing_vertex(text_.face_lines[face]);
    }
    const dvec3& position = text_.positions[corner.position];
    const dvec3 size = glm::abs(position);
    if (!(glm::max(size.x, glm::max(size.y, size.z)) <= limit_coordinate)) {
      throw Error({path_, text_.position_lines[corner.position]},
                  std::isnan(position.x) ? "a vertex is not three finite numbers"
                                         : "a vertex lies farther out than 1e18",
                  "mend the coordinates");
    }
    for (auto [index, size_of] : {std::pair{&corner.uv, std::ssize(faces_.uvs)},
                                  std::pair{&corner.normal, std::ssize(faces_.normals)}}) {
      if (*index < none || *index >= size_of) {
        *index = none;
        ++lost_attributes_;
      }
    }
  }
  if (end - faces_.starts[face] > limit_corners) {
    throw Error({path_, text_.face_lines[face]},
                "a face has more than " + grouped(limit_corners) + " corners",
                "triangulate it in a modelling program");
  }
}

void Assembler::add_face(std::size_t face) {
  const std::size_t start = faces_.starts[face];
  std::vector<dvec3> polygon;
  for (std::size_t i = start; i < faces_.starts[face + 1]; ++i) {
    polygon.push_back(text_.positions[faces_.corners[i].position]);
  }
  small_faces_ += polygon.size() < 3 ? 1 : 0;
  for (const auto& [a, b, c] : triangulate(polygon)) {
    if (glm::cross(polygon[b] - polygon[a], polygon[c] - polygon[a]) == dvec3(0.0)) {
      ++flat_triangles_;
      continue;
    }
    const auto* corners = &faces_.corners[start];
    triangles_.push_back({{corners[a], corners[b], corners[c]}, faces_.materials[face]});
  }
}

/// Makes all normals unit vectors, and gives each corner without one that of its face.
void Assembler::fill_normals() {
  auto& normals = faces_.normals;
  for (dvec3& normal : normals) {
    const double length = glm::length(normal);
    normal = length > 0 && std::isfinite(length) ? normal / length : dvec3(0.0);
  }
  for (Triangle& triangle : triangles_) {
    const auto& [a, b, c] = triangle.corners;
    const dvec3 origin = text_.positions[a.position];
    const dvec3 area =
        glm::cross(text_.positions[b.position] - origin, text_.positions[c.position] - origin);
    std::int64_t own = none;
    for (ObjCorner& corner : triangle.corners) {
      if (corner.normal != none && normals[corner.normal] != dvec3(0.0)) {
        continue;
      }
      if (own == none) {
        own = std::ssize(normals);
        normals.push_back(glm::normalize(area));
      }
      corner.normal = own;
    }
  }
}

/// The values that corners name, in their order, and the corners' indices into them.
template <class Value>
void compact(const std::vector<Value>& all, std::int64_t ObjCorner::*index,
             const std::vector<Triangle>& triangles, std::vector<Value>& values,
             std::vector<uvec3>& indices) {
  std::vector<std::uint32_t> place(all.size(), 0);
  for (const Triangle& triangle : triangles) {
    for (const ObjCorner& corner : triangle.corners) {
      place[corner.*index] = 1;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (place[i] != 0) {
      place[i] = static_cast<std::uint32_t>(values.size());
      values.push_back(all[i]);
    }
  }
  for (const Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.corners;
    indices.emplace_back(place[a.*index], place[b.*index], place[c.*index]);
  }
}

bool any_corner_has(std::int64_t ObjCorner::*index, const std::vector<Triangle>& triangles) {
  for (const Triangle& triangle : triangles) {
    for (const ObjCorner& corner : triangle.corners) {
      if (corner.*index != none) {
        return true;
      }
    }
  }
  return false;
}

void Assembler::note(std::uint64_t count, const std::string& what) const {
  if (count > 0) {
    status_.note(path_.filename().string() + ": " + what + ": " + grouped(count));
  }
}

void Assembler::note_repairs() const {
  note(flat_triangles_, "triangles without area, left out");
  note(small_faces_, "faces with fewer than three corners, left out");
  note(lost_attributes_, "normals or uv that faces name and that are not there, done without");
}

Mesh Assembler::run() {
  if (text_.overflowing_face_line) {
    throw missing_vertex(*text_.overflowing_face_line);
  }
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    check_face(face);
    add_face(face);
  }
  if (triangles_.empty()) {
    throw Error({path_}, faces_.size() == 0 ? "holds no faces" : "holds no face with an area",
                "name a mesh with triangles or polygons");
  }
  note_repairs();
  Mesh mesh;
  compact(text_.positions, &ObjCorner::position, triangles_, mesh.positions, mesh.triangles);
  if (any_corner_has(&ObjCorner::normal, triangles_)) {
    fill_normals();
    compact(faces_.normals, &ObjCorner::normal, triangles_, mesh.normals, mesh.normal_triangles);
  }
  if (any_corner_has(&ObjCorner::uv, triangles_)) {
    faces_.uvs.emplace_back(0.0);
    for (Triangle& triangle : triangles_) {
      for (ObjCorner& corner : triangle.corners) {
        corner.uv = corner.uv == none ? std::ssize(faces_.uvs) - 1 : corner.uv;
      }
    }
    compact(faces_.uvs, &ObjCorner::uv, triangles_, mesh.uvs, mesh.uv_triangles);
  }
  for (const Triangle& triangle : triangles_) {
    mesh.triangle_materials.push_back(static_cast<std::uint32_t>(triangle.material));
  }
  return mesh;
}

}  // namespace

MeshFile read_obj(const fs::path& path, Status& status) {
  const ObjText text = scan_obj(read_text(path));
  ObjFaces faces = parse_faces(text);
  MeshFile file;
  file.mesh = Assembler(path, text, faces, status).run();
  MaterialFiles materials;
  if (!faces.material_names.empty()) {
    materials = read_materials(path.parent_path(), text.libraries, status);
  }
  set_materials(faces.material_names, materials.materials, file.mesh);
  file.files = {path};
  file.files.insert(file.files.end(), materials.files.begin(), materials.files.end());
  for (const Material& material : file.mesh.materials) {
    const auto& texture = material.texture;
    if (!texture.empty() &&
        std::find(file.files.begin(), file.files.end(), texture) == file.files.end()) {
      file.files.push_back(texture);
    }
  }
  return file;
}

}  // namespace collage
