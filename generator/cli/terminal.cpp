#include "cli/terminal.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "cli/stop_signals.h"

namespace collage {
namespace {

constexpr double screen_delay_seconds = 0.5;
constexpr double screen_interval_seconds = 0.1;
constexpr double log_delay_seconds = 2.0;
constexpr double log_interval_seconds = 10.0;
constexpr int widest_bar = 24;
constexpr int narrowest_bar = 8;

constexpr const char* bold = "1";
constexpr const char* red = "1;31";
constexpr const char* yellow = "33";
constexpr const char* cyan = "36";
constexpr const char* erase_whole_line = "\r\x1b[K";

/// Bytes of the UTF-8 character that starts with `lead`; 1 for what is not UTF-8.
std::size_t character_bytes(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  return byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : byte >= 0xc0 ? 2 : 1;
}

/// Columns of a character: those of East Asian scripts and pictographs, from U+1100 on the Hangul
/// and from U+2E80 on nearly all others, take two.
int character_columns(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 4) {
    return 2;
  }
  if (character.size() < 3) {
    return 1;
  }
  const int code = (byte(0) & 0x0f) << 12 | (byte(1) & 0x3f) << 6 | (byte(2) & 0x3f);
  const bool wide = (code >= 0x1100 && code < 0x1160) || (code >= 0x2e80 && code < 0xd7b0) ||
                    (code >= 0xf900 && code < 0xfb00) || (code >= 0xfe30 && code < 0xfe70) ||
                    (code >= 0xff00 && code < 0xff61);
  return wide ? 2 : 1;
}

template <class Visitor>
void for_each_character(std::string_view text, Visitor visit) {
  while (!text.empty()) {
    const std::size_t bytes = std::min(character_bytes(text.front()), text.size());
    visit(text.substr(0, bytes));
    text.remove_prefix(bytes);
  }
}

int columns_of(std::string_view text) {
  int columns = 0;
  for_each_character(text, [&](std::string_view c) { columns += character_columns(c); });
  return columns;
}

/// The start of `text` that fits, with `ellipsis` at its end where something is left out.
std::string shortened(std::string_view text, int columns, std::string_view ellipsis) {
  if (columns_of(text) <= columns) {
    return std::string(text);
  }
  const int room = columns - columns_of(ellipsis);
  if (room <= 0) {
    return "";
  }
  std::string start;
  int used = 0;
  for_each_character(text, [&](std::string_view c) {
    used += character_columns(c);
    if (used <= room) {
      start += c;
    }
  });
  return start + std::string(ellipsis);
}

/// Names come from outside: no control character of theirs reaches the terminal, neither one byte
/// long nor, as U+0080 to U+009F are in UTF-8, two.
std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
    const bool two_byte_control = byte == 0xc2 && next >= 0x80 && next < 0xa0;
    i += two_byte_control ? 1 : 0;
    result += byte < 0x20 || byte == 0x7f || two_byte_control ? '?' : static_cast<char>(byte);
  }
  return result;
}

/// An estimate that does not flicker: by the second up to a minute, then by five.
double rounded_estimate(double seconds) {
  const double step = seconds < 60.0 ? 1.0 : 5.0;
  return std::max(1.0, std::ceil(seconds / step) * step);
}

bool is_utf8_locale() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') {
      continue;
    }
    std::string letters;
    for (const char* c = value; *c != '\0'; ++c) {
      if (*c != '-') {
        letters += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
      }
    }
    return letters.find("utf8") != std::string::npos;
  }
  return false;
}

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

}  // namespace

Console standard_error_console() {
  Console console;
  console.write = [](std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
  };
  console.seconds = [stopwatch = Stopwatch()] { return stopwatch.seconds(); };
  console.columns = [] {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
  };
  console.stop_requested = [] { return StopSignals::requested(); };
  return console;
}

TerminalStyle standard_error_style(TerminalStyle::Verbosity verbosity) {
  const char* kind = std::getenv("TERM");
  const bool can_move = kind != nullptr && *kind != '\0' && std::string_view(kind) != "dumb";
  const bool screen = ::isatty(STDERR_FILENO) == 1 && can_move;
  TerminalStyle style;
  style.verbosity = verbosity;
  style.kind = screen ? TerminalStyle::Kind::screen : TerminalStyle::Kind::log;
  style.letters =
      is_utf8_locale() ? TerminalStyle::Letters::unicode : TerminalStyle::Letters::ascii;
  style.colours =
      screen && !is_set("NO_COLOR") ? TerminalStyle::Colours::on : TerminalStyle::Colours::off;
  return style;
}

void RemainingTime::update(double elapsed_seconds, double fraction) {
  constexpr double smoothing_seconds = 5.0;
  const double step = std::max(0.0, elapsed_seconds - elapsed_seconds_);
  elapsed_seconds_ = elapsed_seconds;
  fraction_ = fraction;
  if (fraction <= 0.0) {
    return;
  }
  const double measured = elapsed_seconds * (1.0 - fraction) / fraction;
  if (!remaining_seconds_ || elapsed_seconds < 1.0) {
    remaining_seconds_ = measured;
    return;
  }
  const double counted_down = std::max(0.0, *remaining_seconds_ - step);
  const double weight = std::min(1.0, step / smoothing_seconds);
  remaining_seconds_ = counted_down + (measured - counted_down) * weight;
}

std::optional<double> RemainingTime::seconds() const {
  const bool known = elapsed_seconds_ >= 1.0 && fraction_ >= 0.01 && fraction_ < 1.0;
  return known ? remaining_seconds_ : std::nullopt;
}

