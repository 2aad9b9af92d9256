#include "audit/audit.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "audit/audit_shape.h"
#include "audit/penetration.h"
#include "base/error.h"
#include "base/text.h"

namespace collage {
namespace {

/// Instances looked at between two looks at the clock.
constexpr std::size_t batch = 2000;

class Auditor {
 public:
  Auditor(const AuditInput& input, Status& status) : input_(input), status_(status) {
    for (const Mesh* mesh : input.elements) {
      shapes_.push_back(std::make_unique<AuditShape>(*mesh));
    }
    if (input.target != nullptr) {
      target_ = std::make_unique<AuditShape>(*input.target);
    }
  }

  Audit run();

 private:
  [[nodiscard]] const AuditShape& shape(std::size_t i) const {
    return *shapes_[input_.instances[i].element];
  }
  void measure_depths(std::vector<Audit::Pair>& pairs) const;
  [[nodiscard]] bool overlap(std::size_t i, std::size_t j) const;
  [[nodiscard]] bool protrudes(std::size_t i) const;
  [[nodiscard]] bool deformed(std::size_t i) const;
  void look_for_overlaps(std::size_t i, const BoxTree& tree, const std::vector<Box>& boxes,
                         std::vector<std::uint32_t>& found) const;

  const AuditInput& input_;
  Status& status_;
  std::vector<std::unique_ptr<AuditShape>> shapes_;
  std::unique_ptr<AuditShape> target_;
};

Audit Auditor::run() {
  const std::size_t count = input_.instances.size();
  std::vector<Box> boxes(count);
  tbb::parallel_for(std::size_t{0}, count,
                    [&](std::size_t i) { boxes[i] = world_box(shape(i), input_.instances[i]); });
  const BoxTree tree(boxes);
  std::vector<std::vector<std::uint32_t>> overlapping(count);
  std::vector<char> protruding(count, 0);
  for (std::size_t begin = 0; begin < count; begin += batch) {
    if (status_.stop_requested()) {
      throw Interrupted();
    }
    const std::size_t end = std::min(count, begin + batch);
    status_.update(static_cast<double>(begin) / static_cast<double>(count),
                   fmt::format("{} instances", grouped(begin)));
    tbb::parallel_for(begin, end, [&](std::size_t i) {
      look_for_overlaps(i, tree, boxes, overlapping[i]);
      protruding[i] = protrudes(i) ? 1 : 0;
    });
  }
  Audit result;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const std::uint32_t j : overlapping[i]) {
      result.overlaps.push_back({i, j, std::nullopt});
    }
    if (protruding[i] != 0) {
      result.protrusions.push_back(i);
    }
    if (deformed(i)) {
      result.deformed.push_back(i);
    }
  }
  measure_depths(result.overlaps);
  return result;
}

void Auditor::measure_depths(std::vector<Audit::Pair>& pairs) const {
  tbb::parallel_for(
      std::size_t{0}, std::min(pairs.size(), Audit::depths_measured), [&](std::size_t p) {
        Audit::Pair& pair = pairs[p];
        pair.depth = penetration_depth(shape(pair.first), input_.instances[pair.first],
                                       shape(pair.second), input_.instances[pair.second]);
      });
}

/// Each pair once, with the later instance second.
void Auditor::look_for_overlaps(std::size_t i, const BoxTree& tree, const std::vector<Box>& boxes,
                                std::vector<std::uint32_t>& found) const {
  tree.find(boxes[i], [&](std::uint32_t j) {
    if (j > i && overlap(i, j)) {
      found.push_back(j);
    }
  });
  std::sort(found.begin(), found.end());
}

bool Auditor::overlap(std::size_t i, std::size_t j) const {
  const Instance& a = input_.instances[i];
  const Instance& b = input_.instances[j];
  return surfaces_meet(shape(i), a, shape(j), b) || lies_inside(shape(i), a, shape(j), b) ||
         lies_inside(shape(j), b, shape(i), a);
}

bool Auditor::protrudes(std::size_t i) const {
  if (!target_) {
    return false;
  }
  const Instance& instance = input_.instances[i];
  return surfaces_meet(*target_, Instance{}, shape(i), instance) ||
         lies_outside(*target_, shape(i), instance);
}

bool Auditor::deformed(std::size_t i) const {
  const Instance& instance = input_.instances[i];
  const auto& allowed = input_.scales[instance.element];
  const bool scale_allowed =
      allowed.empty() || std::find(allowed.begin(), allowed.end(), instance.scale) != allowed.end();
  return !(std::abs(glm::length(instance.rotation) - 1.0) <= 1e-9) || !(instance.scale > 0.0) ||
         !scale_allowed;
}

}  // namespace

Audit audit(const AuditInput& input, Status& status) { return Auditor(input, status).run(); }

}  // namespace collage
