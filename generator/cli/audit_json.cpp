#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "cli/audit_folder.h"

namespace collage {
namespace {

/// Members of a JSON object, one a line.
class JsonObject {
 public:
  void add(const char* name, const std::string& value) {
    text_ += fmt::format("{}\n  \"{}\": {}", text_.empty() ? "" : ",", name, value);
  }
  void add(const char* name, double value) { add(name, number_text(value)); }
  void add(const char* name, bool value) { add(name, std::string(value ? "true" : "false")); }
  void add(const char* name, std::size_t value) { add(name, std::to_string(value)); }
  /// null where there is nothing.
  template <class Measure, class Value>
  void add(const char* name, const std::optional<Measure>& measure, Value value) {
    if (measure) {
      add(name, value(*measure));
    } else {
      add(name, std::string("null"));
    }
  }

  [[nodiscard]] std::string text() const { return "{" + text_ + "\n}\n"; }

 private:
  std::string text_;
};

std::string pairs_json(const std::vector<Audit::Pair>& pairs) {
  std::string text;
  for (std::size_t i = 0; i < std::min(pairs.size(), Audit::depths_measured); ++i) {
    text += fmt::format(R"({}{{"first": {}, "second": {}, "depth": {}}})", i == 0 ? "" : ", ",
                        pairs[i].first, pairs[i].second, number_text(pairs[i].depth.value_or(0.0)));
  }
  return "[" + text + "]";
}

std::string list_json(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string vector_json(const dvec3& v) {
  return list_json({number_text(v.x), number_text(v.y), number_text(v.z)});
}

std::string shells_json(const Fill& fill) {
  std::vector<std::string> shares;
  for (const Fill::Sample& shell : fill.by_shell) {
    const auto share = shell.share();
    shares.push_back(share ? number_text(*share) : "null");
  }
  return list_json(shares);
}

void add_promises(JsonObject& json, const FolderAudit& result) {
  const Audit& audit = result.audit;
  json.add("passed", result.passed());
  json.add("instances", result.instances);
  json.add("overlaps", audit.overlaps.size());
  json.add("overlapping_pairs", pairs_json(audit.overlaps));
  json.add("protrusions", result.target_known ? std::to_string(audit.protrusions.size()) : "null");
  json.add("protruding", fmt::format("[{}]", fmt::join(audit.protrusions, ", ")));
  json.add("rigid", audit.deformed.empty() && result.scene_difference.empty());
  json.add("deformed", fmt::format("[{}]", fmt::join(audit.deformed, ", ")));
  json.add("scene_agrees", result.scene_difference.empty());
}

void add_hole(JsonObject& json, const FolderAudit& result) {
  const Measures& measures = result.measures;
  const auto& hole = measures.largest_hole;
  const double side = measures.target_side;
  json.add("largest_hole", hole, [&](const LargestHole& h) { return h.radius / side; });
  json.add("largest_hole_bound", hole, [&](const LargestHole& h) { return h.bound / side; });
  json.add("largest_hole_proven", hole, [](const LargestHole& h) { return h.proven; });
  json.add("largest_hole_center", hole, [](const LargestHole& h) { return vector_json(h.center); });
  json.add("element_still_fits",
           std::string(result.still_fits == FolderAudit::StillFits::undecided ? "null"
                       : result.still_fits == FolderAudit::StillFits::yes     ? "true"
                                                                              : "false"));
}

void add_likeness(JsonObject& json, const Measures& measures) {
  json.add("silhouette_iou", measures.silhouette_iou, [](const Silhouette& s) {
    return fmt::format(R"({{"mean": {}, "worst": {}, "worst_direction": {}}})", number_text(s.mean),
                       number_text(s.worst), vector_json(s.worst_direction));
  });
  json.add("surface_distance", measures.surface_distance, [](const SurfaceDistance& s) {
    return fmt::format(R"({{"mean": {}, "p95": {}, "share_within_0.02": {}}})", number_text(s.mean),
                       number_text(s.p95), number_text(s.share_within));
  });
}

void add_variety(JsonObject& json, const Measures& measures) {
  const auto& contacts = measures.contacts;
  json.add("floating_share", contacts, [](const Contacts& c) { return c.floating_share; });
  json.add("clusters", contacts, [](const Contacts& c) { return std::size_t{c.clusters}; });
  json.add("largest_cluster_share", contacts,
           [](const Contacts& c) { return c.largest_cluster_share; });
  json.add("linked_pairs", measures.links, [](const Links& l) { return std::size_t{l.pairs}; });
  json.add("linked_share", measures.links, [](const Links& l) { return l.linked_share; });
  const auto& turned = measures.orientations;
  json.add("orientation_evenness", turned, [](const Orientations& o) { return o.evenness; });
  json.add("orientation_evenness_of_random", turned,
           [](const Orientations& o) { return o.expected_evenness; });
  const auto law = measures.sizes ? measures.sizes->power_law : std::nullopt;
  json.add("size_exponent", law, [](const Sizes::PowerLaw& p) { return p.exponent; });
  json.add("size_exponent_error", law, [](const Sizes::PowerLaw& p) { return p.error; });
  json.add("kinds", fmt::format("[{}]", fmt::join(measures.kinds.counts, ", ")));
  json.add("kind_clustering", measures.kinds.clustering,
           [](const Kinds::Clustering& c) { return c.ratio; });
}

void add_fill(JsonObject& json, const Measures& measures) {
  json.add("fill", measures.fill, [](const Fill& f) { return f.by_volume; });
  json.add("fill_by_points", measures.fill,
           [](const Fill& f) { return f.by_points.share().value_or(0.0); });
  json.add("fill_by_shell", measures.fill, shells_json);
}

}  // namespace

std::string audit_json(const FolderAudit& result) {
  JsonObject json;
  add_promises(json, result);
  add_hole(json, result);
  add_likeness(json, result.measures);
  add_variety(json, result.measures);
  add_fill(json, result.measures);
  return json.text();
}

}  // namespace collage