std::string duration_text(double seconds) {
  if (seconds < 1.0) {
    const int tenths = static_cast<int>(std::max(0.0, seconds) * 10.0);
    return "0." + std::to_string(tenths) + " s";
  }
  const auto whole = static_cast<long long>(seconds);
  const auto two_digits = [](long long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
  const long long hours = whole / 3600;
  const long long minutes = whole / 60 % 60;
  return (hours > 0 ? std::to_string(hours) + ":" + two_digits(minutes) : std::to_string(minutes)) +
         ":" + two_digits(whole % 60);
}

Terminal::Terminal(TerminalStyle style, Console console)
    : style_(style), console_(std::move(console)) {}

Terminal::~Terminal() { clear(); }

void Terminal::begin(std::string_view stage) {
  clear();
  const double now = console_.seconds();
  const bool screen = style_.kind == TerminalStyle::Kind::screen;
  const double delay = screen ? screen_delay_seconds : log_delay_seconds;
  stage_ = Stage{.name = printable(stage),
                 .begin_seconds = now,
                 .next_line_seconds = now + delay,
                 .remaining = {}};
}

void Terminal::update(double fraction, std::string_view detail) {
  if (!stage_ || style_.verbosity == TerminalStyle::Verbosity::quiet) {
    return;
  }
  const double now = console_.seconds();
  if (now < stage_->next_line_seconds) {
    return;
  }
  const bool screen = style_.kind == TerminalStyle::Kind::screen;
  stage_->next_line_seconds = now + (screen ? screen_interval_seconds : log_interval_seconds);
  // Written so that a NaN changes nothing.
  stage_->fraction = fraction > stage_->fraction ? std::min(fraction, 1.0) : stage_->fraction;
  stage_->remaining.update(now - stage_->begin_seconds, stage_->fraction);
  stage_->shown = true;
  const std::string line = progress_line(printable(detail), now - stage_->begin_seconds);
  console_.write(screen ? "\r" + line + "\x1b[K" : line + "\n");
}

void Terminal::end() {
  if (!stage_) {
    return;
  }
  erase_line();
  const double elapsed_seconds = console_.seconds() - stage_->begin_seconds;
  const bool screen = style_.kind == TerminalStyle::Kind::screen;
  const bool long_enough = elapsed_seconds >= (screen ? screen_delay_seconds : log_delay_seconds);
  if (style_.verbosity == TerminalStyle::Verbosity::verbose ||
      (style_.verbosity == TerminalStyle::Verbosity::normal && (stage_->shown || long_enough))) {
    write_line(coloured(stage_->name, bold) + "  done in " + duration_text(elapsed_seconds));
  }
  stage_.reset();
}

void Terminal::note(std::string_view line) {
  if (style_.verbosity != TerminalStyle::Verbosity::quiet) {
    erase_line();
    write_line(coloured("note:", yellow) + " " + printable(line));
  }
}

void Terminal::error(std::string_view line) {
  clear();
  write_line(coloured("error:", red) + " " + printable(line));
}

void Terminal::clear() {
  erase_line();
  stage_.reset();
}

std::string Terminal::progress_line(std::string_view detail, double elapsed_seconds) const {
  const bool screen = style_.kind == TerminalStyle::Kind::screen;
  const bool unicode = style_.letters == TerminalStyle::Letters::unicode;
  const std::string_view ellipsis = unicode ? "…" : "...";

  std::string percent = std::to_string(static_cast<int>(stage_->fraction * 100.0)) + " %";
  percent.insert(0, 5 - percent.size(), ' ');
  std::string time = duration_text(elapsed_seconds);
  if (const auto remaining = stage_->remaining.seconds()) {
    time += ", about " + duration_text(rounded_estimate(*remaining)) + " left";
  }
  const std::string name = stage_->name;
  const std::string before = " " + percent;
  const auto after = [&](std::string_view words) {
    return (words.empty() ? "" : "  " + std::string(words)) + "  " + time;
  };
  if (!screen) {
    return name + before + after(detail);
  }

  const int room = console_.columns() - 1;  // a full line would wrap on some terminals
  const int fixed = columns_of(name + before + after(""));
  const int for_bar = room - columns_of(name + before + after(detail)) - 2;
  if (for_bar < narrowest_bar) {
    const std::string words = shortened(detail, room - fixed - 2, ellipsis);
    return fixed > room ? shortened(name + before + after(""), room, ellipsis)
                        : coloured(name, bold) + before + after(words);
  }
  const int bar_columns = std::min(for_bar, widest_bar);
  const int done = static_cast<int>(std::floor(stage_->fraction * bar_columns));
  std::string full;
  std::string rest;
  for (int i = 0; i < bar_columns; ++i) {
    (i < done ? full : rest) += unicode ? (i < done ? "█" : "░") : (i < done ? "#" : ".");
  }
  return coloured(name, bold) + "  " + coloured(full, cyan) + rest + before + after(detail);
}

std::string Terminal::coloured(std::string_view text, const char* code) const {
  const bool plain = style_.colours == TerminalStyle::Colours::off || text.empty();
  return plain ? std::string(text)
               : "\x1b[" + std::string(code) + "m" + std::string(text) + "\x1b[0m";
}

void Terminal::erase_line() {
  if (stage_ && stage_->shown && style_.kind == TerminalStyle::Kind::screen) {
    console_.write(erase_whole_line);
  }
}

void Terminal::write_line(const std::string& line) { console_.write(line + "\n"); }

}  // namespace collage
