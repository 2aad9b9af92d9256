#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace collage {

/// Memory that can be had without swapping, in bytes, within the limits set for this process
/// (`ulimit -v`) and its container; a generous guess where the system does not say.
std::uint64_t available_memory();

/// What may be taken: 80 % of the available memory, or what limit_memory() says.
std::uint64_t memory_to_take();

/// Sets that for the whole process; 0: as without.
void limit_memory(std::uint64_t bytes);

/// "500M", "2.5G" or a plain number of bytes. Throws Error for anything else.
std::uint64_t parse_memory(const std::string& text);

/// Throws Error where `bytes` for `what` are more than may be taken; the remedy names the option to
/// lower.
void require_memory(std::uint64_t bytes, const std::string& what, const std::string& option);

}  // namespace collage
