#pragma once

#include <span>

#include <gtest/gtest.h>

#include "geometry/instance.h"

namespace collage::test {

/// To the last bit.
inline void expect_same_instances(std::span<const Instance> a, std::span<const Instance> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].element, b[i].element) << i;
    ASSERT_EQ(a[i].scale, b[i].scale) << i;
    ASSERT_EQ(a[i].rotation, b[i].rotation) << i;
    ASSERT_EQ(a[i].translation, b[i].translation) << i;
  }
}

}  // namespace collage::test
