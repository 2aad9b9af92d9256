#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "base/status.h"
#include "base/text.h"

namespace collage {

/// Long work on `count` things, cut into batches: `work(begin, end)` for each in turn, which may
/// use all threads. Between batches `status` hears how far it is, and a stop throws Interrupted.
template <class Work>
void in_batches(std::size_t count, std::size_t batch, std::string_view things, Status& status,
                const Work& work) {
  for (std::size_t begin = 0; begin < count; begin += batch) {
    if (status.stop_requested()) {
      throw Interrupted();
    }
    status.update(static_cast<double>(begin) / static_cast<double>(count),
                  fmt::format("{} {}", grouped(begin), things));
    work(begin, std::min(count, begin + batch));
  }
}

}  // namespace collage
