#include "geometry/models.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "geometry/bounding_sphere.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"
#include "mesh_quality.h"

namespace collage {
namespace {

/// The number of times that the mesh goes round a point, by solid angles (Van Oosterom 1983).
double turns(const Mesh& mesh, const dvec3& point) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = glm::normalize(mesh.corner(t, 0) - point);
    const dvec3 b = glm::normalize(mesh.corner(t, 1) - point);
    const dvec3 c = glm::normalize(mesh.corner(t, 2) - point);
    sum += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                            1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
  }
  return sum / (4.0 * std::numbers::pi);
}

TEST(Models, AllAreClosedOutwardAndHaveNormalsThatPointOut) {
  for (const StarterModel& model : starter_models()) {
    Mesh mesh = model.make();
    const MeshReport report = check_mesh(mesh);
    EXPECT_TRUE(report.closed) << model.name;
    EXPECT_EQ(report.nonmanifold_edges + report.inconsistent_edges + report.degenerate_triangles,
              0U)
        << model.name;
    EXPECT_EQ(text_of(orient(mesh)), "") << model.name;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const dvec3 a = mesh.corner(t, 0);
      const dvec3 face = glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a);
      for (int k = 0; k < 3; ++k) {
        const dvec3& normal = mesh.normals[mesh.normal_triangles[t][k]];
        EXPECT_GT(glm::dot(normal, face), 0.0) << model.name;
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-5);
      }
    }
  }
}

TEST(Models, TeapotHasNewellsMeasures) {
  const Mesh teapot = make_teapot(10);
  const MeshReport report = check_mesh(teapot);
  EXPECT_EQ(report.parts, 3U);
  EXPECT_GE(report.triangles, 6000U);
  EXPECT_LE(report.triangles, 10000U);
  EXPECT_EQ(report.box.min.y, 0.0);
  EXPECT_EQ(report.box.max.y, 3.15);
  EXPECT_NEAR(report.box.extent().x, 6.43, 0.01);
  EXPECT_EQ(report.box.extent().z, 4.0);
  EXPECT_EQ(turns(make_teapot(4), {0, 2.39, 1.0}) > 0.5, true);  // under the lid
  EXPECT_NEAR(turns(teapot, {0, 1.2, 0}), 1.0, 1e-9);
  EXPECT_NEAR(turns(teapot, {2.6, 1.6, 0}), 1.0, 1e-9);   // in the spout
  EXPECT_NEAR(turns(teapot, {-2.8, 1.9, 0}), 1.0, 1e-9);  // in the handle
  EXPECT_NEAR(turns(teapot, {-2.4, 1.7, 0}), 0.0, 1e-9);  // through the handle
}

TEST(Models, TeapotConvergesToItsPatches) {
  const double coarse = enclosed_volume(make_teapot(5));
  const double middle = enclosed_volume(make_teapot(10));
  const double fine = enclosed_volume(make_teapot(20));
  EXPECT_NEAR((middle - coarse) / (fine - middle), 4.0, 0.4);  // second order
}

TEST(Models, TeacupHoldsTeaAndItsHandleStaysInTheWall) {
  const Mesh cup = make_teacup(14);
  const MeshReport report = check_mesh(cup);
  EXPECT_EQ(report.parts, 2U);
  EXPECT_NEAR(static_cast<double>(report.triangles), 300.0, 30.0);
  EXPECT_EQ(report.box.min.y, 0.0);
  EXPECT_NEAR(turns(cup, {0, 0.6, 0}), 0.0, 1e-9);  // the hollow
  EXPECT_NEAR(turns(cup, {0, 0.1, 0}), 1.0, 1e-9);  // the bottom

  // The handle starts behind the cup. Where it is not within the wall it is outside, not in the
  // hollow: its corners near the axis are within the cup's own part.
  Mesh wall = cup;
  const std::size_t handle_triangles = (7 * 2 + 2) * 6;
  wall.triangles.resize(cup.triangles.size() - handle_triangles);
  ASSERT_EQ(check_mesh(wall).parts, 1U);
  std::size_t within = 0;
  for (std::size_t t = wall.triangles.size(); t < cup.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 corner = cup.corner(t, k);
      const bool inside = turns(wall, corner) > 0.5;
      const double radius = std::hypot(corner.x, corner.z);
      within += inside ? 1 : 0;
      EXPECT_TRUE(inside || radius > (corner.y > 0.7 ? 0.92 : 0.80)) << radius << " " << corner.y;
    }
  }
  EXPECT_GE(within, 2U * 6U * 3U);  // both end caps
}

