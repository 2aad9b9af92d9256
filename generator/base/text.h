#pragma once

#include <cstdint>
#include <string>

namespace collage {

/// Appends the shortest text that reads back as the same double, "1.5", "-0.001", "1e+30".
/// `value` must be finite.
void append_number(std::string& text, double value);
std::string number_text(double value);

/// "334,972": for people, not for files.
std::string grouped(std::uint64_t value);

}  // namespace collage
