#pragma once

#include <filesystem>
#include <string>

#include "base/file.h"
#include "render/shot.h"

namespace collage::testing {

/// A scene folder as the generator writes it, but for a ball and a box on a floor as sculpture.
inline void write_scene(const std::filesystem::path& folder, const std::string& extra = "") {
  write_file(folder / "scene.pov",
             "#version 3.7;\n"
             "#include Template\n"
             "union {\n"
             "  sphere { 0, 1 }\n"
             "#if (Stage > 0.5) box { <0.6, -1, 0.6>, <1.4, 0, 1.4> } #end\n"
             "  pigment { rgb <1, 0.3, 0.1> }\n"
             "  rotate y * -Azimuth\n"
             "}\n" +
                 extra);
  write_file(folder / "studio.inc",
             "global_settings { assumed_gamma 1 }\n"
             "camera { right -x * image_width / image_height\n"
             "  location vrotate(<0, 0, 5>, x * -Elevation) look_at 0 }\n"
             "light_source { <3, 5, 5> 1 }\n"
             "plane { y, -1 pigment { rgb 0.8 } }\n");
}

/// One that takes POV-Ray many seconds.
inline void write_slow_scene(const std::filesystem::path& folder) {
  write_scene(folder,
              "media { intervals 1 samples 20000 scattering { 1, 0.01 } }\n"
              "#declare I = 0;\n#while (I < 100000000) #declare I = I + 1; #end\n");
}

/// 64 by 48 pixels, draft.
inline Shot small_shot(double azimuth_degrees) {
  Shot shot;
  shot.view = {"test", azimuth_degrees, 15.0};
  shot.width = 64;
  shot.height = 48;
  return shot;
}

}  // namespace collage::testing
