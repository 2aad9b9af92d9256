#include "cli/stop_signals.h"

#include <array>
#include <atomic>
#include <csignal>

namespace collage {
namespace {

constexpr std::array signals{SIGINT, SIGTERM};

std::atomic<bool> stop{false};
std::atomic<bool> finish{false};
std::atomic<bool> finish_offered{false};
static_assert(std::atomic<bool>::is_always_lock_free, "else not allowed in a signal handler");

std::array<struct sigaction, signals.size()> before;

void request_stop(int signal) {
  if (signal == SIGINT && finish_offered.exchange(false)) {
    finish = true;
    return;
  }
  stop = true;
  struct sigaction by_default {};
  by_default.sa_handler = SIG_DFL;
  for (const int each : signals) {
    sigaction(each, &by_default, nullptr);
  }
}

}  // namespace

StopSignals::StopSignals() {
  stop = false;
  finish = false;
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESTART;  // libraries that read and write files need not know of it
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &before[i]);
    if (before[i].sa_handler != SIG_IGN) {
      sigaction(signals[i], &action, nullptr);
    }
  }
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], &before[i], nullptr);
  }
}

bool StopSignals::requested() { return stop; }

bool StopSignals::finish_requested() { return finish; }

FinishOffer::FinishOffer() { finish_offered = true; }

FinishOffer::~FinishOffer() { finish_offered = false; }

}  // namespace collage
