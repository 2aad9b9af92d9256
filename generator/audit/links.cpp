#include "audit/links.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <tbb/parallel_for.h>

#include "audit/batches.h"
#include "geometry/bounding_sphere.h"
#include "geometry/linking_number.h"

namespace collage {
namespace {

constexpr std::size_t most_loops = 8;

/// A loop and a ball that holds it.
struct BoundLoop {
  Loop points;
  Sphere ball;

  void move(const BoundLoop& loop, const Instance& instance) {
    points.clear();
    for (const dvec3& point : loop.points) {
      points.push_back(instance.world_from_element(point));
    }
    ball = moved(loop.ball, instance);
  }
  static Sphere moved(const Sphere& ball, const Instance& instance) {
    return {instance.world_from_element(ball.center), instance.scale * ball.radius};
  }
};

bool balls_meet(const Sphere& a, const Sphere& b) {
  const dvec3 away = a.center - b.center;
  const double reach = (1.0 + 1e-9) * (a.radius + b.radius);
  return glm::dot(away, away) <= reach * reach;
}

std::vector<BoundLoop> bound_loops(const Mesh& mesh) {
  std::vector<BoundLoop> bound;
  for (Loop& loop : handle_loops(mesh)) {
    const Sphere ball = smallest_enclosing_sphere(loop);
    bound.push_back({std::move(loop), ball});
  }
  if (bound.size() > most_loops) {
    bound.clear();
  }
  return bound;
}

/// Compares one instance with others; its memory is kept from one to the next.
class Linker {
 public:
  Linker(const std::vector<BoundLoop>& loops, const Instance& instance) : own_(loops.size()) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      own_[i].move(loops[i], instance);
    }
  }

  /// The largest linking number with another's loops, its sign aside.
  int number(const std::vector<BoundLoop>& loops, const Instance& instance) {
    int largest = 0;
    for (const BoundLoop& loop : loops) {
      const Sphere ball = BoundLoop::moved(loop.ball, instance);
      bool is_moved = false;
      for (const BoundLoop& own : own_) {
        if (!balls_meet(own.ball, ball)) {
          continue;
        }
        if (!is_moved) {
          other_.move(loop, instance);
          is_moved = true;
        }
        largest = std::max(largest, std::abs(linking_number(own.points, other_.points)));
      }
    }
    return largest;
  }

 private:
  std::vector<BoundLoop> own_;
  BoundLoop other_;
};

}  // namespace

std::optional<Links> find_links(const InstanceIndex& sculpture, Status& status) {
  std::vector<std::vector<BoundLoop>> loops;
  bool any = false;
  for (const Mesh* mesh : sculpture.elements()) {
    loops.push_back(bound_loops(*mesh));
    any = any || !loops.back().empty();
  }
  const auto instances = sculpture.instances();
  if (!any || instances.empty()) {
    return std::nullopt;
  }
  struct Link {
    std::uint32_t other;
    int number;
  };
  std::vector<std::vector<Link>> links(instances.size());
  in_batches(instances.size(), 500, "instances", status, [&](std::size_t begin, std::size_t end) {
    tbb::parallel_for(begin, end, [&](std::size_t i) {
      const auto loops_of = [&](std::size_t of) -> const auto& {
        return loops[instances[of].element];
      };
      if (loops_of(i).empty()) {
        return;
      }
      Linker linker(loops_of(i), instances[i]);
      sculpture.tree().find(sculpture.boxes()[i], [&](std::uint32_t j) {
        if (j > i) {
          const int number = linker.number(loops_of(j), instances[j]);
          if (number > 0) {
            links[i].push_back({j, number});
          }
        }
      });
    });
  });
  Links result;
  std::vector<char> linked(instances.size(), 0);
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const Link& link : links[i]) {
      ++result.pairs;
      linked[i] = linked[link.other] = 1;
      result.largest_number = std::max(result.largest_number, link.number);
    }
  }
  result.linked_share =
      static_cast<double>(std::ranges::count(linked, char{1})) / static_cast<double>(linked.size());
  return result;
}

}  // namespace collage
