#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "base/file.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "bench/bar.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_file.h"

namespace collage::bench {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Why a group cannot be run; empty: it can.
std::string missing(const Group& group) {
  if (group.meshes == Group::Meshes::field && field_folder().empty()) {
    return "COLLAGE_FIELD_MESHES is not set";
  }
  if (group.meshes == Group::Meshes::furniture && environment("COLLAGE_MESHES").empty()) {
    return "COLLAGE_MESHES is not set";
  }
  return group.missing;
}

std::string required(const Bar& bar) {
  return fmt::format("{} {:g}{}", bar.side == Bar::Side::at_least ? "at least" : "at most", bar.bar,
                     bar.held == Bar::Held::figure ? " " + bar.unit : "");
}

std::string verdict(const Bar& bar) {
  return !bar.sound ? "NO, not sound" : bar.holds() ? "yes" : "NO";
}

void print(const Bar& bar) {
  fmt::print("{:<58} {:>10.4g} {:<14} {:>10.4g} {:>8.3g}  {:<15} {}\n", bar.name, bar.figure,
             bar.unit, bar.baseline, bar.ratio, required(bar), verdict(bar));
  std::fflush(stdout);
}

/// Names hold nothing that JSON would have escaped.
std::string json(std::span<const Bar> bars) {
  std::string text = "{\"bars\": [";
  for (const Bar& bar : bars) {
    text += fmt::format(
        "{}\n  {{\"name\": \"{}\", \"figure\": {:.6g}, \"unit\": \"{}\", \"baseline\": {:.6g}, "
        "\"ratio\": {:.6g}, \"bar\": \"{}\", \"sound\": {}, \"holds\": {}}}",
        &bar == bars.data() ? "" : ",", bar.name, bar.figure, bar.unit, bar.baseline, bar.ratio,
        required(bar), bar.sound, bar.holds());
  }
  return text + "\n]}\n";
}

int usage() {
  std::cerr << "usage: collage_bench [--json FILE] [PART OF A NAME]\n";
  return 2;
}

int run(std::span<char*> arguments) {
  std::string filter;
  std::string json_file;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string word = arguments[i];
    if (word == "--json" && i + 1 < arguments.size()) {
      json_file = arguments[++i];
    } else if (!word.starts_with("-") && filter.empty()) {
      filter = word;
    } else {
      return usage();
    }
  }
  std::vector<Group> groups;
  for (const auto& part : {update_bars, scaling_bars, signed_distance_bars, sphere_bars,
                           memory_bars, preview_bars, shape_bars}) {
    for (Group& group : part()) {
      groups.push_back(std::move(group));
    }
  }
  fmt::print("{:<58} {:>10} {:<14} {:>10} {:>8}  {:<15} {}\n", "bar", "figure", "unit", "baseline",
             "ratio", "required", "holds");
  std::vector<Bar> bars;
  for (const Group& group : groups) {
    if (group.name.find(filter) == std::string::npos ||
        (group.named == Group::Named::in_full && group.name != filter)) {
      continue;
    }
    if (const std::string reason = missing(group); !reason.empty()) {
      fmt::print("{}: skipped, as {}\n", group.name, reason);
      continue;
    }
    const Stopwatch watch;
    for (const Bar& bar : group.run()) {
      print(bar);
      bars.push_back(bar);
    }
    fmt::print("{}: {:.0f} s\n", group.name, watch.seconds());
  }
  if (!json_file.empty()) {
    write_file(json_file, json(bars));
  }
  for (const Bar& bar : bars) {
    if (!bar.holds()) {
      return 1;
    }
  }
  return 0;
}

}  // namespace

std::string field_folder() { return environment("COLLAGE_FIELD_MESHES"); }

Mesh field_mesh(const std::string& name) {
  Status status;
  Mesh mesh = read_obj(fs::path(field_folder()) / name, status).mesh;
  orient(mesh);
  return mesh;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double measure(std::size_t threads, const std::function<void()>& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const double before = processor_seconds();
  work();
  return processor_seconds() - before;
}

}  // namespace collage::bench

int main(int argc, char** argv) {
  try {
    return collage::bench::run(std::span(argv, static_cast<std::size_t>(argc)));
  } catch (const std::exception& error) {
    std::cerr << "collage_bench: " << error.what() << '\n';
    return 2;
  }
}
