// golden_pictures [--update] PROGRAM CASES OUTPUT [NAME...]: see golden.h and `./run golden`.
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "base/error.h"
#include "cli/stop_signals.h"
#include "cli/terminal.h"
#include "golden/runner/golden.h"

namespace {

constexpr int bad_input = 2;
constexpr int interrupted = 130;

int run(std::vector<std::string> arguments) {
  collage::GoldenRun golden;
  if (!arguments.empty() && arguments.front() == "--update") {
    golden.update = collage::GoldenRun::Update::yes;
    arguments.erase(arguments.begin());
  }
  if (arguments.size() < 3) {
    fmt::print(stderr, "usage: golden_pictures [--update] PROGRAM CASES OUTPUT [NAME...]\n");
    return bad_input;
  }
  golden.program = arguments[0];
  golden.cases = arguments[1];
  golden.output = arguments[2];
  golden.names.assign(arguments.begin() + 3, arguments.end());

  using collage::TerminalStyle;
  const collage::StopSignals signals;
  collage::Terminal terminal(collage::standard_error_style(TerminalStyle::Verbosity::normal),
                             collage::standard_error_console());
  collage::SystemRunner runner;
  return collage::run_golden(golden, runner, terminal,
                             [](std::string_view line) { fmt::print("{}\n", line); });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const collage::Interrupted&) {
    return interrupted;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return bad_input;
  }
}
