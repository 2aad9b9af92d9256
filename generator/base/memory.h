#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace collage {

/// Memory that can be had without swapping, in bytes, within the limits set for this process
/// (`ulimit -v`) and its container; a generous guess where the system does not say.
std::uint64_t available_memory();

/// Throws Error where `bytes` for `what` are over 80 % of the available memory; the remedy names
/// the option to lower.
void require_memory(std::uint64_t bytes, const std::string& what, const std::string& option);

}  // namespace collage
