#include "scene/obj_exporter.h"

#include <cstdint>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "geometry/material_file.h"
#include "scene/element_look.h"
#include "scene/pov_text.h"
#include "scene/texture_copies.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// A name without spaces, which OBJ takes as the end of a name.
std::string obj_name(const std::string& name) {
  std::string plain = plain_name(name);
  for (char& c : plain) {
    c = c == ' ' ? '_' : c;
  }
  return plain;
}

std::string material_name(std::size_t element, std::size_t material) {
  return "element-" + std::to_string(element) + "-material-" + std::to_string(material);
}

template <class Vector>
std::string row(const char* keyword, const Vector& v) {
  std::string text = keyword;
  for (int i = 0; i < v.length(); ++i) {
    text += ' ';
    append_number(text, v[i]);
  }
  return text + "\n";
}

std::string named_material_text(const std::string& name, const Material& material,
                                TextureCopies& textures) {
  std::string text = "newmtl " + name + "\n" + material_text(material);
  if (!material.texture.empty()) {
    if (const auto copy = textures.add(material.texture)) {
      text += "map_Kd " + copy->name + "\n";
    }
  }
  return text + "\n";
}

/// One run of the exporter.
class Exporter {
 public:
  Exporter(const fs::path& path, const Composition& composition, Status& status)
      : path_(path), composition_(composition), status_(status), file_(path) {
    for (std::size_t k = 0; k < composition.elements.size(); ++k) {
      looks_.push_back(look_of(composition.elements[k], k));
    }
  }

  void write() {
    write_materials();
    append_uvs();
    for (std::size_t i = 0; i < composition_.instances.size(); ++i) {
      if (status_.stop_requested()) {
        throw Interrupted();
      }
      append_instance(i);
    }
    file_.commit();
  }

 private:
  /// How many vertices, uvs and normals stand in the file before those that a face refers to.
  struct Offsets {
    std::uint64_t position = 0;
    std::uint64_t uv = 0;
    std::uint64_t normal = 0;
  };

  void write_materials() {
    const std::string name = obj_name(path_.stem().string()) + ".mtl";
    TextureCopies textures(path_.parent_path(), status_);
    std::string text;
    for (std::size_t k = 0; k < looks_.size(); ++k) {
      for (std::size_t m = 0; m < looks_[k].materials.size(); ++m) {
        text += named_material_text(material_name(k, m), looks_[k].materials[m], textures);
      }
    }
    write_file(path_.parent_path() / name, text);
    file_.append("# " + plain_name(composition_.name) + ", made by " +
                 plain_name(composition_.made_by) + "\nmtllib " + name + "\n");
  }

  /// All instances of an element share its uvs.
  void append_uvs() {
    std::uint64_t count = 0;
    for (const Composition::Element& element : composition_.elements) {
      first_uv_.push_back(count);
      if (!element.mesh.uv_triangles.empty()) {
        count += element.mesh.uvs.size();
        for (const dvec2& uv : element.mesh.uvs) {
          file_.append(row("vt", uv));
        }
      }
    }
  }

  void append_instance(std::size_t i) {
    const Instance& instance = composition_.instances[i];
    const Composition::Element& element = composition_.elements[instance.element];
    file_.append("g " + obj_name(element.name) + "." + std::to_string(i) + "\n");
    for (const dvec3& position : element.mesh.positions) {
      file_.append(row("v", instance.world_from_element(position)));
    }
    const Offsets offsets{positions_, first_uv_[instance.element], normals_};
    positions_ += element.mesh.positions.size();
    if (!element.mesh.normal_triangles.empty()) {
      for (const dvec3& normal : element.mesh.normals) {
        file_.append(row("vn", instance.rotation * normal));
      }
      normals_ += element.mesh.normals.size();
    }
    append_faces(element.mesh, instance.element, offsets);
  }

  void append_faces(const Mesh& mesh, std::size_t element, const Offsets& offsets) {
    const ElementLook& look = looks_[element];
    std::size_t material_in_use = look.materials.size();  // none
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const std::size_t material =
          look.assignment == ElementLook::Assignment::by_triangle ? mesh.triangle_materials[t] : 0;
      if (material != material_in_use) {
        file_.append("usemtl " + material_name(element, material) + "\n");
        material_in_use = material;
      }
      append_face(mesh, t, offsets);
    }
  }

  void append_face(const Mesh& mesh, std::size_t t, const Offsets& offsets) {
    line_ = "f";
    for (int k = 0; k < 3; ++k) {
      line_ += " " + std::to_string(offsets.position + mesh.triangles[t][k] + 1);
      if (!mesh.uv_triangles.empty()) {
        line_ += "/" + std::to_string(offsets.uv + mesh.uv_triangles[t][k] + 1);
      }
      if (!mesh.normal_triangles.empty()) {
        line_ += mesh.uv_triangles.empty() ? "//" : "/";
        line_ += std::to_string(offsets.normal + mesh.normal_triangles[t][k] + 1);
      }
    }
    line_ += "\n";
    file_.append(line_);
  }

  const fs::path& path_;
  const Composition& composition_;
  Status& status_;
  FileWriter file_;
  std::vector<ElementLook> looks_;
  std::vector<std::uint64_t> first_uv_;
  std::uint64_t positions_ = 0;
  std::uint64_t normals_ = 0;
  std::string line_;
};

}  // namespace

void export_obj(const fs::path& path, const Composition& composition, Status& status) {
  Exporter(path, composition, status).write();
}

}  // namespace collage
