#include "fuzz.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_file.h"
#include "geometry/mesh_repair.h"

using namespace collage;

/// An OBJ; what follows a line "#mtl" is the material file that it can name as fuzz.mtl.
COLLAGE_FUZZ_TARGET(input) {
  constexpr std::string_view mark = "\n#mtl\n";
  const std::size_t end = std::min(input.find(mark), input.size());
  const std::string_view materials = input.substr(std::min(end + mark.size(), input.size()));
  fuzz::file_with(materials, "fuzz.mtl");
  Status silent;
  Mesh mesh = read_obj(fuzz::file_with(input.substr(0, end), "fuzz.obj"), silent).mesh;
  check_mesh(mesh);
  repair(mesh);
}
