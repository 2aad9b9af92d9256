#pragma once

#include <string_view>

#include "base/status.h"

namespace collage {

/// A stage of the work as an object: begins with it and ends with it, whichever way that is left.
class Stage {
 public:
  Stage(Status& status, std::string_view name) : status_(status) { status_.begin(name); }
  ~Stage() { status_.end(); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

 private:
  Status& status_;
};

}  // namespace collage
