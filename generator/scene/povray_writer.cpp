#include "scene/povray_writer.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/file.h"
#include "base/text.h"
#include "scene/composition_bounds.h"
#include "scene/element_look.h"
#include "scene/neighbourhoods.h"
#include "scene/pov_mesh.h"
#include "scene/pov_text.h"
#include "scene/texture_copies.h"

namespace collage {
namespace {

/// The macros of collage-finishes.inc, in the order of Finish.
constexpr std::array finish_macros{"As_In_File", "Ceramic", "Plastic", "Felt",  "Lacquer",
                                   "Matt",       "Satin",   "Metal",   "Glass", "Milk"};

std::string counted(std::size_t count, const std::string& noun) {
  return grouped(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string element_name(std::size_t k) { return "Element_" + std::to_string(k); }
std::string prop_name(std::size_t k) { return "Prop_" + std::to_string(k); }

std::string declared(const std::string& name, const std::string& value) {
  return "#declare " + name + " = " + value + ";\n";
}

/// A macro gives the value, ends and all.
std::string declared_macro(const std::string& name, const std::string& call) {
  return "#declare " + name + " = " + call + "\n";
}

std::string phong_numbers(const Material& m) {
  return ", " + pov_vector(m.specular) + ", " + number_text(m.shininess);
}

std::string physical_numbers(const Material& m) {
  return ", " + number_text(m.roughness.value_or(1.0)) + ", " + number_text(m.metallic) + ", " +
         number_text(m.sheen) + ", " + number_text(m.clearcoat);
}

std::string header(const Composition& composition, const std::string& template_name) {
  return "// " + plain_name(composition.name) + ": " +
         counted(composition.instances.size(), "instance") + " of " +
         counted(composition.elements.size(), "element") + ", made by " +
         plain_name(composition.made_by) +
         ".\n// A picture: povray +Iscene.pov +W1280 +H960 +A0.3 +SU\n"
         "#version 3.7;\n\n"
         "// The view and what is shown. For another picture declare other values in a file that\n"
         "// then includes this one.\n"
         "#ifndef (Azimuth) #declare Azimuth = 30; #end            // degrees; 0 = seen from +z\n"
         "#ifndef (Elevation) #declare Elevation = 15; #end        // degrees above the horizon\n"
         "#ifndef (Quality) #declare Quality = 2; #end             // 0 draft, 1 standard, 2 fine\n"
         "#ifndef (Stage) #declare Stage = 1; #end                 // share of the instances "
         "shown\n"
         "#ifndef (Only_Element) #declare Only_Element = -1; #end  // -1: all elements\n"
         "#ifndef (All_Round) #declare All_Round = 0; #end         // 1: room for it to turn "
         "round\n"
         "#ifndef (Template) #declare Template = " +
         pov_string(template_name + ".inc") + "; #end\n\n";
}

std::string outline_text(const std::string& name, const std::vector<dvec3>& outline) {
  std::string text = "#declare " + name + " = array[" + std::to_string(outline.size()) + "] {";
  const char* separator = "\n  ";
  for (const dvec3& point : outline) {
    text += separator + pov_vector(point);
    separator = ",\n  ";
  }
  return text + "\n}\n";
}

std::string bounds(const Composition& composition) {
  const CompositionBounds bounds = bounds_of(composition);
  return "// Boxes of all that is shown and of the target, in the units of the meshes; y is up. "
         "The\n"
         "// radius is that of the upright cylinder round the middle of both that holds them, the\n"
         "// outlines are their outermost points.\n" +
         declared("Sculpture_Min", pov_vector(bounds.shown.min)) +
         declared("Sculpture_Max", pov_vector(bounds.shown.max)) +
         declared("Sculpture_Radius", number_text(bounds.radius)) +
         declared("Target_Min", pov_vector(composition.target_box.min)) +
         declared("Target_Max", pov_vector(composition.target_box.max)) +
         outline_text("Sculpture_Outline", bounds.outline) +
         outline_text("Target_Outline", bounds.target_outline) +
         declared("Has_Target", composition.target != nullptr ? "1" : "0") + "\n";
}

bool is_clear(const std::vector<Composition::Element>& elements) {
  bool clear = false;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const std::vector<Material> materials = look_of(elements[k], k).materials;
    clear |= elements[k].finish == Finish::glass ||
             std::ranges::any_of(materials, [](const Material& m) { return m.opacity < 1.0; });
  }
  return clear;
}

/// How many instances are shown of each element, by their numbers in the order of placement.
std::string shown(const Composition& composition) {
  const std::string elements = std::to_string(composition.elements.size());
  return declared("Element_Count", elements) +
         declared("Instance_Count", std::to_string(composition.instances.size())) +
         declared("Has_Glass",
                  is_clear(composition.elements) || is_clear(composition.props) ? "1" : "0") +
         "// Of element K those instances are shown whose number in the order of placement is "
         "less\n"
         "// than Shown[K].\n"
         "#declare Shown = array[" +
         elements +
         "]\n#local K = 0;\n#while (K < Element_Count)\n"
         "  #declare Shown[K] = Stage * Instance_Count * (Only_Element < 0 | Only_Element = K);\n"
         "  #local K = K + 1;\n#end\n\n";
}

/// One run of the writer.
class Writer {
 public:
  Writer(const std::filesystem::path& folder, const Composition& composition, Status& status)
      : composition_(composition), textures_(folder, status), file_(folder / "scene.pov") {}

  void write(const std::string& template_name) {
    file_.append(header(composition_, template_name));
    file_.append(bounds(composition_));
    file_.append(shown(composition_));
    append_target();
    file_.append(
        "#include \"collage.inc\"  // framing, camera, light, floor, finishes\n"
        "#include Template       // how they are used\n\n");
    for (std::size_t k = 0; k < composition_.elements.size(); ++k) {
      append_element(element_name(k), composition_.elements[k], k);
    }
    for (std::size_t k = 0; k < composition_.props.size(); ++k) {
      append_element(prop_name(k), composition_.props[k], k);
    }
    append_all_shown();
    file_.commit();
  }

 private:
  void append_element(const std::string& name, const Composition::Element& element, std::size_t k) {
    const ElementLook look = look_of(element, k);
    file_.append("// " + plain_name(element.name) + ", " +
                 counted(element.mesh.triangles.size(), "triangle") + "\n");
    MeshTextures textures{.textures = {}, .assignment = look.assignment};
    for (std::size_t m = 0; m < look.materials.size(); ++m) {
      textures.textures.push_back(name + "_Material_" + std::to_string(m));
      textures.use_uv |= append_material(textures.textures.back(), look.materials[m], element);
    }
    append_mesh2(file_, name, element.mesh, textures);
    file_.append("\n");
  }

  /// Whether it looks up a picture.
  bool append_material(const std::string& name, const Material& material,
                       const Composition::Element& element) {
    const bool is_picture = append_paint(name + "_Paint", material, element.mesh);
    std::string call = finish_macros.at(static_cast<std::size_t>(element.finish));
    std::string numbers;
    if (element.finish == Finish::automatic) {
      call += material.roughness ? "_Physically" : "";
      numbers = material.roughness ? physical_numbers(material) : phong_numbers(material);
    }
    file_.append(declared_macro(
        name, call + "(" + name + "_Paint, " + pov_vector(material.emission) + numbers + ")"));
    return is_picture;
  }

  /// Whether it is a picture.
  bool append_paint(const std::string& name, const Material& material, const Mesh& mesh) {
    const bool has_uv = !mesh.uv_triangles.empty();
    const auto picture =
        has_uv && !material.texture.empty() ? textures_.add(material.texture) : std::nullopt;
    const std::string opacity = ", " + number_text(material.opacity) + ")";
    if (!picture) {
      file_.append(declared_macro(name, "Plain_Paint(" + pov_vector(material.color) + opacity));
      return false;
    }
    file_.append("#declare " + name + "_Image = pigment { image_map { " + picture->format + " " +
                 pov_string(picture->name) + " interpolate 2 } }\n" +
                 declared_macro(name, "Picture_Paint(" + name + "_Image" + opacity));
    return true;
  }

  /// The innermost neighbourhoods hold instances, the others neighbourhoods.
  void append_neighbourhood(const Neighbourhood& place) {
    file_.append("union {\n");
    for (const Neighbourhood& part : place.parts) {
      append_neighbourhood(part);
    }
    for (const std::uint32_t i : place.instances) {
      append_instance(i);
    }
    if (!composition_.instances.empty()) {
      file_.append("  bounded_by { box { " + pov_vector(place.box.min) + ", " +
                   pov_vector(place.box.max) + " } }\n");
    }
    file_.append("}\n");
  }

  /// `#if (17 < Shown[0]) object { Element_0 matrix <…> } #end`
  void append_instance(std::size_t i) {
    const Instance& instance = composition_.instances[i];
    const glm::dmat3 m = glm::mat3_cast(instance.rotation) * instance.scale;
    const dvec3& t = instance.translation;
    line_ = "#if (" + std::to_string(i) + " < Shown[" + std::to_string(instance.element) +
            "]) object { " + element_name(instance.element) + " matrix ";
    append_vector(line_, {m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z,  //
                          m[2].x, m[2].y, m[2].z, t.x, t.y, t.z});
    line_ += " } #end\n";
    file_.append(line_);
  }

  void append_all_shown() {
    file_.append(
        "// To trace the floor's shadow takes a second copy of all that is shown.\n"
        "#if (!Is_Shadow_Given) #declare Sculpture = #end\n"
        "union {\n");
    append_neighbourhood(neighbourhoods(composition_));
    for (std::size_t k = 0; k < composition_.props.size(); ++k) {
      file_.append("object { " + prop_name(k) + " }\n");
    }
    file_.append(
        "  interior { Element_Interior }\n"
        "  transform { Place_Sculpture }\n"
        "}\n"
        "#if (Is_Shadow_Given) Set_Floor(0) #else object { Sculpture } Set_Floor(Sculpture) "
        "#end\n");
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
