#include "geometry/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "geometry/boxes.h"
#include "geometry/four_tree.h"

namespace collage {
namespace {

constexpr double four_pi = 4.0 * glm::pi<double>();
/// A cluster is far from a point at over this many times its radius (Barill's accuracy β).
constexpr double accuracy = 2.0;

/// Sums half solid angles as van Oosterom and Strackee 1983 give them, the argument of a complex
/// number each. Numbers are multiplied, which adds their arguments, as long as the sum cannot pass
/// ±π, so that one arctangent serves for many triangles.
class HalfSolidAngles {
 public:
  /// Triangle abc, seen from the origin.
  void add(const dvec3& a, const dvec3& b, const dvec3& c) {
    const double la = glm::length(a);
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    add(la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb,
        glm::dot(a, glm::cross(b, c)));
  }
  /// The complex number x + iy.
  void add(double x, double y) {
    if (x > 0.0 && x_ > 0.0) {  // both within ±π/2
      const double product_x = x_ * x - y_ * y;
      y_ = x_ * y + y_ * x;
      x_ = product_x;
      if (!(std::abs(x_) < 1e100 && std::abs(x_) > 1e-100)) {
        flush();
      }
    } else {
      sum_ += std::atan2(y, x);
      flush();
    }
  }
  double sum() {
    flush();
    return sum_;
  }

 private:
  void flush() {
    sum_ += std::atan2(y_, x_);
    x_ = 1.0;
    y_ = 0.0;
  }

  double x_ = 1.0;
  double y_ = 0.0;
  double sum_ = 0.0;
};

/// Two triangles; an absent one is a point, which goes round nothing.
struct Pair {
  Points<Two> a{};
  Points<Two> b{};
  Points<Two> c{};

  void add_to(HalfSolidAngles& angles, const Points<Two>& point) const {
    const Points<Two> pa = a - point;
    const Points<Two> pb = b - point;
    const Points<Two> pc = c - point;
    const Two la = square_root(dot(pa, pa));
    const Two lb = square_root(dot(pb, pb));
    const Two lc = square_root(dot(pc, pc));
    const Two y = dot(pa, cross(pb, pc));
    const Two x = la * lb * lc + dot(pa, pb) * lc + dot(pb, pc) * la + dot(pc, pa) * lb;
    angles.add(x[0], y[0]);
    angles.add(x[1], y[1]);
  }
};
using Leaf = std::array<Pair, four_lanes / 2>;

/// Up to four sets of triangles, each as it looks from afar.
struct Clusters {
  Points<Four> center;
  /// Sums of the triangles' area vectors.
  Points<Four> dipole{};
  /// Symmetric parts of Σ (centroid - center) ⊗ area vector: xx, yy, zz, then 2xy, 2yz, 2zx.
  Points<Four> moment_diagonal{};
  Points<Four> moment_mixed{};
  /// Farther away than this they stand for their triangles. An absent one always does.
  Four far_distance_squared = all_four(-1.0F);
  std::array<std::uint32_t, four_lanes> content{};

  Clusters() { center.fill(all_four(1e9F)); }
};

}  // namespace

double winding_number(const Mesh& mesh, const dvec3& point) {
  HalfSolidAngles angles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    angles.add(mesh.corner(t, 0) - point, mesh.corner(t, 1) - point, mesh.corner(t, 2) - point);
  }
  return 2.0 * angles.sum() / four_pi;
}

class WindingNumber::Hierarchy {
 public:
  explicit Hierarchy(const Mesh& mesh);
  [[nodiscard]] double at(const dvec3& point) const;

  std::uint32_t add_leaf(std::span<const std::uint32_t> triangles);
  std::uint32_t add_inner() {
    clusters_.emplace_back();
    return static_cast<std::uint32_t>(clusters_.size() - 1);
  }
  void set_child(std::uint32_t inner, std::size_t lane, const Box& box,
                 std::span<const std::uint32_t> triangles, std::uint32_t content);

 private:
  struct Triangle {
    dvec3 a, b, c;
  };

  /// Winding numbers do not depend on size or place, floats do.
  [[nodiscard]] dvec3 unit(const dvec3& point) const { return (point - center_) * per_unit_; }

  dvec3 center_;
  double per_unit_;
  /// While the hierarchy is built.
  std::vector<Triangle> source_;
  std::vector<Clusters> clusters_;
  std::vector<Leaf> leaves_;
  std::uint32_t root_;
};

WindingNumber::Hierarchy::Hierarchy(const Mesh& mesh) {
  const BoxTree tree(boxes_of_triangles(mesh));
  const Box box = tree.nodes().empty() ? Box{dvec3(0.0), dvec3(0.0)} : tree.nodes()[0].box;
  center_ = box.center();
  per_unit_ = box.longest_side() > 0.0 ? 1.0 / box.longest_side() : 1.0;
  source_.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    source_.push_back({unit(mesh.corner(t, 0)), unit(mesh.corner(t, 1)), unit(mesh.corner(t, 2))});
  }
  root_ = FourTreeBuilder(tree, *this).run();
  source_ = {};
}

