#pragma once

namespace collage {

/// While one lives, Ctrl-C and SIGTERM ask for a stop instead of ending the program; the second of
/// them ends it as usual. While a FinishOffer lives, the first Ctrl-C asks to finish instead. A
/// signal that was ignored before, as in a background job, stays ignored. At most one lives at a
/// time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// True once a signal came. From any thread.
  [[nodiscard]] static bool requested();
  /// True once a FinishOffer was taken.
  [[nodiscard]] static bool finish_requested();
};

/// While one lives, work goes on that can end early with a result of use, by Ctrl-C. Once.
class FinishOffer {
 public:
  FinishOffer();
  ~FinishOffer();
  FinishOffer(const FinishOffer&) = delete;
  FinishOffer& operator=(const FinishOffer&) = delete;
};

}  // namespace collage
