#pragma once

namespace collage {

inline constexpr const char* version = COLLAGE_VERSION;

}  // namespace collage