std::uint32_t WindingNumber::Hierarchy::add_leaf(std::span<const std::uint32_t> triangles) {
  Leaf& leaf = leaves_.emplace_back();
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
    const auto& [a, b, c] = source_[triangles[lane]];
    Pair& pair = leaf[lane / 2];
    set_lane(pair.a, lane % 2, a);
    set_lane(pair.b, lane % 2, b);
    set_lane(pair.c, lane % 2, c);
  }
  return static_cast<std::uint32_t>(leaves_.size() - 1);
}

void WindingNumber::Hierarchy::set_child(std::uint32_t inner, std::size_t lane, const Box& /*box*/,
                                         std::span<const std::uint32_t> triangles,
                                         std::uint32_t content) {
  double area = 0.0;
  dvec3 weighted(0.0);
  dvec3 dipole(0.0);
  for (const std::uint32_t index : triangles) {
    const auto& [a, b, c] = source_[index];
    const dvec3 area_vector = 0.5 * glm::cross(b - a, c - a);
    const double weight = glm::length(area_vector);
    area += weight;
    weighted += weight / 3.0 * (a + b + c);
    dipole += area_vector;
  }
  const dvec3 center = area > 0.0 ? weighted / area : source_[triangles[0]].a;
  double radius_squared = 0.0;
  dvec3 diagonal(0.0);
  dvec3 mixed(0.0);
  for (const std::uint32_t index : triangles) {
    const auto& [a, b, c] = source_[index];
    const dvec3 n = 0.5 * glm::cross(b - a, c - a);
    const dvec3 m = (a + b + c) / 3.0 - center;
    diagonal += m * n;
    mixed += dvec3(m.x * n.y + m.y * n.x, m.y * n.z + m.z * n.y, m.z * n.x + m.x * n.z);
    for (const dvec3& corner : {a, b, c}) {
      const dvec3 d = corner - center;
      radius_squared = std::max(radius_squared, glm::dot(d, d));
    }
  }
  Clusters& clusters = clusters_[inner];
  set_lane(clusters.center, lane, center);
  set_lane(clusters.dipole, lane, dipole);
  set_lane(clusters.moment_diagonal, lane, diagonal);
  set_lane(clusters.moment_mixed, lane, mixed);
  clusters.far_distance_squared[lane] = static_cast<float>(accuracy * accuracy * radius_squared);
  clusters.content[lane] = content;
}

double WindingNumber::Hierarchy::at(const dvec3& point) const {
  const dvec3 at = unit(point);
  const Points<Two> exactly_here = both(at);
  const Points<Four> here = all_four(glm::vec3(at));
  Four far_sum{};  // in units of 4π
  HalfSolidAngles near;
  std::array<std::uint32_t, four_tree_waiting> waiting;
  waiting[0] = root_;
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t content = waiting[--count];
    if ((content & four_tree_leaf) != 0) {
      for (const Pair& pair : leaves_[content & ~four_tree_leaf]) {
        pair.add_to(near, exactly_here);
      }
      continue;
    }
    const Clusters& clusters = clusters_[content];
    const Points<Four> r = clusters.center - here;
    const Four squared = dot(r, r);
    const auto is_far = squared > clusters.far_distance_squared;
    const Four inverse_squared = 1.0F / squared;
    const Four inverse_cubed = inverse_squared * square_root(inverse_squared);
    const Points<Four>& diagonal = clusters.moment_diagonal;
    const Points<Four> squares = {r[0] * r[0], r[1] * r[1], r[2] * r[2]};
    const Points<Four> products = {r[0] * r[1], r[1] * r[2], r[2] * r[0]};
    const Four quadratic = dot(diagonal, squares) + dot(clusters.moment_mixed, products);
    const Four dipoles = inverse_cubed * (dot(clusters.dipole, r) + diagonal[0] + diagonal[1] +
                                          diagonal[2] - 3.0F * quadratic * inverse_squared);
    far_sum += is_far ? dipoles : Four{};
    for (std::size_t lane = 0; lane < four_lanes; ++lane) {
      waiting[count] = clusters.content[lane];
      count += is_far[lane] == 0 ? 1 : 0;
    }
  }
  return (sum(far_sum) + 2.0 * near.sum()) / four_pi;
}

WindingNumber::WindingNumber(const Mesh& mesh) : hierarchy_(std::make_unique<Hierarchy>(mesh)) {}
WindingNumber::~WindingNumber() = default;
WindingNumber::WindingNumber(WindingNumber&&) noexcept = default;
WindingNumber& WindingNumber::operator=(WindingNumber&&) noexcept = default;

double WindingNumber::at(const dvec3& point) const { return hierarchy_->at(point); }

}  // namespace collage
