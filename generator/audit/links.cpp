#include "audit/links.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include <tbb/parallel_for.h>

#include "audit/batches.h"
#include "geometry/linking_number.h"

namespace collage {
namespace {

constexpr std::size_t most_loops = 8;

std::vector<Loop> in_world(const std::vector<Loop>& loops, const Instance& instance) {
  std::vector<Loop> moved = loops;
  for (Loop& loop : moved) {
    for (dvec3& point : loop) {
      point = instance.world_from_element(point);
    }
  }
  return moved;
}

int largest_linking_number(const std::vector<Loop>& a, const std::vector<Loop>& b) {
  int largest = 0;
  for (const Loop& loop : a) {
    for (const Loop& other : b) {
      largest = std::max(largest, std::abs(linking_number(loop, other)));
    }
  }
  return largest;
}

}  // namespace

std::optional<Links> find_links(const InstanceIndex& sculpture, Status& status) {
  std::vector<std::vector<Loop>> loops;
  bool any = false;
  for (const Mesh* mesh : sculpture.elements()) {
    loops.push_back(handle_loops(*mesh));
    if (loops.back().size() > most_loops) {
      loops.back().clear();
    }
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
      const std::vector<Loop> own = in_world(loops[instances[i].element], instances[i]);
      if (own.empty()) {
        return;
      }
      sculpture.tree().find(sculpture.boxes()[i], [&](std::uint32_t j) {
        if (j > i && !loops[instances[j].element].empty()) {
          const int number =
              largest_linking_number(own, in_world(loops[instances[j].element], instances[j]));
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
