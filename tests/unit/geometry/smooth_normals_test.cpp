#include "geometry/smooth_normals.h"

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace collage {
namespace {

TEST(SmoothNormals, EdgesSharperThanTheCreaseStaySharp) {
  Mesh cube = make_cube();
  set_smooth_normals(cube, 80.0);
  EXPECT_EQ(cube.normals.size(), 6U);
  set_smooth_normals(cube, 100.0);
  EXPECT_EQ(cube.normals.size(), 8U);  // one a corner, along the diagonal whatever the triangles
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 diagonal = glm::normalize(cube.corner(t, k) - 0.5);
      EXPECT_NEAR(glm::distance(cube.normals[cube.normal_triangles[t][k]], diagonal), 0.0, 1e-5);
    }
  }
}

}  // namespace
}  // namespace collage
