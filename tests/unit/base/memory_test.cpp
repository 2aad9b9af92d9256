#include "base/memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace collage {
namespace {

class Memory : public ::testing::Test {
 protected:
  void TearDown() override { limit_memory(0); }
};

TEST_F(Memory, amounts_are_read) {
  EXPECT_EQ(parse_memory("500M"), 500'000'000U);
  EXPECT_EQ(parse_memory("2.5G"), 2'500'000'000U);
  EXPECT_EQ(parse_memory("1234567"), 1'234'567U);
  for (const char* text : {"", "M", "5", "-1G", "nan", "inf", "infG", "1e30", "5 G", "5K", "5GB"}) {
    EXPECT_THROW(parse_memory(text), Error) << text;
  }
}

TEST_F(Memory, without_a_limit_most_of_what_is_free_may_be_taken) {
  const auto free = static_cast<double>(available_memory());
  EXPECT_NEAR(static_cast<double>(memory_to_take()) / free, 0.8, 0.1);
  EXPECT_NO_THROW(require_memory(1000, "a thing", "its size"));
}

TEST_F(Memory, a_limit_holds) {
  limit_memory(2'000'000);
  EXPECT_EQ(memory_to_take(), 2'000'000U);
  EXPECT_NO_THROW(require_memory(2'000'000, "a thing", "its size"));
  try {
    require_memory(4'000'000'000, "a thing", "its size");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "a thing would take 4.0 GB of memory and 0.0 GB may be taken; lower its size, or "
                 "raise --memory-limit");
  }
}

}  // namespace
}  // namespace collage
