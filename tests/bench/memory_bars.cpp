#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "bench/bar.h"
#include "geometry/mesh_file.h"
#include "scene/sculpture_file.h"
#include "support/folder.h"
#include "support/meshes.h"

namespace collage::bench {
namespace {

namespace fs = std::filesystem;

/// The most memory, in GB, that the program held while it ran, which it must do to its end.
double peak_gigabytes(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), COLLAGE_PROGRAM);
  std::vector<char*> argv;
  for (std::string& argument : arguments) {
    argv.push_back(argument.data());
  }
  argv.push_back(nullptr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  const pid_t child = vfork();
  if (child == 0) {
    dup2(nowhere, STDOUT_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  close(nowhere);
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) {
    throw Error(std::string(COLLAGE_PROGRAM) + " failed", "see what it says");
  }
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e9;
}

/// Rings in the bunny.
void write_scene(const fs::path& folder, int voxels, double threshold) {
  write_obj(folder / "ring.obj", test::torus_mesh(1.0, 0.27, 32, 16), "");
  write_file(folder / "scene.toml",
             fmt::format("[target]\nmesh = \"{}\"\nresolution = {}\n[[element]]\nmesh = "
                         "\"ring.obj\"\n[packing]\nfit = \"sphere\"\nscaling = \"to-hole\"\n"
                         "threshold = {}\n",
                         (fs::path(field_folder()) / "targets/bunny.obj").string(), voxels,
                         number_text(threshold)));
}

double peak_of_packing(const fs::path& folder) {
  return peak_gigabytes({"pack", folder.string(), "--quiet", "-o", (folder / "out").string()});
}

Bar bar(const std::string& name, double peak, double allowed) {
  return {name, peak, "GB", allowed, peak / allowed, Bar::Side::at_most, 1.0};
}

Bar packed(int voxels, double threshold, double allowed) {
  const test::Folder folder;
  write_scene(folder.path(), voxels, threshold);
  return bar(
      fmt::format("bunny of rings, {} voxels, threshold {}: memory allowed", voxels, threshold),
      peak_of_packing(folder.path()), allowed);
}

std::vector<Bar> memory() { return {packed(400, 0.0025, 1.0), packed(512, 0.05, 1.5)}; }

/// The audit must pass.
std::vector<Bar> million() {
  const test::Folder folder;
  write_scene(folder.path(), 600, 0.0016);
  const double packing = peak_of_packing(folder.path());
  const double auditing = peak_gigabytes({"audit", (folder / "out").string(), "--quiet"});
  const std::size_t instances = read_sculpture(folder / "out/sculpture.json").instances.size();
  if (instances < 1'000'000) {
    throw Error(fmt::format("{} instances are no million", grouped(instances)),
                "lower the threshold");
  }
  const std::string what = fmt::format("bunny of {} rings, ", grouped(instances));
  return {bar(what + "packed and written: memory allowed", packing, 6.0),
          bar(what + "audited: memory allowed", auditing, 6.0)};
}

}  // namespace

std::vector<Group> memory_bars() {
  return {{"memory", memory, Group::Meshes::field},
          {"million", million, Group::Meshes::field, Group::Named::in_full}};
}

}  // namespace collage::bench
