#include <array>
#include <cmath>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "audit/audit.h"
#include "base/rng.h"
#include "geometry/models.h"
#include "support/meshes.h"

namespace collage {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Surface placed(const Mesh& mesh, const Instance& instance) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const dvec3& position : mesh.positions) {
    const dvec3 p = instance.world_from_element(position);
    vertices.push_back(surface.add_vertex({p.x, p.y, p.z}));
  }
  for (const uvec3& t : mesh.triangles) {
    surface.add_face(vertices[t.x], vertices[t.y], vertices[t.z]);
  }
  return surface;
}

/// What CGAL's exact predicates say of the same vertices.
bool overlap_by_cgal(const Mesh& a, const Instance& at_a, const Mesh& b, const Instance& at_b) {
  return CGAL::Polygon_mesh_processing::do_intersect(
      placed(a, at_a), placed(b, at_b), CGAL::parameters::do_overlap_test_of_bounded_sides(true),
      CGAL::parameters::do_overlap_test_of_bounded_sides(true));
}

bool overlap_by_audit(const Mesh& a, const Instance& at_a, const Mesh& b, const Instance& at_b) {
  Status status;
  std::array instances{at_a, at_b};
  instances[1].element = 1;
  AuditInput input;
  input.elements = {&a, &b};
  input.scales = {{}, {}};
  input.instances = instances;
  return !audit(input, status).overlaps.empty();
}

class Overlap : public testing::Test {
 protected:
  Instance random_instance(double spread) {
    Instance instance;
    instance.scale = std::exp2(3.0 * rng_.uniform() - 2.0);
    const dvec3 axis = test::random_point(rng_, 1.0);
    instance.rotation = glm::normalize(glm::dquat(2.0 * rng_.uniform() - 1.0, axis));
    instance.translation = test::random_point(rng_, spread);
    return instance;
  }
  const Mesh& random_mesh() { return meshes_[rng_.below(meshes_.size())]; }

  Rng rng_{20111, 7};
  std::vector<Mesh> meshes_{test::box_mesh(dvec3(-1), dvec3(1)), test::torus_mesh(1.0, 0.3, 18, 9),
                            test::blob_mesh(1.0, 0.3, 10), test::torus_mesh(1.0, 0.6, 12, 8)};
};

TEST_F(Overlap, OfRandomPairsIsWhatCgalSays) {
  int overlapping = 0;
  constexpr int pairs = 600;
  for (int i = 0; i < pairs; ++i) {
    const Mesh& a = random_mesh();
    const Mesh& b = random_mesh();
    const Instance at_a = random_instance(1.2);
    const Instance at_b = random_instance(1.2);
    const bool wanted = overlap_by_cgal(a, at_a, b, at_b);
    EXPECT_EQ(overlap_by_audit(a, at_a, b, at_b), wanted) << "pair " << i;
    overlapping += wanted ? 1 : 0;
  }
  EXPECT_GT(overlapping, pairs / 5);
  EXPECT_LT(overlapping, pairs * 4 / 5);
}

/// Moved towards each other until the next double makes them meet, and looked at on both sides.
TEST_F(Overlap, OfPairsThatNearlyTouchIsWhatCgalSays) {
  for (int i = 0; i < 60; ++i) {
    const Mesh& a = random_mesh();
    const Mesh& b = random_mesh();
    const Instance at_a = random_instance(0.0);
    Instance at_b = random_instance(0.0);
    const auto shifted = [&](double x) {
      at_b.translation.x = x;
      return at_b;
    };
    double meeting = 0.0;
    double apart = 10.0;
    if (!overlap_by_audit(a, at_a, b, shifted(meeting))) {
      continue;  // one lies in the hole of the other
    }
    for (;;) {
      const double middle = 0.5 * (meeting + apart);
      if (middle == meeting || middle == apart) {
        break;
      }
      (overlap_by_audit(a, at_a, b, shifted(middle)) ? meeting : apart) = middle;
    }
    EXPECT_TRUE(overlap_by_cgal(a, at_a, b, shifted(meeting))) << "pair " << i;
    EXPECT_FALSE(overlap_by_cgal(a, at_a, b, shifted(apart))) << "pair " << i;
  }
}

}  // namespace
}  // namespace collage
