#include "base/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"

namespace collage {

namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t memory_of_machine() {
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

std::uint64_t rest_of_address_space() {
  rlimit limit{};
  std::uint64_t pages = 0;
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ||
      !(std::ifstream("/proc/self/statm") >> pages)) {
    return unlimited;
  }
  const std::uint64_t used = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return limit.rlim_cur > used ? limit.rlim_cur - used : 0;
}

/// What is used of it is mostly file cache, which gives way.
std::uint64_t limit_of_container() {
  std::uint64_t limit = 0;
  return std::ifstream("/sys/fs/cgroup/memory.max") >> limit ? limit : unlimited;
}

}  // namespace

std::uint64_t available_memory() {
  return std::min({memory_of_machine(), rest_of_address_space(), limit_of_container()});
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
