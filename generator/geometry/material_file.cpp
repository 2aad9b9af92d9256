#include "geometry/material_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "geometry/color.h"
#include "geometry/obj_text.h"
#include "geometry/tiny_obj.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t limit_bytes = std::uintmax_t{64} << 20;

/// The names in one mtllib line: blanks part them unless a '\' stands before.
std::vector<std::string> split_names(std::string_view line) {
  std::vector<std::string> names(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool blank = line[i] == ' ' || line[i] == '\t';
    if (line[i] == '\\' && line.substr(i + 1).starts_with(' ')) {
      names.back() += line[++i];
    } else if (!blank) {
      names.back() += line[i];
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  return names;
}

/// The files that one mtllib line names: a single one with blanks in its name, or several names.
std::vector<fs::path> find_library(const fs::path& folder, std::string_view line) {
  line = trimmed(line.substr(0, line.find(" #")));
  if (const auto file = file_inside(folder, line)) {
    return {*file};
  }
  std::vector<fs::path> files;
  for (const std::string& name : split_names(line)) {
    if (const auto file = file_inside(folder, name)) {
      files.push_back(*file);
    }
  }
  return files;
}

double clamped(double value, double low, double high) {
  return std::isnan(value) ? low : std::clamp(tidy(value), low, high);
}

dvec3 color_of(const double (&rgb)[3], double limit) {
  return {clamped(rgb[0], 0, limit), clamped(rgb[1], 0, limit), clamped(rgb[2], 0, limit)};
}

void append_value(std::string& text, const char* keyword, double value) {
  text += keyword;
  text += ' ';
  append_number(text, value);
  text += '\n';
}

void append_color(std::string& text, const char* keyword, const dvec3& color) {
  text += keyword;
  for (int channel = 0; channel < 3; ++channel) {
    text += ' ';
    append_number(text, tidy(color[channel]));
  }
  text += '\n';
}

/// Whether a library's Kd are linear light. Most programs write and show them as a screen is sent
/// them; Blender says in the first line who wrote the file.
enum class Colors { encoded, linear };
Colors colors_of(std::string_view library) {
  return library.starts_with("# Blender") ? Colors::linear : Colors::encoded;
}

Material convert(const tinyobj::material_t& from, Colors colors, const fs::path& folder,
                 Status& status) {
  Material material;
  material.name = trimmed(from.name);
  material.color = color_of(from.diffuse, 1.0);
  if (colors == Colors::encoded) {
    material.color = linear_from_srgb(material.color);
  }
  material.specular = color_of(from.specular, 1.0);
  material.emission = color_of(from.emission, 1e6);
  material.shininess = clamped(from.shininess, 0.0, 1000.0);
  material.opacity = clamped(from.dissolve, 0.0, 1.0);
  if (from.ior != 1.0) {
    material.refraction_index = clamped(from.ior, 1.0, 10.0);
  }
  if (std::max({from.roughness, from.metallic, from.sheen, from.clearcoat_thickness}) > 0.0) {
    material.roughness = clamped(from.roughness, 0.0, 1.0);
    material.metallic = clamped(from.metallic, 0.0, 1.0);
    material.sheen = clamped(from.sheen, 0.0, 1.0);
    material.clearcoat = clamped(from.clearcoat_thickness, 0.0, 1.0);
  }
  const std::string_view texture = trimmed(from.diffuse_texname);
  if (const auto file = file_inside(folder, texture)) {
    material.texture = *file;
  } else if (!texture.empty()) {
    status.note("material '" + material.name + "': texture '" + std::string(texture) +
                "' is not a file in the mesh's folder; the colour is used");
  }
  return material;
}

void read_library(const fs::path& file, const fs::path& folder, MaterialFiles& result,
                  Status& status) {
  const std::string library = read_file(file, limit_bytes);
  std::istringstream stream(library);
  std::map<std::string, int> indices;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  tinyobj::LoadMtl(&indices, &materials, &stream, &warning, &error);
  for (const auto& material : materials) {
    const bool known =
        std::any_of(result.materials.begin(), result.materials.end(),
                    [&](const Material& other) { return other.name == trimmed(material.name); });
    if (!known && !trimmed(material.name).empty()) {
      result.materials.push_back(convert(material, colors_of(library), folder, status));
    }
  }
  result.files.push_back(file);
}

/// The material that a `usemtl` names, behind which some programs write a comment.
Material find_material(const std::vector<Material>& materials, const std::string& name) {
  for (const std::string& candidate :
       {name, std::string(trimmed(std::string_view(name).substr(0, name.find(" #"))))}) {
    for (const Material& material : materials) {
      if (material.name == candidate) {
        return material;
      }
    }
  }
  Material grey;
  grey.name = name;
  return grey;
}

}  // namespace

std::optional<fs::path> file_inside(const fs::path& folder, std::string_view name) {
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  if (portable.empty() || portable.find('\0') != std::string::npos) {
    return std::nullopt;
  }
  std::error_code error;
  const fs::path base = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) {
    return std::nullopt;
  }
  const fs::path file = fs::canonical(base / portable, error);
  if (error || !fs::is_regular_file(file, error)) {
    return std::nullopt;
  }
  const fs::path relative = file.lexically_relative(base);
  if (relative.empty() || *relative.begin() == "..") {
    return std::nullopt;
  }
  return folder / relative;
}

std::string material_text(const Material& material) {
  std::string text;
  append_color(text, "Kd", srgb_from_linear(material.color));
  append_color(text, "Ks", material.specular);
  append_color(text, "Ke", material.emission);
  append_value(text, "Ns", material.shininess);
  append_value(text, "Ni", material.refraction_index);
  append_value(text, "d", material.opacity);
  if (material.roughness) {
    append_value(text, "Pr", *material.roughness);
    append_value(text, "Pm", material.metallic);
    append_value(text, "Ps", material.sheen);
    append_value(text, "Pc", material.clearcoat);
  }
  return text;
}

MaterialFiles read_materials(const fs::path& folder, const std::vector<std::string>& libraries,
                             Status& status) {
  MaterialFiles result;
  for (const std::string& library : libraries) {
    const std::vector<fs::path> files = find_library(folder, library);
    if (files.empty()) {
      status.note("material file '" + library +
                  "' is not a file in the mesh's folder; its materials are left grey");
    }
    for (const fs::path& file : files) {
      if (std::find(result.files.begin(), result.files.end(), file) == result.files.end()) {
        read_library(file, folder, result, status);
      }
    }
  }
  return result;
}

void set_materials(const std::vector<std::string>& names, const std::vector<Material>& defined,
                   Mesh& mesh) {
  std::map<std::uint32_t, std::uint32_t> place;
  for (std::uint32_t& index : mesh.triangle_materials) {
    const auto [entry, is_new] =
        place.try_emplace(index, static_cast<std::uint32_t>(mesh.materials.size()));
    if (is_new) {
      mesh.materials.push_back(
          find_material(defined, index < names.size() ? names[index] : "default"));
    }
    index = entry->second;
  }
  if (mesh.materials.size() == 1) {
    mesh.triangle_materials.clear();
  }
  if (names.empty()) {
    mesh.materials.clear();
  }
}

}  // namespace collage
