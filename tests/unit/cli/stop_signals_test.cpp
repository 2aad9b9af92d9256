#include "cli/stop_signals.h"

#include <csignal>

#include <gtest/gtest.h>

namespace collage {
namespace {

TEST(StopSignals, TurnASignalIntoARequest) {
  const StopSignals signals;
  EXPECT_FALSE(StopSignals::requested());
  std::raise(SIGINT);
  EXPECT_TRUE(StopSignals::requested());
}

TEST(StopSignals, AnOfferTakesOneCtrlC) {
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

TEST(StopSignals, AnOfferDoesNotTakeSigtermNorWhatComesAfterIt) {
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

TEST(StopSignals, ForgetAnEarlierRequest) {
  {
    const StopSignals signals;
    std::raise(SIGTERM);
  }
  const StopSignals signals;
  EXPECT_FALSE(StopSignals::requested());
}

TEST(StopSignalsDeathTest, EndTheProgramAtTheSecond) {
  const StopSignals signals;
  EXPECT_EXIT(
      {
        std::raise(SIGINT);
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

TEST(StopSignalsDeathTest, PutBackWhatWasThereBefore) {
  EXPECT_EXIT(
      {
        { const StopSignals signals; }
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(StopSignals, LeaveAnIgnoredSignalIgnored) {
  auto* const before = std::signal(SIGINT, SIG_IGN);
  {
    const StopSignals signals;
    std::raise(SIGINT);
    EXPECT_FALSE(StopSignals::requested());
  }
  std::signal(SIGINT, before);
}

}  // namespace
}  // namespace collage
