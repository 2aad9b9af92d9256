#pragma once

#include <filesystem>
#include <string>

#include "base/status.h"
#include "scene/composition.h"

namespace collage {

/// Writes scene.pov into `folder`, whole or not at all, and copies of the materials' pictures
/// beside it as texture-0.png, … Each element is one mesh2, each instance one matrix; instances are
/// grouped by element and by hundredths of the order of placement, so that a picture can show one
/// element or a stage of the assembly. The folder must get collage.inc and `template_name`.inc as
/// well.
///
/// The target's mesh is declared as Target ahead of the templates, for those that show it. For the
/// rest, collage.inc provides the macros Material, Image_Material and Shows_Element and the
/// interior Element_Interior, and the template the transform Place_Sculpture. See
/// templates/collage.inc.
///
/// Nothing from a mesh or scene file reaches POV-Ray but numbers and names reduced to letters and
/// digits in comments. Throws Error where a file cannot be written. Cost: about a microsecond an
/// instance and a triangle.
void write_povray(const std::filesystem::path& folder, const Composition& composition,
                  const std::string& template_name, Status& status);

}  // namespace collage
