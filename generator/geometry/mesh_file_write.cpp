#include <algorithm>
#include <array>
#include <string>

#include "base/file.h"
#include "base/text.h"
#include "geometry/material_file.h"
#include "geometry/mesh_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

template <int size>
void append_line(std::string& text, std::string_view keyword,
                 const glm::vec<size, double>& numbers) {
  text += keyword;
  for (int i = 0; i < size; ++i) {
    text += ' ';
    append_number(text, numbers[i]);
  }
  text += '\n';
}

/// A name that fits on a line, the same for no two materials.
std::string safe_name(const Mesh& mesh, std::size_t material) {
  std::string name = mesh.materials[material].name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
  const bool known = std::any_of(
      mesh.materials.begin(), mesh.materials.begin() + static_cast<std::ptrdiff_t>(material),
      [&](const Material& other) { return other.name == mesh.materials[material].name; });
  return name.empty() || known ? name + "-" + std::to_string(material) : name;
}

void append_header(std::string& text, std::string_view comment) {
  while (!comment.empty()) {
    const std::size_t end = std::min(comment.find('\n'), comment.size());
    text.append("# ").append(comment.substr(0, end)).append("\n");
    comment.remove_prefix(std::min(end + 1, comment.size()));
  }
}

std::string library_text(const Mesh& mesh, const fs::path& folder) {
  std::string text;
  for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
    const Material& material = mesh.materials[i];
    text += (i > 0 ? "\nnewmtl " : "newmtl ") + safe_name(mesh, i) + "\n";
    text += material_text(material);
    if (!material.texture.empty()) {
      const fs::path name = fs::absolute(material.texture).lexically_relative(fs::absolute(folder));
      text += "map_Kd " + name.generic_string() + "\n";
    }
  }
  return text;
}

/// "7", "7/5", "7//3" or "7/5/3".
void append_corner(std::string& text, const Mesh& mesh, std::size_t triangle, int k) {
  text += ' ' + std::to_string(mesh.triangles[triangle][k] + 1);
  if (!mesh.uv_triangles.empty()) {
    text += '/' + std::to_string(mesh.uv_triangles[triangle][k] + 1);
  }
  if (!mesh.normal_triangles.empty()) {
    text += mesh.uv_triangles.empty() ? "//" : "/";
    text += std::to_string(mesh.normal_triangles[triangle][k] + 1);
  }
}

std::string mesh_text(const Mesh& mesh) {
  std::string text;
  for (const dvec3& position : mesh.positions) {
    append_line(text, "v", position);
  }
  for (const dvec2& uv : mesh.uvs) {
    append_line(text, "vt", uv);
  }
  for (const dvec3& normal : mesh.normals) {
    append_line(text, "vn", normal);
  }
  std::size_t material = mesh.materials.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t own = mesh.triangle_materials.empty() ? 0 : mesh.triangle_materials[t];
    if (own != material && own < mesh.materials.size()) {
      material = own;
      text += "usemtl " + safe_name(mesh, own) + "\n";
    }
    text += 'f';
    for (int k = 0; k < 3; ++k) {
      append_corner(text, mesh, t, k);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

void write_obj(const fs::path& path, const Mesh& mesh, std::string_view header_comment) {
  std::string text;
  append_header(text, header_comment);
  if (!mesh.materials.empty()) {
    const fs::path library = fs::path(path).replace_extension(".mtl");
    std::string materials;
    append_header(materials, header_comment);
    write_file(library, materials + library_text(mesh, path.parent_path()));
    text += "mtllib " + library.filename().string() + "\n";
  }
  write_file(path, text + mesh_text(mesh));
}

}  // namespace collage
