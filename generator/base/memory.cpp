#include "base/memory.h"

#include <fstream>

#include <fmt/format.h>

#include "base/error.h"

namespace collage {

std::uint64_t available_memory() {
  std::ifstream meminfo("/proc/meminfo");
  std::string key;
  std::uint64_t kilobytes = 0;
  while (meminfo >> key >> kilobytes) {
    if (key == "MemAvailable:") {
      return kilobytes << 10;
    }
    meminfo.ignore(100, '\n');
  }
  return std::uint64_t{4} << 30;
}

void require_memory(std::uint64_t bytes, const std::string& what, const std::string& option) {
  const auto limit = static_cast<double>(available_memory()) * 0.8;
  const auto needed = static_cast<double>(bytes);
  if (needed > limit) {
    throw Error(fmt::format("{} would take {:.1f} GB of memory and {:.1f} GB can be had", what,
                            needed / 1e9, limit / 1e9),
                "lower " + option);
  }
}

}  // namespace collage
