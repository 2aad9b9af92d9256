#include "support/thesis_twin.h"

#include <algorithm>
#include <limits>
#include <set>

#include <glm/gtc/constants.hpp>

#include "base/rng.h"
#include "packing/orientation.h"

namespace collage::test {
namespace {

std::vector<glm::uvec2> unique_edges(const Mesh& mesh) {
  std::set<std::pair<unsigned, unsigned>> edges;
  for (const uvec3& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  std::vector<glm::uvec2> list;
  for (const auto& [a, b] : edges) {
    list.emplace_back(a, b);
  }
  return list;
}

double squared_distance(const dvec3& a, const dvec3& b) { return glm::dot(a - b, a - b); }

/// Eqs. 4.8 to 4.14: the point is in the plane of the triangle.
bool within_face(const dvec3& p, const dvec3& p0, const dvec3& p1, const dvec3& p2) {
  const dvec3 area = glm::cross(p1 - p0, p2 - p0);
  const dvec3 area0 = glm::cross(p1 - p, p2 - p);
  const dvec3 area1 = glm::cross(p2 - p, p0 - p);
  const dvec3 area2 = glm::cross(p0 - p, p1 - p);
  const dvec3 size = glm::abs(area);
  const int k = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const bool positive = area[k] > 0.0;
  return (area0[k] > 0.0) == positive && (area1[k] > 0.0) == positive &&
         (area2[k] > 0.0) == positive;
}

/// Ray against triangle (Möller and Trumbore 1997).
bool ray_hits(const dvec3& origin, const dvec3& direction, const dvec3& a, const dvec3& b,
              const dvec3& c) {
  const dvec3 e1 = b - a;
  const dvec3 e2 = c - a;
  const dvec3 p = glm::cross(direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0.0) {
    return false;
  }
  const dvec3 t = origin - a;
  const double u = glm::dot(t, p) / determinant;
  const dvec3 q = glm::cross(t, e1);
  const double v = glm::dot(direction, q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && glm::dot(e2, q) / determinant > 0.0;
}

}  // namespace

ThesisTwin::ThesisTwin(const Target& target, const VoxelGrid& grid,
                       std::vector<TwinElement> elements, const PackingOptions& options)
    : elements_(std::move(elements)),
      options_(options),
      longest_side_(target.box().longest_side()) {
  for (const TwinElement& element : elements_) {
    edges_.push_back(unique_edges(element.mesh));
  }
  glm::ivec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z) {
    for (v.y = 0; v.y < grid.size.y; ++v.y) {
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        Voxel voxel{grid.sample_point(v), 0.0, dvec3(0.0), Voxel::State::outside};
        voxel.signed_distance = target.clearance(voxel.point);
        if (voxel.signed_distance >= 0.0) {
          voxel.state = Voxel::State::free;
          voxel.to_surface = target.direction_to_surface(voxel.point) * voxel.signed_distance;
        }
        voxels_.push_back(voxel);
      }
    }
  }
}

ThesisTwin::Voxel* ThesisTwin::largest_hole() {
  Voxel* largest = &voxels_.front();
  for (Voxel& voxel : voxels_) {
    if (voxel.signed_distance > largest->signed_distance) {
      largest = &voxel;
    }
  }
  return largest;
}

std::vector<Instance> ThesisTwin::run() {
  std::vector<Chooser::Candidate> candidates;
  for (const TwinElement& element : elements_) {
    candidates.push_back({element.size, {1.0}, 1.0});
  }
  const Chooser chooser(candidates, options_);
  std::vector<Instance> instances;
  Voxel* hole = largest_hole();
  while (hole->signed_distance >= options_.threshold * longest_side_) {
    Rng rng(options_.seed, placement_stream + instances.size());
    const auto choice = chooser.choose(hole->signed_distance, instances.size(), rng);
    if (!choice) {
      break;
    }
    instances.push_back(place(*hole, *choice, glm::two_pi<double>() * rng.uniform()));
    update(instances.back());
    hole = largest_hole();
  }
  return instances;
}

Instance ThesisTwin::place(const Voxel& hole, const Choice& choice, double spin_radians) const {
  const TwinElement& element = elements_[choice.element];
  Instance instance;
  instance.element = choice.element;
  instance.scale = choice.scale;
  instance.rotation =
      orientation(element.farthest_direction, glm::normalize(hole.to_surface), spin_radians);
  instance.translation = hole.point - instance.rotation * (choice.scale * element.center);
  return instance;
}

void ThesisTwin::update(const Instance& instance) {
  const TwinElement& element = elements_[instance.element];
  Placed placed{{}, element.mesh.triangles, edges_[instance.element], {}, 0.0};
  placed.center = instance.world_from_element(element.center);
  placed.radius = instance.scale * element.size;
  for (const dvec3& position : element.mesh.positions) {
    placed.vertices.push_back(instance.world_from_element(position));
  }
  flag_interior_voxels(placed);
  for (Voxel& voxel : voxels_) {
    if (voxel.state == Voxel::State::free) {
      const double d = glm::distance(voxel.point, placed.center) - placed.radius;
      if (d < voxel.signed_distance) {
        compute_closest(voxel, placed);
      }
    }
  }
}

void ThesisTwin::flag_interior_voxels(const Placed& element) {
  for (Voxel& voxel : voxels_) {
    const dvec3 offset = glm::abs(voxel.point - element.center);
    const bool in_box =
        offset.x <= element.radius && offset.y <= element.radius && offset.z <= element.radius;
    if (voxel.state == Voxel::State::free && in_box && inside(voxel.point, element)) {
      voxel.state = Voxel::State::filled;
      voxel.signed_distance = 0.0;
      ++voxels_inside_instances_;
    }
  }
}

/// IV.2.1: along one face's normal and in an arbitrary direction; the lesser number of hits counts.
bool ThesisTwin::inside(const dvec3& point, const Placed& element) {
  const uvec3& face = element.faces.front();
  const dvec3 normal = glm::cross(element.vertices[face.y] - element.vertices[face.x],
                                  element.vertices[face.z] - element.vertices[face.x]);
  std::size_t least_hits = std::numeric_limits<std::size_t>::max();
  for (const dvec3& direction : {normal, dvec3(0.2897, -0.5741, 0.7658)}) {
    std::size_t hits = 0;
    for (const uvec3& t : element.faces) {
      hits += ray_hits(point, direction, element.vertices[t.x], element.vertices[t.y],
                       element.vertices[t.z])
                  ? 1
                  : 0;
    }
    least_hits = std::min(least_hits, hits);
  }
  return least_hits % 2 == 1;
}

void ThesisTwin::compute_closest(Voxel& voxel, const Placed& element) {
  const dvec3& pt = voxel.point;
  double d = std::numeric_limits<double>::max();
  dvec3 closest(0.0);
  const auto consider = [&](const dvec3& p) {
    const double temp_d = squared_distance(pt, p);
    if (temp_d < d) {
      d = temp_d;
      closest = p;
    }
  };
  for (const dvec3& vertex : element.vertices) {
    consider(vertex);
  }
  for (const glm::uvec2& edge : element.edges) {
    const dvec3& p1 = element.vertices[edge.x];
    const dvec3 along = element.vertices[edge.y] - p1;
    const double u = glm::dot(pt - p1, along) / glm::dot(along, along);  // eq. 4.4
    if (u >= 0.0 && u <= 1.0) {
      consider(p1 + u * along);
    }
  }
  for (const uvec3& face : element.faces) {
    const dvec3& p0 = element.vertices[face.x];
    const dvec3& p1 = element.vertices[face.y];
    const dvec3& p2 = element.vertices[face.z];
    const dvec3 n = glm::normalize(glm::cross(p1 - p0, p2 - p0));
    const dvec3 p = pt + n * glm::dot(n, p0 - pt);  // eqs. 4.5 to 4.7, from either side
    if (within_face(p, p0, p1, p2)) {
      consider(p);
    }
  }
  d = std::sqrt(d);
  if (d < voxel.signed_distance) {
    voxel.signed_distance = d;
    voxel.to_surface = closest - pt;
  }
}

}  // namespace collage::test
