#include "audit/contacts.h"

#include <algorithm>
#include <vector>

#include <tbb/parallel_for.h>

#include "audit/batches.h"
#include "audit/surfaces_within.h"
#include "geometry/shapes_of.h"
#include "geometry/topology.h"

namespace collage {
namespace {

/// Instances between two updates of the clusters. Within a batch no instance knows of the others'
/// contacts, which costs tests of pairs that turn out to hang together anyway.
constexpr std::size_t batch = 1000;

class Clusters {
 public:
  Clusters(const InstanceIndex& sculpture, double gap)
      : sculpture_(sculpture),
        gap_(gap),
        shapes_(shapes_of<SurfaceTree>(sculpture.elements())),
        sets_(sculpture.instances().size()),
        roots_(sculpture.instances().size()) {}

  void find(Status& status) {
    std::vector<std::vector<std::uint32_t>> touching(roots_.size());
    in_batches(roots_.size(), batch, "instances", status, [&](std::size_t begin, std::size_t end) {
      update_roots(end);
      tbb::parallel_for(begin, end, [&](std::size_t i) {
        touching[i] = clusters_touched_by(static_cast<std::uint32_t>(i));
      });
      for (std::size_t i = begin; i < end; ++i) {
        for (const std::uint32_t root : touching[i]) {
          sets_.unite(static_cast<std::uint32_t>(i), root);
        }
      }
    });
    update_roots(roots_.size());
  }

  [[nodiscard]] std::vector<std::uint64_t> sizes() const {
    std::vector<std::uint64_t> sizes(roots_.size());
    for (const std::uint32_t root : roots_) {
      ++sizes[root];
    }
    std::erase(sizes, 0U);
    return sizes;
  }

 private:
  void update_roots(std::size_t end) {
    for (std::uint32_t i = 0; i < end; ++i) {
      roots_[i] = sets_.find(i);
    }
  }

  [[nodiscard]] bool touch(std::uint32_t i, std::uint32_t j) const {
    const Instance& a = sculpture_.instances()[i];
    const Instance& b = sculpture_.instances()[j];
    return surfaces_within(gap_, *shapes_[a.element], a, *shapes_[b.element], b);
  }

  /// Of the instances before i that it touches, one of each cluster as these are known so far.
  [[nodiscard]] std::vector<std::uint32_t> clusters_touched_by(std::uint32_t i) const {
    const Box& box = sculpture_.boxes()[i];
    std::vector<std::uint32_t> touched;
    sculpture_.tree().find({box.min - gap_, box.max + gap_}, [&](std::uint32_t j) {
      if (j < i && std::find(touched.begin(), touched.end(), roots_[j]) == touched.end() &&
          touch(i, j)) {
        touched.push_back(roots_[j]);
      }
    });
    return touched;
  }

  const InstanceIndex& sculpture_;
  double gap_;
  std::vector<std::shared_ptr<const SurfaceTree>> shapes_;
  DisjointSets sets_;
  /// Of each instance its set's smallest member, as the sets were before the batch.
  std::vector<std::uint32_t> roots_;
};

}  // namespace

std::optional<Contacts> contacts(const InstanceIndex& sculpture, double gap, Status& status) {
  if (sculpture.instances().empty()) {
    return std::nullopt;
  }
  Clusters clusters(sculpture, gap);
  clusters.find(status);
  const std::vector<std::uint64_t> sizes = clusters.sizes();
  const auto n = static_cast<double>(sculpture.instances().size());
  const auto alone = std::count(sizes.begin(), sizes.end(), 1U);
  const std::uint64_t largest = *std::max_element(sizes.begin(), sizes.end());
  return Contacts{gap, sizes.size(), static_cast<double>(alone) / n,
                  static_cast<double>(largest) / n};
}

}  // namespace collage
