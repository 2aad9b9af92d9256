#include "base/memory.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"

namespace collage {

namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

std::atomic<std::uint64_t> chosen_limit{0};  // 0: none

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

std::uint64_t memory_to_take() {
  const std::uint64_t chosen = chosen_limit;
  return chosen > 0 ? chosen : available_memory() / 5 * 4;
}

void limit_memory(std::uint64_t bytes) { chosen_limit = bytes; }

std::uint64_t parse_memory(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  const std::string_view unit(result.ptr, static_cast<std::size_t>(end - result.ptr));
  const double factor = unit.empty() ? 1.0 : unit == "M" ? 1e6 : unit == "G" ? 1e9 : 0.0;
  const double bytes = number * factor;
  if (result.ec != std::errc() || !(bytes >= 1e6 && bytes <= 1e15)) {
    throw Error("'" + text + "' is not an amount of memory", "write it as 500M or 2.5G");
  }
  return static_cast<std::uint64_t>(bytes);
}

void require_memory(std::uint64_t bytes, const std::string& what, const std::string& option) {
  const auto limit = static_cast<double>(memory_to_take());
  const auto needed = static_cast<double>(bytes);
  if (needed > limit) {
    throw Error(fmt::format("{} would take {:.1f} GB of memory and {:.1f} GB may be taken", what,
                            needed / 1e9, limit / 1e9),
                "lower " + option + ", or raise --memory-limit");
  }
}

}  // namespace collage
