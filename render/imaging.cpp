#include "render/imaging.h"

#include <dlfcn.h>

#include "base/error.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// Beside the program where that is installed, else where it was built. Never a bare name, for
/// which other folders would be looked through.
fs::path library_file() {
  std::error_code ignored;  // without /proc it is the one that was built
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  fs::path installed = program.parent_path().parent_path() / INSTALLED_IMAGING;
  return program.is_absolute() && fs::exists(installed, ignored) ? installed : BUILT_IMAGING;
}

const Imaging& opened() {
  void* const library = dlopen(library_file().c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = library != nullptr ? dlsym(library, imaging_symbol) : nullptr;
  if (function == nullptr) {
    throw Error::outside_program(
        std::string("the library for pictures cannot be loaded: ") + dlerror(),
        "install collage again, with the packages that it depends on");
  }
  return *reinterpret_cast<ImagingFunction*>(function)();
}

}  // namespace

const Imaging& imaging() {
  static const Imaging& library = opened();
  return library;
}

}  // namespace collage
