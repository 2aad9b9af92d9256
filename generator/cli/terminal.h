#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"

namespace collage {

/// What a Terminal needs from outside; tests give their own.
struct Console {
  std::function<void(std::string_view)> write;
  std::function<double()> seconds;  // a clock that never goes back, from any start
  std::function<int()> columns;     // asked at each redraw, as windows change
  std::function<bool()> stop_requested;
};

struct TerminalStyle {
  enum class Verbosity { quiet, normal, verbose };
  enum class Kind { screen, log };  // a log gets whole lines only, and few of them
  enum class Letters { ascii, unicode };
  enum class Colours { off, on };

  Verbosity verbosity = Verbosity::normal;
  Kind kind = Kind::log;
  Letters letters = Letters::ascii;
  Colours colours = Colours::off;
};

/// Standard error, the steady clock and StopSignals.
Console standard_error_console();

/// What suits standard error: a screen where it is a terminal that can move its cursor, Unicode
/// where the locale is UTF-8, colours on a screen unless NO_COLOR is set.
TerminalStyle standard_error_style(TerminalStyle::Verbosity verbosity);

/// Seconds until the end of a stage, from how far it is: smoothed, so that the number shown counts
/// down and does not jump.
class RemainingTime {
 public:
  /// `fraction` of the stage is done `elapsed_seconds` after its beginning; neither goes back.
  void update(double elapsed_seconds, double fraction);
  /// Nothing in the first second, and nothing before a hundredth is done.
  [[nodiscard]] std::optional<double> seconds() const;

 private:
  double elapsed_seconds_ = 0.0;
  double fraction_ = 0.0;
  std::optional<double> remaining_seconds_;
};

/// "0:07", "12:30", "1:02:03"; "0.3 s" below one second.
std::string duration_text(double seconds);

/// Status for people. On a screen one line that is redrawn at most ten times a second,
///   packing  ████████░░░░  62 %  1,204 instances  0:12, about 0:07 left
/// and "packing  done in 0:19" at its end; a stage shorter than half a second leaves a line only if
/// verbose. In a log a line after two seconds and then every ten. Quiet prints only errors.
class Terminal : public Status {
 public:
  Terminal(TerminalStyle style, Console console);
  ~Terminal() override;
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void begin(std::string_view stage) override;
  void update(double fraction, std::string_view detail) override;
  void end() override;
  void note(std::string_view line) override;
  [[nodiscard]] bool stop_requested() const override { return console_.stop_requested(); }

  /// "error: …", also when quiet. Ends the stage, if there is one, without a word.
  void error(std::string_view line);
  /// Removes a half-done progress line, before others write to the same screen. Ends the stage.
  void clear();

 private:
  struct Stage {
    std::string name;
    double begin_seconds = 0.0;
    double next_line_seconds = 0.0;  // no line before this time
    double fraction = 0.0;
    bool shown = false;  // a progress line was written
    RemainingTime remaining;
  };

  [[nodiscard]] std::string progress_line(std::string_view detail, double elapsed_seconds) const;
  [[nodiscard]] std::string coloured(std::string_view text, const char* code) const;
  void erase_line();
  void write_line(const std::string& line);

  TerminalStyle style_;
  Console console_;
  std::optional<Stage> stage_;
};

}  // namespace collage
