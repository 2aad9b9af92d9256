#pragma once

namespace collage {

/// While one lives, Ctrl-C and SIGTERM ask for a stop instead of ending the program; the second of
/// them ends it as usual. A signal that was ignored before, as in a background job, stays ignored.
/// At most one lives at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// True once a signal came. From any thread.
  [[nodiscard]] static bool requested();
};

}  // namespace collage
