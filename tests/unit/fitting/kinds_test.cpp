#include "fitting/kinds.h"

#include <gtest/gtest.h>

namespace collage {
namespace {

TEST(Outlook, LearnsWhatSixInTenStayBelow) {
  Outlook outlook;
  for (int i = 0; i < 100; ++i) {
    outlook.learn(2.0 + 0.01 * i);
  }
  EXPECT_NEAR(outlook.ratio(), 2.6, 1e-9);
}

/// In a thin target every hole looks hopeless to a slender element, before one was tried.
TEST(Outlook, HasNoHopelessHoleBeforeSomeWereTried) {
  Outlook outlook;
  EXPECT_FALSE(outlook.is_hopeless(0.01, 1.0));
  for (int i = 0; i < 100; ++i) {
    outlook.learn(5.0);
  }
  EXPECT_TRUE(outlook.is_hopeless(0.01, 1.0));
  EXPECT_FALSE(outlook.is_hopeless(0.15, 1.0));
}

}  // namespace
}  // namespace collage
