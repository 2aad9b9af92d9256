#include "cli/stop_signals.h"

#include <csignal>

#include <gtest/gtest.h>

namespace collage {
namespace {

/// A shell starts what runs in the background with SIGINT ignored.
class StopSignalsTest : public ::testing::Test {
 protected:
  ~StopSignalsTest() override { std::signal(SIGINT, before_); }

 private:
  void (*const before_)(int) = std::signal(SIGINT, SIG_DFL);
};
using StopSignalsDeathTest = StopSignalsTest;

TEST_F(StopSignalsTest, TurnASignalIntoARequest) {
  const StopSignals signals;
  EXPECT_FALSE(StopSignals::requested());
  std::raise(SIGINT);
  EXPECT_TRUE(StopSignals::requested());
}

TEST_F(StopSignalsTest, AnOfferTakesOneCtrlC) {
  const StopSignals signals;
  {
    const FinishOffer offer;
    std::raise(SIGINT);
    EXPECT_TRUE(StopSignals::finish_requested());
    EXPECT_FALSE(StopSignals::requested());
    std::raise(SIGINT);
    EXPECT_TRUE(StopSignals::requested());
  }
}

TEST_F(StopSignalsTest, AnOfferDoesNotTakeSigtermNorWhatComesAfterIt) {
  {
    const StopSignals signals;
    const FinishOffer offer;
    std::raise(SIGTERM);
    EXPECT_TRUE(StopSignals::requested());
  }
  const StopSignals signals;
  { const FinishOffer offer; }
  std::raise(SIGINT);
  EXPECT_TRUE(StopSignals::requested());
  EXPECT_FALSE(StopSignals::finish_requested());
}

TEST_F(StopSignalsTest, ForgetAnEarlierRequest) {
  {
    const StopSignals signals;
    std::raise(SIGTERM);
  }
  const StopSignals signals;
  EXPECT_FALSE(StopSignals::requested());
}

TEST_F(StopSignalsDeathTest, EndTheProgramAtTheSecond) {
  const StopSignals signals;
  EXPECT_EXIT(
      {
        std::raise(SIGINT);
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

TEST_F(StopSignalsDeathTest, PutBackWhatWasThereBefore) {
  EXPECT_EXIT(
      {
        { const StopSignals signals; }
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST_F(StopSignalsTest, LeaveAnIgnoredSignalIgnored) {
  std::signal(SIGINT, SIG_IGN);
  const StopSignals signals;
  std::raise(SIGINT);
  EXPECT_FALSE(StopSignals::requested());
}

}  // namespace
}  // namespace collage
