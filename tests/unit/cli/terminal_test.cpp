#include "cli/terminal.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace collage {
namespace {

using Verbosity = TerminalStyle::Verbosity;
using Kind = TerminalStyle::Kind;
using Letters = TerminalStyle::Letters;
using Colours = TerminalStyle::Colours;

/// A console that keeps what is written; the test moves its clock.
struct FakeConsole {
  std::string text;
  double seconds = 64.0;
  int columns = 80;
  bool stop = false;

  Console console() {
    return {[this](std::string_view more) { text += more; }, [this] { return seconds; },
            [this] { return columns; }, [this] { return stop; }};
  }
  std::string taken() { return std::exchange(text, ""); }
};

constexpr TerminalStyle screen{Verbosity::normal, Kind::screen, Letters::unicode, Colours::off};
constexpr TerminalStyle log{};

std::string redrawn(const std::string& line) { return "\r" + line + "\x1b[K"; }

TEST(Terminal, DrawsOneLineAndLeavesATidyOne) {
  FakeConsole fake;
  Terminal terminal(screen, fake.console());
  terminal.begin("packing");
  terminal.update(0.0, "0 instances");
  EXPECT_EQ(fake.taken(), "");
  fake.seconds += 12;
  terminal.update(0.62, "1,204 instances");
  EXPECT_EQ(
      fake.taken(),
      redrawn("packing  ██████████████░░░░░░░░░░  62 %  1,204 instances  0:12, about 0:08 left"));
  fake.seconds += 7;
  terminal.end();
  EXPECT_EQ(fake.taken(), "\r\x1b[Kpacking  done in 0:19\n");
}

TEST(Terminal, DrawsInAsciiWhereTheLocaleIsNotUtf8) {
  FakeConsole fake;
  fake.columns = 200;
  TerminalStyle style = screen;
  style.letters = Letters::ascii;
  Terminal terminal(style, fake.console());
  terminal.begin("packing");
  fake.seconds += 0.625;
  terminal.update(0.5, "");
  EXPECT_EQ(fake.taken(), redrawn("packing  ############............  50 %  0.6 s"));
}

TEST(Terminal, UsesColoursOnlyIfAsked) {
  FakeConsole fake;
  TerminalStyle style = screen;
  style.colours = Colours::on;
  Terminal terminal(style, fake.console());
  terminal.note("inside out");
  EXPECT_EQ(fake.taken(), "\x1b[33mnote:\x1b[0m inside out\n");
  terminal.error("no");
  EXPECT_EQ(fake.taken(), "\x1b[1;31merror:\x1b[0m no\n");
  terminal.begin("packing");
  fake.seconds += 1;
  terminal.end();
  EXPECT_EQ(fake.taken(), "\x1b[1mpacking\x1b[0m  done in 0:01\n");
}

TEST(Terminal, RedrawsAtMostTenTimesASecond) {
  FakeConsole fake;
  Terminal terminal(screen, fake.console());
  terminal.begin("packing");
  for (int i = 0; i < 20000; ++i) {
    fake.seconds += 0.0001;
    terminal.update(i / 20000.0, "");
  }
  const std::string text = fake.taken();
  EXPECT_THAT(std::count(text.begin(), text.end(), '\r'),
              testing::AllOf(testing::Ge(14), testing::Le(16)));
}

TEST(Terminal, NeverFillsTheLine) {
  for (const auto letters : {Letters::unicode, Letters::ascii}) {
    for (int columns = 1; columns < 120; ++columns) {
      FakeConsole fake;
      fake.columns = columns;
      TerminalStyle style = screen;
      style.letters = letters;
      Terminal terminal(style, fake.console());
      terminal.begin("packing");
      fake.seconds += 12;
      terminal.update(0.62, "1,204 instances of twenty kinds");
      std::string line = fake.taken();
      int characters = 0;
      for (const char c : line) {
        characters += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
      }
      characters -= 4;  // \r and \x1b[K
      EXPECT_LT(characters, std::max(columns, 1)) << columns << " columns: " << line.substr(1);
    }
  }
}

TEST(Terminal, ShortensTheDetailFirst) {
  FakeConsole fake;
  fake.columns = 50;
  Terminal terminal(screen, fake.console());
  terminal.begin("packing");
  fake.seconds += 12;
  terminal.update(0.62, "1,204 instances of twenty kinds");
  EXPECT_EQ(fake.taken(), redrawn("packing  62 %  1,204 inst…  0:12, about 0:08 left"));
}

TEST(Terminal, CountsWideLettersTwice) {
  FakeConsole fake;
  fake.columns = 30;
  TerminalStyle style = screen;
  Terminal terminal(style, fake.console());
  terminal.begin("彫刻");
  fake.seconds += 0.625;
  terminal.update(0.5, "茶碗茶碗茶碗茶碗");
  EXPECT_EQ(fake.taken(), redrawn("彫刻  50 %  茶碗茶碗…  0.6 s"));
}

TEST(Terminal, SaysNothingOfAShortStage) {
  FakeConsole fake;
  Terminal terminal(screen, fake.console());
  terminal.begin("reading");
  fake.seconds += 0.3;
  terminal.update(0.9, "teapot.obj");
  terminal.end();
  EXPECT_EQ(fake.taken(), "");
}

TEST(Terminal, SaysAllIfVerbose) {
  FakeConsole fake;
  TerminalStyle style = screen;
  style.verbosity = Verbosity::verbose;
  Terminal terminal(style, fake.console());
  terminal.begin("reading");
  fake.seconds += 0.31;
  terminal.end();
  EXPECT_EQ(fake.taken(), "reading  done in 0.3 s\n");
}

TEST(Terminal, SaysOnlyErrorsIfQuiet) {
  FakeConsole fake;
  TerminalStyle style = screen;
  style.verbosity = Verbosity::quiet;
  Terminal terminal(style, fake.console());
  terminal.begin("packing");
  fake.seconds += 100;
  terminal.update(0.5, "half");
  terminal.note("inside out");
  terminal.end();
  EXPECT_EQ(fake.taken(), "");
  terminal.error("no such file");
  EXPECT_EQ(fake.taken(), "error: no such file\n");
}

TEST(Terminal, WritesFewWholeLinesIntoALog) {
  FakeConsole fake;
  Terminal terminal(log, fake.console());
  terminal.begin("packing");
  for (int i = 0; i < 250; ++i) {
    fake.seconds += 0.1;
    terminal.update((i + 1) / 250.0, "twenty-five seconds");
  }
  terminal.end();
  EXPECT_THAT(fake.taken(), testing::MatchesRegex(
                                "packing   8 %  twenty-five seconds  0:0[12], about 0:2. left\n"
                                "packing  4[78] %  twenty-five seconds  0:1[12], about 0:1. left\n"
                                "packing  8[789] %  twenty-five seconds  0:2[12], about 0:0. left\n"
                                "packing  done in 0:2[45]\n"));
}

TEST(Terminal, WritesNothingOfTwoSecondsIntoALog) {
  FakeConsole fake;
  Terminal terminal(log, fake.console());
  terminal.begin("packing");
  fake.seconds += 1.9;
  terminal.update(0.5, "");
  terminal.end();
  EXPECT_EQ(fake.taken(), "");
}

TEST(Terminal, PutsNotesAboveTheProgress) {
  FakeConsole fake;
  Terminal terminal(screen, fake.console());
  terminal.begin("reading");
  terminal.note("first");
  EXPECT_EQ(fake.taken(), "note: first\n");
  fake.seconds += 0.625;
  terminal.update(0.5, "");
  fake.taken();
  terminal.note("second");
  EXPECT_EQ(fake.taken(), "\r\x1b[Knote: second\n");
}

TEST(Terminal, RemovesItsLineBeforeAnError) {
  FakeConsole fake;
  Terminal terminal(screen, fake.console());
  terminal.begin("reading");
  fake.seconds += 0.625;
  terminal.update(0.5, "");
  fake.taken();
  terminal.error("empty mesh");
  EXPECT_EQ(fake.taken(), "\r\x1b[Kerror: empty mesh\n");
  terminal.end();
  EXPECT_EQ(fake.taken(), "");
}

TEST(Terminal, LetsNoControlCharacterThrough) {
  FakeConsole fake;
  Terminal terminal(log, fake.console());
  terminal.note(
      "a\x1b[2Jb\nc\x7f\xc2\x9b"
      "d é");
  EXPECT_EQ(fake.taken(), "note: a?[2Jb?c??d é\n");
}

TEST(Terminal, NeverGoesBack) {
  FakeConsole fake;
  Terminal terminal(log, fake.console());
  terminal.begin("packing");
  for (const double fraction : {0.5, 0.25, std::numeric_limits<double>::quiet_NaN(), 7.0}) {
    fake.seconds += 20;
    terminal.update(fraction, "");
  }
  EXPECT_THAT(fake.taken(), testing::MatchesRegex("packing  50 %.*\npacking  50 %.*\n"
                                                  "packing  50 %.*\npacking 100 %  1:20\n"));
}

TEST(Terminal, AsksForTheStop) {
  FakeConsole fake;
  const Terminal terminal(log, fake.console());
  EXPECT_FALSE(terminal.stop_requested());
  fake.stop = true;
  EXPECT_TRUE(terminal.stop_requested());
}

TEST(RemainingTime, IsNotGuessedInTheFirstSecond) {
  RemainingTime remaining;
  remaining.update(0.9, 0.5);
  EXPECT_EQ(remaining.seconds(), std::nullopt);
  remaining.update(1.1, 0.5);
  EXPECT_NE(remaining.seconds(), std::nullopt);
}

TEST(RemainingTime, IsExactForSteadyWork) {
  RemainingTime remaining;
  for (int i = 1; i < 100; ++i) {
    remaining.update(i * 0.3, i / 100.0);
  }
  EXPECT_NEAR(*remaining.seconds(), 0.3, 1e-9);
}

TEST(RemainingTime, CountsDownWhereTheWorkSlowsDown) {
  RemainingTime remaining;
  double before = 1e9;
  for (int i = 20; i < 1000; ++i) {  // 100 s of work whose second half takes twice as long
    const double seconds = i * 0.1;
    const double fraction = seconds < 100.0 / 3 ? seconds / (200.0 / 3) : 0.25 + seconds * 0.0075;
    remaining.update(seconds, fraction);
    const double now = *remaining.seconds();
    EXPECT_LT(now, before + 0.1) << seconds;
    before = now;
  }
  EXPECT_LT(before, 2.0);
}

TEST(DurationText, IsReadable) {
  EXPECT_EQ(duration_text(-1), "0.0 s");
  EXPECT_EQ(duration_text(0.39), "0.3 s");
  EXPECT_EQ(duration_text(1), "0:01");
  EXPECT_EQ(duration_text(72.9), "1:12");
  EXPECT_EQ(duration_text(3723), "1:02:03");
}

TEST(TerminalStyle, FollowsTheLocale) {
  ::setenv("LC_ALL", "de_DE.utf8", 1);
  EXPECT_EQ(standard_error_style(Verbosity::normal).letters, Letters::unicode);
  ::setenv("LC_ALL", "C", 1);
  EXPECT_EQ(standard_error_style(Verbosity::normal).letters, Letters::ascii);
  ::unsetenv("LC_ALL");
}

}  // namespace
}  // namespace collage
