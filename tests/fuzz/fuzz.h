#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.h"

namespace collage::fuzz {

/// A file of this process in memory, for readers that take paths. Each call overwrites the last of
/// the same name.
std::filesystem::path file_with(std::string_view content, const std::string& name);

/// Bad input is refused by Error; anything else that is thrown is a finding.
template <class Action>
void accepting_errors(Action action) {
  try {
    action();
  } catch (const Error&) {
  }
}

}  // namespace collage::fuzz

/// What libFuzzer calls, defined once by each target; also called by replay.cpp.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// Defines the target: a function of the input's bytes.
#define COLLAGE_FUZZ_TARGET(input)                                                    \
  static void fuzz_one(std::string_view input);                                       \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    collage::fuzz::accepting_errors([&] {                                             \
      fuzz_one({reinterpret_cast<const char*>(data), size});                          \
    });                                                                               \
    return 0;                                                                         \
  }                                                                                   \
  static void fuzz_one(std::string_view input)
