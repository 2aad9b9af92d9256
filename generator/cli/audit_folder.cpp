#include "cli/audit_folder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/file.h"
#include "base/text.h"
#include "cli/finished_folder.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// `#if (17 < Shown[3]) object { Element_3 matrix <12 numbers> } #end` in scene.pov.
struct PovInstance {
  std::size_t number = 0;
  std::uint32_t element = 0;
  std::array<double, 12> matrix{};
};

/// Takes `prefix` off the front of `text`, or says that it is not there.
bool skip(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) {
    return false;
  }
  text.remove_prefix(prefix.size());
  return true;
}

template <class Number>
bool read_number(std::string_view& text, Number& value) {
  const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
  text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
  return error == std::errc{};
}

bool read_instance(std::string_view line, PovInstance& instance) {
  std::uint32_t shown_with = 0;
  if (!read_number(line, instance.number) || !skip(line, " < Shown[") ||
      !read_number(line, shown_with) || !skip(line, "]) object { Element_") ||
      !read_number(line, instance.element) || !skip(line, " matrix <") ||
      instance.element != shown_with) {
    return false;
  }
  for (double& number : instance.matrix) {
    if (!read_number(line, number)) {
      return false;
    }
    skip(line, ", ");
  }
  return line == "> } #end";
}

/// All instances in scene.pov by their numbers; nothing where a line cannot be read.
std::optional<std::vector<PovInstance>> read_pov_instances(std::string_view text) {
  std::vector<PovInstance> instances;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.find("object { Element_") != line.npos &&
        (!skip(line, "#if (") || !read_instance(line, instances.emplace_back()))) {
      return std::nullopt;
    }
  }
  std::ranges::sort(instances, {}, &PovInstance::number);
  return instances;
}

/// The same placement, but for the last places of double.
bool same_placement(const PovInstance& pov, const Instance& instance) {
  const dvec3 origin(0.0);
  const dvec3 translation = instance.world_from_element(origin);
  for (int column = 0; column < 4; ++column) {
    dvec3 wanted = translation;
    if (column < 3) {
      dvec3 axis(0.0);
      axis[column] = instance.scale;
      wanted = instance.rotation * axis;
    }
    for (int row = 0; row < 3; ++row) {
      const int at = 3 * column + row;
      const double got = pov.matrix[static_cast<std::size_t>(at)];
      const double size = instance.scale + (column == 3 ? glm::length(translation) : 0.0);
      if (!(std::abs(got - wanted[row]) <= 1e-12 * size)) {
        return false;
      }
    }
  }
  return true;
}

/// Whether scene.pov has every instance of the sculpture once, under its number.
bool scene_agrees(const fs::path& folder, const Sculpture& sculpture) {
  const auto lines = read_pov_instances(read_file(folder / "scene.pov"));
  if (!lines || lines->size() != sculpture.instances.size()) {
    return false;
  }
  for (std::size_t i = 0; i < lines->size(); ++i) {
    const PovInstance& pov = (*lines)[i];
    const Instance& instance = sculpture.instances[i];
    if (pov.number != i || pov.element != instance.element || !same_placement(pov, instance)) {
      return false;
    }
  }
  return true;
}

/// "none", or how many and the first few.
std::string overlap_text(const std::vector<Audit::Pair>& pairs) {
  std::string text = pairs.empty() ? "none" : grouped(pairs.size()) + " pairs:";
  for (std::size_t i = 0; i < std::min<std::size_t>(pairs.size(), 5); ++i) {
    text += fmt::format(" {}-{}", pairs[i].first, pairs[i].second);
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

}  // namespace

FolderAudit audit_folder(const fs::path& folder, Status& status) {
  const FinishedFolder finished = read_finished_folder(folder, status);
  const Scene& scene = finished.sculpture.options;
  AuditInput input;
  input.target = finished.target ? &*finished.target : nullptr;
  for (std::size_t e = 0; e < finished.elements.size(); ++e) {
    const bool fixed = scene.packing.scaling == Scaling::fixed;
    input.elements.push_back(&finished.elements[e]);
    input.scales.push_back(fixed ? scene.elements[e].scales : std::vector<double>{});
  }
  input.instances = finished.sculpture.instances;
  FolderAudit result;
  result.instances = finished.sculpture.instances.size();
  result.audit = audit(input, status);
  result.scene_agrees = scene_agrees(folder, finished.sculpture);
  result.distances_exact = scene.packing.distance == Distance::exact;
  result.target_known = finished.target.has_value();
  return result;
}

std::string audit_text(const FolderAudit& result) {
  const char* verdict = result.passed() ? "passed" : "FAILED";
  return fmt::format(
      "audit                   {}\n"
      "  overlaps              {}{}\n"
      "  protrusions           {}\n"
      "  deformed              {}\n"
      "  scene.pov agrees      {}\n",
      verdict, overlap_text(result.audit.overlaps),
      result.distances_exact ? "" : " (not promised: distances to vertices)",
      result.target_known ? instances_text(result.audit.protrusions)
                          : "not looked for: the target is no mesh",
      instances_text(result.audit.deformed), result.scene_agrees ? "yes" : "no");
}

std::string audit_json(const FolderAudit& result) {
  return fmt::format(
      R"({{"passed": {}, "instances": {}, "overlaps": {}, "protrusions": {}, "rigid": {}, )"
      R"("scene_agrees": {}}})"
      "\n",
      result.passed(), result.instances, result.audit.overlaps.size(),
      result.target_known ? std::to_string(result.audit.protrusions.size()) : "null",
      result.audit.deformed.empty(), result.scene_agrees);
}

}  // namespace collage
