#include "geometry/extrusion.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/polyhedra.h"
#include "mesh_quality.h"

namespace collage {
namespace {

constexpr std::array<dvec2, 6> angle = {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};

TEST(Extrusion, HasTheVolumeOfOutlineTimesDepth) {
  const PolygonMesh mesh = extrude(angle, 2.0);
  EXPECT_EQ(mesh.faces.size(), 8U);
  EXPECT_TRUE(is_closed_outward(mesh));
  EXPECT_NEAR(enclosed_volume(triangulated(mesh)), 10.0, 1e-9);
  EXPECT_EQ(face_normal(mesh, 0), dvec3(0, 0, 1));
  EXPECT_EQ(face_normal(mesh, 1), dvec3(0, 0, -1));
}

TEST(Extrusion, BevelsCutEdgesAtHalfARightAngle) {
  const PolygonMesh mesh = extrude(angle, 2.0, 0.2);
  EXPECT_EQ(mesh.faces.size(), 2U + 3U * 6U);
  EXPECT_TRUE(is_closed_outward(mesh));
  EXPECT_EQ(self_intersections(triangulated(mesh)), 0U);
  // Perimeter 12: at depth d the outline has lost 12 d, and five outer corners gain d² each against
  // the one inside.
  const double lost = 12.0 * 0.2 * 0.2 / 2.0 - 4.0 * std::pow(0.2, 3.0) / 3.0;
  EXPECT_NEAR(enclosed_volume(triangulated(mesh)), 10.0 - 2.0 * lost, 1e-5);
}

TEST(Extrusion, BevelsMayMeetInTheMiddle) {
  const PolygonMesh mesh = extrude(angle, 0.4, 0.2);
  EXPECT_EQ(mesh.faces.size(), 2U + 2U * 6U);
  EXPECT_TRUE(is_closed_outward(mesh));
}

TEST(Extrusion, FacesMoveAndScaleAboutTheirMiddle) {
  PolygonMesh mesh = regular_cube();
  const dvec3 out = face_normal(mesh, 2);
  const dvec3 middle = face_middle(mesh, 2);
  extrude_face(mesh, 2, 0.5 * out, 0.25);
  EXPECT_NEAR(glm::distance(face_middle(mesh, 2), middle + 0.5 * out), 0.0, 1e-12);
  EXPECT_EQ(mesh.faces.size(), 10U);
  EXPECT_TRUE(is_closed_outward(mesh));
  const double side = 2.0 * std::sqrt(1.0 / 3.0);
  const double frustum = 0.5 / 3.0 * side * side * (1.0 + 0.25 + 0.0625);
  EXPECT_NEAR(enclosed_volume(triangulated(mesh)), std::pow(side, 3.0) + frustum, 1e-5);
}

}  // namespace
}  // namespace collage
