#include "scene/povray_writer.h"

#include <vector>

#include "base/file.h"
#include "base/text.h"
#include "scene/composition_bounds.h"
#include "scene/element_look.h"
#include "scene/pov_mesh.h"
#include "scene/pov_text.h"
#include "scene/texture_copies.h"

namespace collage {
namespace {

constexpr std::size_t stages = 100;

std::string counted(std::size_t count, const std::string& noun) {
  return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string element_name(std::size_t k) { return "Element_" + std::to_string(k); }

std::string declared(const std::string& name, const std::string& value) {
  return "#declare " + name + " = " + value + ";\n";
}

std::string header(const Composition& composition, const std::string& template_name) {
  return "// " + plain_name(composition.name) + ": " +
         counted(composition.instances.size(), "instance") + " of " +
         counted(composition.elements.size(), "element") + ", made by " +
         plain_name(composition.made_by) +
         ".\n// A picture: povray +Iscene.pov +W1280 +H960 +A0.3\n"
         "#version 3.7;\n\n"
         "// The view and what is shown. For another picture declare other values in a file that\n"
         "// then includes this one.\n"
         "#ifndef (Azimuth) #declare Azimuth = 30; #end            // degrees; 0 = seen from +z\n"
         "#ifndef (Elevation) #declare Elevation = 15; #end        // degrees above the horizon\n"
         "#ifndef (Quality) #declare Quality = 2; #end             // 0 draft, 1 standard, 2 fine\n"
         "#ifndef (Stage) #declare Stage = 1; #end                 // share of the instances "
         "shown\n"
         "#ifndef (Only_Element) #declare Only_Element = -1; #end  // -1: all elements\n"
         "#ifndef (Template) #declare Template = " +
         pov_string(template_name + ".inc") + "; #end\n\n";
}

std::string bounds(const Composition& composition) {
  const CompositionBounds bounds = bounds_of(composition);
  return "// Boxes of all instances and of the target, in the units of the meshes; y is up. The\n"
         "// radius is that of the upright cylinder round the middle of both that holds them.\n" +
         declared("Sculpture_Min", pov_vector(bounds.instances.min)) +
         declared("Sculpture_Max", pov_vector(bounds.instances.max)) +
         declared("Sculpture_Radius", number_text(bounds.radius)) +
         declared("Target_Min", pov_vector(composition.target_box.min)) +
         declared("Target_Max", pov_vector(composition.target_box.max)) +
         declared("Has_Target", composition.target != nullptr ? "1" : "0") +
         declared("Element_Count", std::to_string(composition.elements.size())) + "\n";
}

/// One run of the writer.
class Writer {
 public:
  Writer(const std::filesystem::path& folder, const Composition& composition, Status& status)
      : composition_(composition), textures_(folder, status), file_(folder / "scene.pov") {}

  void write(const std::string& template_name) {
    file_.append(header(composition_, template_name));
    file_.append(bounds(composition_));
    append_target();
    file_.append(
        "#include \"collage.inc\"  // framing, camera, materials\n"
        "#include Template       // light, floor, finish\n\n");
    for (std::size_t k = 0; k < composition_.elements.size(); ++k) {
      append_element(k);
    }
    append_union();
    file_.commit();
  }

 private:
  void append_element(std::size_t k) {
    const Composition::Element& element = composition_.elements[k];
    const ElementLook look = look_of(element, k);
    file_.append("// " + plain_name(element.name) + ", " +
                 counted(element.mesh.triangles.size(), "triangle") + "\n");
    MeshTextures textures{{}, look.assignment};
    for (std::size_t m = 0; m < look.materials.size(); ++m) {
      const std::string suffix = "_Material_" + std::to_string(m);
      textures.textures.push_back(element_name(k) + suffix);
      append_material(textures.textures.back(), look.materials[m], element.mesh);
    }
    append_mesh2(file_, element_name(k), element.mesh, textures);
    file_.append("\n");
  }

  void append_material(const std::string& name, const Material& material, const Mesh& mesh) {
    const bool has_uv = !mesh.uv_triangles.empty();
    const auto picture =
        has_uv && !material.texture.empty() ? textures_.add(material.texture) : std::nullopt;
    std::string macro = "Material(" + pov_vector(material.color);
    if (picture) {
      file_.append("#declare " + name + "_Image = pigment { image_map { " + picture->format + " " +
                   pov_string(picture->name) + " interpolate 2 } }\n");
      macro = "Image_Material(" + name + "_Image";
    }
    file_.append("#declare " + name + " = " + macro + ", " + pov_vector(material.specular) + ", " +
                 number_text(material.shininess) + ", " + number_text(material.opacity) + ", " +
                 number_text(material.refraction_index) + ", " + pov_vector(material.emission) +
                 ")\n");
  }

  void append_union() {
    file_.append("union {\n");
    for (std::size_t k = 0; k < composition_.elements.size(); ++k) {
      append_instances_of(k);
    }
    file_.append("  interior { Element_Interior }\n  transform { Place_Sculpture }\n}\n");
  }

  void append_instances_of(std::size_t k) {
    const std::size_t count = composition_.instances.size();
    std::size_t open_stage = stages;  // none
    file_.append("#if (Shows_Element(" + std::to_string(k) + "))\n");
    for (std::size_t i = 0; i < count; ++i) {
      if (composition_.instances[i].element != k) {
        continue;
      }
      if (const std::size_t stage = i * stages / count; stage != open_stage) {
        file_.append(open_stage == stages ? "" : "#end\n");
        file_.append("#if (Stage > " + number_text(static_cast<double>(stage) / stages) + ")\n");
        open_stage = stage;
      }
      append_instance(composition_.instances[i]);
    }
    file_.append(open_stage == stages ? "#end\n" : "#end\n#end\n");
  }

  void append_instance(const Instance& instance) {
    const glm::dmat3 m = glm::mat3_cast(instance.rotation) * instance.scale;
    const dvec3& t = instance.translation;
    line_ = "object { " + element_name(instance.element) + " matrix ";
    append_vector(line_, {m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z,  //
                          m[2].x, m[2].y, m[2].z, t.x, t.y, t.z});
    line_ += " }\n";
    file_.append(line_);
  }

  /// Before the templates, which may show it and let it cast a shadow.
  void append_target() {
    if (composition_.target != nullptr) {
      file_.append("// The target's mesh.\n");
      append_mesh2(file_, "Target", *composition_.target, {});
      file_.append("\n");
    }
  }

  const Composition& composition_;
  TextureCopies textures_;
  FileWriter file_;
  std::string line_;
};

}  // namespace

void write_povray(const std::filesystem::path& folder, const Composition& composition,
                  const std::string& template_name, Status& status) {
  Writer(folder, composition, status).write(template_name);
}

}  // namespace collage
