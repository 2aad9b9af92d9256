#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace collage {

/// Cuts a stream into lines at \n and \r, as programs write their progress; empty lines are left
/// out. A line longer than `max_bytes` arrives in pieces, so that memory stays bounded.
class LineSplitter {
 public:
  static constexpr std::size_t max_bytes = 65536;

  explicit LineSplitter(std::function<void(std::string_view)> on_line)
      : on_line_(std::move(on_line)) {}

  void append(std::string_view bytes);
  /// Hands out a last line without an end.
  void finish();

 private:
  std::function<void(std::string_view)> on_line_;
  std::string line_;
};

}  // namespace collage
