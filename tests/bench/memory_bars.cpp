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

/// Of packing rings into the bunny.
Bar bar(const fs::path& folder, int voxels, double threshold, double gigabytes) {
  write_file(folder / "scene.toml",
             fmt::format("[target]\nmesh = \"{}\"\nresolution = {}\n[[element]]\nmesh = "
                         "\"ring.obj\"\n[packing]\nscaling = \"to-hole\"\nthreshold = {}\n",
                         (fs::path(field_folder()) / "targets/bunny.obj").string(), voxels,
                         number_text(threshold)));
  const double peak =
      peak_gigabytes({"pack", folder.string(), "--quiet", "-o", (folder / "out").string()});
  return {fmt::format("bunny of rings, {} voxels, threshold {}: memory allowed", voxels, threshold),
          peak,
          "GB",
          gigabytes,
          peak / gigabytes,
          Bar::Side::at_most,
          1.0};
}

std::vector<Bar> memory() {
  const test::Folder folder;
  write_obj(folder / "ring.obj", test::torus_mesh(1.0, 0.27, 32, 16), "");
  return {bar(folder.path(), 400, 0.0025, 1.0), bar(folder.path(), 512, 0.05, 1.5)};
}

}  // namespace

std::vector<Group> memory_bars() { return {{"memory", memory, Group::Meshes::field}}; }

}  // namespace collage::bench
