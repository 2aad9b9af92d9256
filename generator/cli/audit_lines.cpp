#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "cli/audit_folder.h"

namespace collage {
namespace {

using Group = AuditLine::Group;

/// "none", or how many and the first few.
std::string pairs_text(const std::vector<Audit::Pair>& pairs) {
  std::string text = pairs.empty() ? "none" : grouped(pairs.size()) + " pairs:";
  for (std::size_t i = 0; i < std::min<std::size_t>(pairs.size(), 3); ++i) {
    text += fmt::format(" {}-{}", pairs[i].first, pairs[i].second);
    if (pairs[i].depth) {
      text += fmt::format(" ({:.2g} deep)", *pairs[i].depth);
    }
  }
  return text;
}

std::string instances_text(const std::vector<std::uint32_t>& instances) {
  std::string text = instances.empty() ? "none" : grouped(instances.size()) + ":";
  for (std::size_t i = 0; i < std::min<std::size_t>(instances.size(), 5); ++i) {
    text += fmt::format(" {}", instances[i]);
  }
  return text;
}

std::string percent(double share) { return fmt::format("{:.2f} %", 100.0 * share); }
std::string number(double value) { return fmt::format("{:.3f}", value); }

std::string hole_text(const LargestHole& hole, double side) {
  return fmt::format("{:.3f} % to {:.3f} %{}", 100.0 * hole.radius / side,
                     100.0 * hole.bound / side, hole.proven ? "" : ", not proven");
}

const char* word(FolderAudit::StillFits fits) {
  switch (fits) {
    case FolderAudit::StillFits::no:
      return "no";
    case FolderAudit::StillFits::yes:
      return "yes";
    case FolderAudit::StillFits::undecided:
      break;
  }
  return "undecided";
}

void append_promises(std::vector<AuditLine>& lines, const FolderAudit& result) {
  const Audit& audit = result.audit;
  lines.push_back({Group::promise, "overlaps",
                   pairs_text(audit.overlaps) +
                       (result.distances_exact ? "" : " (not promised: distances to vertices)"),
                   "Pairs of copies whose surfaces have a point in common or one of which lies in "
                   "the other, by exact predicates."});
  lines.push_back({Group::promise, "protrusions",
                   result.target_known ? instances_text(audit.protrusions)
                                       : "not looked for: the target is no mesh",
                   "Copies whose surface meets the target's or a part of which is outside of it."});
  lines.push_back({Group::promise, "deformed", instances_text(audit.deformed),
                   "Copies that are not turned, moved and evenly scaled by an allowed factor."});
  lines.push_back(
      {Group::promise, "scene.pov agrees",
       result.scene_difference.empty() ? "yes" : result.scene_difference,
       "The rendered scene, read back, has the meshes and matrices of sculpture.json."});
}

void append_likeness(std::vector<AuditLine>& lines, const Measures& measures) {
  if (measures.silhouette_iou) {
    lines.push_back({Group::likeness, "silhouette IoU, mean", number(measures.silhouette_iou->mean),
                     "Intersection over union of the outlines of target and sculpture, mean of 42 "
                     "directions."});
    lines.push_back({Group::likeness, "silhouette IoU, worst",
                     number(measures.silhouette_iou->worst),
                     "The same from the direction where the outlines agree least."});
  }
  if (measures.surface_distance) {
    const SurfaceDistance& surface = *measures.surface_distance;
    lines.push_back(
        {Group::likeness, "surface distance, mean", percent(surface.mean),
         "From the target's surface to the nearest copy, in parts of the longest side."});
    lines.push_back({Group::likeness, "surface distance, 95 %", percent(surface.p95),
                     "95 % of the target's surface has a copy as near as this, or nearer."});
    lines.push_back({Group::likeness, "surface covered", percent(surface.share_within),
                     "Share of the target's surface with a copy within 2 % of the longest side."});
  }
}

void append_density(std::vector<AuditLine>& lines, const FolderAudit& result) {
  const Measures& measures = result.measures;
  if (measures.fill) {
    lines.push_back({Group::density, "fill by volume", percent(measures.fill->by_volume),
                     "Volume of the copies ÷ volume of the target."});
    lines.push_back({Group::density, "fill by points",
                     percent(measures.fill->by_points.share().value_or(0.0)),
                     "Share of points spread over the target that lie in a copy."});
  }
  if (measures.largest_hole) {
    lines.push_back({Group::density, "largest hole",
                     hole_text(*measures.largest_hole, measures.target_side),
                     "Radius of the largest free ball anywhere, in parts of the longest side: one "
                     "that was found, and a bound that none exceeds."});
    lines.push_back({Group::density, "an element still fits", word(result.still_fits),
                     "Whether that hole has room for an element by the scene's own rules."});
  }
}

void append_variety(std::vector<AuditLine>& lines, const Measures& measures) {
  if (measures.contacts) {
    lines.push_back({Group::variety, "floating", percent(measures.contacts->floating_share),
                     "Share of the copies with no other within 1 % of the longest side."});
    lines.push_back({Group::variety, "largest cluster",
                     percent(measures.contacts->largest_cluster_share),
                     "Share of the copies that hang together at that gap in the largest cluster."});
  }
  if (measures.links) {
    lines.push_back({Group::variety, "linked",
                     fmt::format("{} in {} pairs", percent(measures.links->linked_share),
                                 grouped(measures.links->pairs)),
                     "Share of the copies that hang in another like the links of a chain, by "
                     "linking numbers of loops through their handles."});
  }
  if (measures.orientations) {
    lines.push_back({Group::variety, "evenness of orientations",
                     fmt::format("{:.4f}, random {:.4f}", measures.orientations->evenness,
                                 measures.orientations->expected_evenness),
                     "1 for perfectly even, 0 for all alike (Bingham's scatter matrix); beside it "
                     "what as many random rotations come to."});
  }
  if (measures.sizes && measures.sizes->power_law) {
    lines.push_back({Group::variety, "exponent of sizes",
                     fmt::format("{:.2f} ± {:.2f}", measures.sizes->power_law->exponent,
                                 measures.sizes->power_law->error),
                     "α of a density of sizes falling as size^-α, by maximum likelihood."});
  }
  if (measures.kinds.clustering) {
    lines.push_back({Group::variety, "neighbours of one kind",
                     fmt::format("{:.2f} × chance", measures.kinds.clustering->ratio),
                     "How often a copy's nearest neighbour is of its own kind, against chance: "
                     "above 1 kinds cluster, below 1 they mix."});
  }
}

}  // namespace

std::vector<AuditLine> audit_lines(const FolderAudit& result) {
  std::vector<AuditLine> lines;
  append_promises(lines, result);
  append_likeness(lines, result.measures);
  append_density(lines, result);
  append_variety(lines, result.measures);
  return lines;
}

std::string verdict_sentence(const FolderAudit& result) {
  if (result.passed()) {
    return result.distances_exact
               ? "No copy overlaps another, none sticks out, none is deformed: proved by exact "
                 "arithmetic on every pair that comes near."
               : "No copy is deformed; overlaps are not ruled out, as distances were measured to "
                 "vertices only.";
  }
  std::string text = "A promise is broken:";
  for (const AuditLine& line : audit_lines(result)) {
    if (line.group == Group::promise && line.value != "none" && line.value != "yes") {
      text += fmt::format(" {}: {};", line.name, line.value);
    }
  }
  text.back() = '.';
  return text;
}

std::string audit_text(const FolderAudit& result) {
  std::string text = fmt::format("{:28}{}\n", "audit", result.passed() ? "passed" : "FAILED");
  for (const AuditLine& line : audit_lines(result)) {
    text += fmt::format("  {:26}{}\n", line.name, line.value);
  }
  return text;
}

}  // namespace collage
