#include "cli/read_mesh.h"

#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "audit/audit.h"
#include "base/error.h"
#include "base/file.h"
#include "packing/pack.h"
#include "support/folder.h"
#include "support/meshes.h"

namespace collage {
namespace {

using ::testing::HasSubstr;

const std::string corners =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string lid = "f 5 6 7 8\n";
const std::string box = "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::string cube = corners + box + lid;
const std::string second_cube =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
    "f 9 12 11 10\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\nf 13 14 15 16\n";

/// In the middle of the lid.
const std::string small_hole =
    "v -0.09 -0.09 1\nv 0.09 -0.09 1\nv 0.09 0.09 1\nv -0.09 0.09 1\n"
    "f 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\n";

/// What becomes of a mesh that is packed into a cube, or filled with cubes.
struct Outcome {
  std::string defect;
  std::string obj;
  std::string as_element;
  std::string as_target;
};

void PrintTo(const Outcome& outcome, std::ostream* out) { *out << outcome.defect; }

const std::vector<Outcome> outcomes{
    {"none", cube, "packed", "packed"},
    {"a face is missing", corners + box, "packed", "packed"},
    {"a small hole", corners + box + small_hole, "packed", "packed"},
    {"a lid is apart by rounding",
     corners + box +
         "v -1 -1 1.00001\nv 1 -1 1.00001\nv 1 1 1.00001\nv -1 1 1.00001\nf 9 10 11 12\n",
     "packed", "packed"},
    {"a face is there twice", cube + lid, "packed", "packed"},
    {"a face is turned over", corners + box + "f 8 7 6 5\n", "packed", "packed"},
    {"inside out", corners + "f 2 3 4 1\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\nf 8 7 6 5\n",
     "packed", "packed"},
    {"a fin on an edge", cube + "v 0 0 3\nf 5 6 9\n", "packed", "packed"},
    {"faces without area", cube + "f 1 2 2\nf 1 2\nf 3\n", "packed", "packed"},
    {"a face that crosses itself", corners + box + "f 5 7 6 8\n", "packed", "packed"},
    {"a face that is not flat", cube + "v 0 0 2\nf 5 6 9 8\n", "packed", "packed"},
    {"parts pass through each other", cube + second_cube, "packed", "packed"},
    {"parts lie in one another", cube + cube, "packed", "packed"},
    {"an unused corner is far away", cube + "v 1e17 0 0\n", "packed", "packed"},
    {"normals and uv are missing", corners + box + "f 5/7/1 6/8/2 7/9/-3 8//5\n", "packed",
     "packed"},
    {"a sheet", corners + lid, "packed", "no space"},
    {"a one-sided strip", corners + "f 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 6\nf 5 6 1\nf 6 1 2\n",
     "packed", "packed"},
    {"a triangle", corners + "f 1 2 7\n", "packed", "no space"},
    {"no faces", corners, "holds no faces", "holds no faces"},
    {"no area", corners + "f 1 1 2\n", "no face with an area", "no face with an area"},
    {"a corner is not there", cube + "f 1 2 9\n", "vertex that is not there",
     "vertex that is not there"},
    {"not a number", cube + "v nan 0 0\nf 1 2 9\n", "three finite numbers", "three finite numbers"},
    {"beyond all sizes", cube + "v 1e19 0 0\nf 1 2 9\n", "farther out than", "farther out than"},
    {"no text", cube + std::string(1, '\0'), "is not a text file", "is not a text file"},
};

class DirtyMesh : public ::testing::TestWithParam<Outcome> {
 protected:
  [[nodiscard]] Mesh read(const std::string& obj) {
    write_file(folder_.path() / "m.obj", obj);
    return read_mesh(folder_.path() / "m.obj", Repair::full, status_).mesh;
  }

  [[nodiscard]] std::string outcome(const std::string& target_obj, const std::string& element_obj) {
    try {
      return packed(read(target_obj), read(element_obj));
    } catch (const Error& error) {
      return error.what();
    }
  }

 private:
  [[nodiscard]] std::string packed(const Mesh& target_mesh, const Mesh& element_mesh) {
    PackingOptions options;
    options.scaling = Scaling::to_hole;
    options.threshold = 0.1;
    const MeshTarget target(target_mesh);
    const Element element(element_mesh);
    const std::vector<Ingredient> ingredients{{element, {1.0}, 1.0}};
    ClearanceField field(target, target.voxels(24, 0.5, options.seed), status_);
    const Packing packing = pack(target, field, ingredients, options, status_);
    if (packing.voxels_inside_target == 0) {
      return "no space";
    }
    const AuditInput input{&target_mesh, {&element_mesh}, {{}}, packing.instances};
    return packing.instances.empty()        ? "nothing fits"
           : audit(input, status_).passed() ? "packed"
                                            : "does not pass the audit";
  }

  test::Folder folder_;
  Status status_;
};

TEST_P(DirtyMesh, packs_and_passes_the_audit_or_is_refused) {
  EXPECT_THAT(outcome(cube, GetParam().obj), HasSubstr(GetParam().as_element))
      << GetParam().defect << ", as an element";
  EXPECT_THAT(outcome(GetParam().obj, cube), HasSubstr(GetParam().as_target))
      << GetParam().defect << ", as a target";
}

INSTANTIATE_TEST_SUITE_P(Defects, DirtyMesh, ::testing::ValuesIn(outcomes));

}  // namespace
}  // namespace collage