TEST(Models, SphereIsRound) {
  const Mesh sphere = make_sphere(3);
  EXPECT_EQ(sphere.triangles.size(), 1280U);
  EXPECT_NEAR(smallest_enclosing_sphere(sphere.positions).radius, 1.0, 1e-14);
  EXPECT_NEAR(enclosed_volume(sphere), 4.0 / 3.0 * std::numbers::pi, 0.05);
}

struct Expected {
  std::size_t least_triangles;
  std::size_t most_triangles;
  std::size_t parts;
  int genus;
};

/// All but teapot and teacup, whose parts pass through each other.
const std::map<std::string_view, Expected> own_models = {
    {"sphere", {1280, 1280, 1, 0}},
    {"carrot", {200, 300, 6, 0}},
    {"top-hat", {288, 288, 1, 0}},
    {"bowl", {2000, 4000, 1, 0}},
    {"bowl-inside", {500, 1500, 1, 0}},
    {"bowl-milk", {1000, 2000, 1, 0}},
    {"spoon", {300, 700, 1, 0}},
    {"cereal-ring", {108, 248, 1, 1}},
    {"cereal-loop", {108, 248, 1, 1}},
    {"cereal-flake", {108, 248, 1, 0}},
    {"cereal-star", {108, 248, 1, 0}},
    {"cereal-puff", {108, 248, 1, 0}},
    {"chair", {1100, 1200, 16, 0}},
    {"chair-target", {1000, 10000, 1, 2}},
    {"drape", {1000, 10000, 1, 0}},
    {"topmod1-a", {72, 480, 1, 3}},
    {"topmod1-b", {72, 480, 1, 4}},
    {"topmod1-c", {72, 480, 1, 2}},
    {"topmod1-target", {2000, 10000, 1, 6}},
    {"topmod2-a", {72, 480, 1, 3}},
    {"topmod2-b", {72, 480, 1, 4}},
    {"topmod2-c", {72, 480, 1, 3}},
    {"topmod2-target", {2000, 10000, 1, 11}},
    {"topmod3-a", {72, 480, 3, 3}},
    {"topmod3-b", {72, 480, 4, 4}},
    {"topmod3-c", {72, 480, 1, 1}},
    {"topmod3-target", {2000, 10000, 6, 6}},
};

TEST(Models, OwnModelsAreManifoldAndNowhereMeetThemselves) {
  std::size_t looked_at = 0;
  for (const StarterModel& model : starter_models()) {
    const auto expected = own_models.find(model.name);
    if (expected == own_models.end()) {
      continue;
    }
    SCOPED_TRACE(model.name);
    ++looked_at;
    const Mesh mesh = model.make();
    const MeshReport report = check_mesh(mesh);
    EXPECT_GE(report.triangles, expected->second.least_triangles);
    EXPECT_LE(report.triangles, expected->second.most_triangles);
    EXPECT_EQ(report.parts, expected->second.parts);
    EXPECT_EQ(report.vertices, mesh.positions.size());
    EXPECT_EQ(genus_of(mesh), expected->second.genus);
    EXPECT_GT(report.volume, 0.0);
    EXPECT_EQ(self_intersections(mesh), 0U);
  }
  EXPECT_EQ(looked_at, own_models.size());
  EXPECT_EQ(starter_models().size(), own_models.size() + 2);
}

TEST(Models, BowlHoldsWhatIsHeapedInIt) {
  const Mesh bowl = make_bowl();
  const Mesh inside = make_bowl_inside();
  Mesh both = bowl;
  append_part(both, inside, Material());
  EXPECT_EQ(self_intersections(both), 0U);
  for (const dvec3& position : inside.positions) {
    EXPECT_NEAR(turns(bowl, position), 0.0, 1e-9);
  }
  EXPECT_GT(bounding_box(inside).max.y, bounding_box(bowl).max.y);
  EXPECT_LT(bounding_box(inside).extent().x, bounding_box(bowl).extent().x);
  const MeshReport report = check_mesh(bowl);
  EXPECT_GT(enclosed_volume(inside), 3.0 * report.volume);  // the wall is thin
}

TEST(Models, PartsAreOfTheirMaterial) {
  const Mesh carrot = make_carrot();
  ASSERT_EQ(carrot.materials.size(), 2U);
  const Mesh hat = make_top_hat();
  ASSERT_EQ(hat.materials.size(), 2U);
  for (std::size_t t = 0; t < carrot.triangles.size(); ++t) {
    const bool above = carrot.corner(t, 0).y > 2.18;
    EXPECT_EQ(carrot.materials[carrot.triangle_materials[t]].name, above ? "greens" : "carrot");
  }
  for (std::size_t t = 0; t < hat.triangles.size(); ++t) {
    if (hat.materials[hat.triangle_materials[t]].name == "satin") {
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(std::hypot(hat.corner(t, k).x, hat.corner(t, k).z), 0.565, 0.02);
      }
    }
  }
}

}  // namespace
}  // namespace collage
