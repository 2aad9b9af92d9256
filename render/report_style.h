#pragma once

#include <string_view>

namespace collage {

/// The style sheet of report_html()'s pages, but for their plots.
std::string_view report_style();

}  // namespace collage
