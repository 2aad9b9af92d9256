#include "geometry/linking_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "test_meshes.h"

namespace collage {
namespace {

/// A circle in the plane of u and v, run from u to v.
Loop circle(const dvec3& center, const dvec3& u, const dvec3& v, int points) {
  Loop loop;
  for (int i = 0; i < points; ++i) {
    const double angle = glm::two_pi<double>() * i / points;
    loop.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
  }
  return loop;
}

const dvec3 x(1.0, 0.0, 0.0);
const dvec3 y(0.0, 1.0, 0.0);
const dvec3 z(0.0, 0.0, 1.0);

TEST(LinkingNumber, OfTwoRings) {
  const Loop ring = circle(dvec3(0.0), x, y, 24);
  EXPECT_EQ(std::abs(linking_number(ring, circle(x, x, z, 17))), 1);
  EXPECT_EQ(linking_number(ring, circle(x, x, z, 17)), -linking_number(ring, circle(x, x, -z, 17)));
  EXPECT_EQ(linking_number(ring, circle(3.0 * x, x, z, 17)), 0);
  EXPECT_EQ(linking_number(ring, circle(2.0 * z, x, y, 17)), 0);
  EXPECT_EQ(linking_number(ring, circle(x + 0.1 * z, 0.3 * x, 0.3 * y, 17)), 0);
}

/// A curve on a torus that goes round the core k times.
TEST(LinkingNumber, CountsTurns) {
  for (const int turns : {2, 3, 5}) {
    Loop coil;
    for (int i = 0; i < 200; ++i) {
      const double angle = glm::two_pi<double>() * i / 200;
      const double r = 1.0 + 0.3 * std::cos(turns * angle);
      coil.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.3 * std::sin(turns * angle));
    }
    EXPECT_EQ(std::abs(linking_number(coil, circle(dvec3(0.0), x, y, 50))), turns);
  }
}

/// Points of a closed curve of low frequencies, drawn at random.
Loop tangle(std::mt19937& random, int points) {
  std::uniform_real_distribution<double> amplitude(-1.0, 1.0);
  std::array<std::array<dvec3, 2>, 4> waves;
  for (auto& wave : waves) {
    for (dvec3& part : wave) {
      part = {amplitude(random), amplitude(random), amplitude(random)};
    }
  }
  Loop loop;
  for (int i = 0; i < points; ++i) {
    dvec3 point(0.0);
    for (std::size_t k = 0; k < waves.size(); ++k) {
      const double angle = glm::two_pi<double>() * static_cast<double>(k + 1) * i / points;
      point += std::cos(angle) * waves[k][0] + std::sin(angle) * waves[k][1];
    }
    loop.push_back(point);
  }
  return loop;
}

TEST(LinkingNumber, IsThatByGaussIntegral) {
  std::mt19937 random(1);
  int largest = 0;
  for (int i = 0; i < 200; ++i) {
    const Loop a = tangle(random, 40 + i);
    const Loop b = tangle(random, 130);
    const int number = linking_number(a, b);
    EXPECT_EQ(number, linking_number_by_solid_angles(a, b)) << i;
    EXPECT_EQ(number, linking_number(b, a)) << i;
    largest = std::max(largest, std::abs(number));
  }
  EXPECT_GE(largest, 3);
}

/// Seen from where corners hide one another.
TEST(LinkingNumber, IsSureWherePointsHideOneAnother) {
  const dvec3 along(-0.37139, -0.23171, 1.0);
  const Loop a{dvec3(0.0), x, x + y, y};
  const Loop through{dvec3(0.5, 0.5, 0.0) - along, dvec3(0.5, 0.5, 0.0) + along, 4.0 * x};
  EXPECT_EQ(std::abs(linking_number(a, through)), 1);
  const Loop behind{2.0 * along, x + 2.0 * along, x + y + 2.0 * along, y + 2.0 * along};
  EXPECT_EQ(linking_number(a, behind), 0);
  EXPECT_EQ(linking_number(a, {}), 0);
}

TEST(HandleLoops, ThereAreTwoForEachHandle) {
  EXPECT_TRUE(handle_loops(test::blob_mesh(1.0, 0.2, 12)).empty());
  EXPECT_EQ(handle_loops(test::torus_mesh(1.0, 0.3, 24, 12)).size(), 2U);
  EXPECT_TRUE(handle_loops(test::open_box_mesh(dvec3(0.0), dvec3(1.0))).empty());
  Mesh two = test::torus_mesh(1.0, 0.3, 24, 12);
  Mesh other = test::torus_mesh(1.0, 0.2, 20, 10);
  for (dvec3& position : other.positions) {
    position += 5.0 * x;
  }
  append(two, other);
  EXPECT_EQ(handle_loops(two).size(), 4U);
}

int links(const Mesh& a, const Mesh& b) {
  int number = 0;
  for (const Loop& loop : handle_loops(a)) {
    for (const Loop& other : handle_loops(b)) {
      number = std::max(number, std::abs(linking_number(loop, other)));
    }
  }
  return number;
}

TEST(HandleLoops, TellWhetherSolidsHangInOneAnother) {
  const Mesh ring = test::torus_mesh(1.0, 0.25, 24, 12);  // about the y axis
  Mesh turned = ring;
  for (dvec3& p : turned.positions) {
    p = dvec3(p.x, p.z, -p.y);
  }
  Mesh through = turned;
  Mesh beside = turned;
  for (std::size_t i = 0; i < turned.positions.size(); ++i) {
    through.positions[i] += x;
    beside.positions[i] += 3.0 * x;
  }
  EXPECT_EQ(links(ring, through), 1);
  EXPECT_EQ(links(ring, beside), 0);
}

}  // namespace
}  // namespace collage
