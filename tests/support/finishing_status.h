#pragma once

#include <atomic>

#include "base/status.h"

namespace collage::test {

/// Asks to finish from the n-th time on that it is looked at, counted from 0.
class FinishingStatus : public Status {
 public:
  explicit FinishingStatus(int looks) : left_(looks) {}
  [[nodiscard]] bool finish_requested() const override { return left_-- <= 0; }

 private:
  mutable std::atomic<int> left_;
};

}  // namespace collage::test
