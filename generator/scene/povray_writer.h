#pragma once

#include <filesystem>
#include <string>

#include "base/status.h"
#include "scene/composition.h"

namespace collage {

/// Writes scene.pov into `folder`, whole or not at all, and copies of the materials' pictures
/// beside it as texture-0.png, … Each element is one mesh2, each instance one matrix, shown by its
/// number in the order of placement, so that a picture can show one element or a stage of the
/// assembly. Instances lie in nested unions with boxes, through which POV-Ray's trace() finds its
/// way fast; to render as fast, POV-Ray wants +SU, which looks into the unions. The folder must get
/// the templates as well.
///
/// The target's mesh is declared as Target ahead of the templates, for those that show it. For the
/// rest, collage.inc provides the paints and finishes, the interior Element_Interior and the macro
/// Set_Floor, which the template may declare anew and which is called at the end, and the template
/// the transform Place_Sculpture. See templates/collage.inc.
///
/// Nothing from a mesh or scene file reaches POV-Ray but numbers and names reduced to letters and
/// digits in comments. Throws Error where a file cannot be written. Cost: about a microsecond an
/// instance and a triangle.
void write_povray(const std::filesystem::path& folder, const Composition& composition,
                  const std::string& template_name, Status& status);

}  // namespace collage
