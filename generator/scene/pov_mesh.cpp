#include "scene/pov_mesh.h"

#include <string_view>

#include "scene/pov_text.h"

namespace collage {
namespace {

/// Appends "  keyword { count, item, item, … }", an item a line; `append_item(line, i)` writes one.
template <class AppendItem>
void append_list(FileWriter& file, std::string_view keyword, std::size_t count,
                 AppendItem append_item) {
  file.append("  " + std::string(keyword) + " {\n    " + std::to_string(count));
  std::string line;
  for (std::size_t i = 0; i < count; ++i) {
    line = ",\n    ";
    append_item(line, i);
    file.append(line);
  }
  file.append("\n  }\n");
}

void append_indices(std::string& line, const uvec3& indices) {
  line += "<" + std::to_string(indices.x) + "," + std::to_string(indices.y) + "," +
          std::to_string(indices.z) + ">";
}

void append_index_list(FileWriter& file, std::string_view keyword,
                       const std::vector<uvec3>& triangles) {
  append_list(file, keyword, triangles.size(),
              [&](std::string& line, std::size_t t) { append_indices(line, triangles[t]); });
}

void append_vectors(FileWriter& file, const Mesh& mesh, bool use_uv) {
  append_list(file, "vertex_vectors", mesh.positions.size(),
              [&](std::string& line, std::size_t i) { append_vector(line, mesh.positions[i]); });
  if (!mesh.normal_triangles.empty()) {
    append_list(file, "normal_vectors", mesh.normals.size(), [&](std::string& line, std::size_t i) {
      const dvec3& normal = mesh.normals[i];
      append_vector(line, normal == dvec3(0.0) ? dvec3(0.0, 1.0, 0.0) : normal);
    });
  }
  if (use_uv) {
    append_list(file, "uv_vectors", mesh.uvs.size(), [&](std::string& line, std::size_t i) {
      append_vector(line, {mesh.uvs[i].x, mesh.uvs[i].y});
    });
  }
}

void append_texture_list(FileWriter& file, const std::vector<std::string>& textures) {
  append_list(file, "texture_list", textures.size(),
              [&](std::string& line, std::size_t i) { line += "texture { " + textures[i] + " }"; });
}

void append_faces(FileWriter& file, const Mesh& mesh, const MeshTextures& look) {
  if (look.assignment == ElementLook::Assignment::all_the_first) {
    append_index_list(file, "face_indices", mesh.triangles);
    return;
  }
  append_list(file, "face_indices", mesh.triangles.size(), [&](std::string& line, std::size_t t) {
    append_indices(line, mesh.triangles[t]);
    line += "," + std::to_string(mesh.triangle_materials[t]);
  });
}

}  // namespace

void append_mesh2(FileWriter& file, const std::string& name, const Mesh& mesh,
                  const MeshTextures& look) {
  const bool by_triangle = look.assignment == ElementLook::Assignment::by_triangle;
  const bool use_uv = look.use_uv && !mesh.uv_triangles.empty();
  file.append("#declare " + name + " = mesh2 {\n");
  append_vectors(file, mesh, use_uv);
  if (by_triangle) {
    append_texture_list(file, look.textures);
  }
  append_faces(file, mesh, look);
  if (!mesh.normal_triangles.empty()) {
    append_index_list(file, "normal_indices", mesh.normal_triangles);
  }
  if (use_uv) {
    append_index_list(file, "uv_indices", mesh.uv_triangles);
  }
  if (!by_triangle && !look.textures.empty()) {
    file.append("  texture { " + look.textures.front() + " }\n");
  }
  file.append("}\n");
}

}  // namespace collage
