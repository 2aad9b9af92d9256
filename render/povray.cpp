#include "render/povray.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <regex>

#include "render/sandbox.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr double pretrace_share = 1.0 / 3.0;
constexpr std::size_t remarks_kept = 8;
const char* const install_remedy = "run: apt-get install povray povray-includes";

std::string program_name() {
  const char* chosen = std::getenv("COLLAGE_POVRAY");
  return chosen == nullptr || *chosen == '\0' ? "povray" : chosen;
}

bool is_new_enough(const std::smatch& version) {
  const int major = std::stoi(version[2]);
  return major > 3 || (major == 3 && std::stoi(version[3]) >= 7);
}

/// The number before "%)" at the end of a progress line, as a fraction.
std::optional<double> fraction_in(std::string_view line) {
  const std::size_t open = line.rfind('(');
  const std::size_t percent = line.rfind('%');
  if (open == std::string_view::npos || percent == std::string_view::npos || percent < open) {
    return std::nullopt;
  }
  int value = 0;
  const auto result = std::from_chars(line.data() + open + 1, line.data() + percent, value);
  const bool valid = result.ptr == line.data() + percent && value >= 0 && value <= 100;
  return valid ? std::optional(value / 100.0) : std::nullopt;
}

/// POV-Ray breaks its messages after 80 columns, in the middle of a word if need be.
std::string unwrapped(std::string_view text) {
  std::string joined(text);
  std::erase(joined, '\n');
  return joined;
}

struct Failure {
  std::string file;
  std::string line;
  std::string message;
};

/// "File: scene.pov  Line: 7", a few lines of context, "Parse Error: Expected …".
std::optional<Failure> failure_in(std::string_view fatal_text) {
  const std::size_t at = fatal_text.rfind("Error: ");
  if (at == std::string_view::npos) {
    return std::nullopt;
  }
  std::string_view message = fatal_text.substr(at + std::string_view("Error: ").size());
  Failure failure;
  failure.message = unwrapped(message.substr(0, message.find("\n\n")));
  static const std::regex place("File: (.*)  Line: ([0-9]+)");
  std::smatch match;
  const std::string before(fatal_text.substr(0, at));
  if (std::regex_search(before, match, place)) {
    failure.file = match[1];
    failure.line = match[2];
  }
  return failure;
}

std::optional<fs::path> find_bwrap(const CommandRunner& runner) {
  const char* wanted = std::getenv("COLLAGE_SANDBOX");
  const bool unwanted = wanted != nullptr && std::string_view(wanted) == "no";
  return unwanted ? std::nullopt : runner.find("bwrap");
}

/// Whether POV-Ray came to the limit of memory that it runs under.
bool is_out_of_memory(std::string_view said) {
  constexpr std::array words{"bad_alloc", "ut of memory", "annot allocate memory"};
  return std::ranges::any_of(words, [&](const char* word) { return said.find(word) != said.npos; });
}

Error out_of_memory(const fs::path& folder) {
  return Error::outside_program(folder.string() + ": POV-Ray needs more memory than it may take",
                                "raise --memory-limit, render fewer pictures at once (--threads 1) "
                                "or use smaller textures");
}

Error killed(int signal) {
  if (signal == SIGKILL) {
    return Error::outside_program(
        "POV-Ray was killed, most likely because the machine ran out of memory",
        "render fewer pictures at once (--threads 1) or close other programs");
  }
  return Error::outside_program("POV-Ray was ended by signal " + std::to_string(signal),
                                "run the same command again; pictures that are done are kept");
}

}  // namespace

Povray find_povray(CommandRunner& runner, const Status& status) {
  const std::string name = program_name();
  const std::optional<fs::path> program = runner.find(name);
  if (!program) {
    throw Error::outside_program(
        name == "povray" ? "POV-Ray is not installed" : "there is no POV-Ray at " + name,
        name == "povray" ? install_remedy : "check COLLAGE_POVRAY");
  }
  const Command ask{.program = *program, .arguments = {"--version"}};
  std::optional<fs::path> sandbox = find_bwrap(runner);
  CommandResult result{};
  if (sandbox) {
    result = run_command(runner, sandboxed(*sandbox, ask), status);
  }
  if (!sandbox || result.exit_code != 0) {  // containers often forbid what bubblewrap does
    sandbox.reset();
    result = run_command(runner, ask, status);
  }
  static const std::regex pattern(R"(^POV-Ray (([0-9]{1,4})\.([0-9]{1,4})[^ ]*))");
  for (const std::string& line : result.lines) {
    std::smatch match;
    if (!std::regex_search(line, match, pattern)) {
      continue;
    }
    if (!is_new_enough(match)) {
      throw Error::outside_program(
          "POV-Ray 3.7 or newer is needed; " + program->string() + " is " + match[1].str(),
          install_remedy);
    }
    return {*program, match[1], sandbox};
  }
  throw Error::outside_program(program->string() + " does not say which version of POV-Ray it is",
                               install_remedy);
}

void PovrayConsole::read_line(std::string_view line) {
  if (line.starts_with("==== ")) {
    past_banner_ = true;
    return;
  }
  const bool is_pretrace = line.starts_with("Performing radiosity pretrace");
  if (is_pretrace || line.starts_with("Rendered ")) {
    if (const std::optional<double> done = fraction_in(line)) {
      pretrace_share_ = is_pretrace ? pretrace_share : pretrace_share_;
      const double start = is_pretrace ? 0.0 : pretrace_share_;
      const double share = is_pretrace ? pretrace_share : 1.0 - pretrace_share_;
      fraction_ = std::max(fraction_, start + share * *done);
    }
    return;
  }
  const bool is_harmless = line.find("cannot open the user configuration file") != line.npos ||
                           line.starts_with("Parsing ");
  const bool matters = past_banner_ || line.find("rror") != line.npos ||
                       line.find("ailed") != line.npos || line.find("annot") != line.npos;
  if (is_harmless || !matters) {
    return;
  }
  remarks_.emplace_back(line);
  if (remarks_.size() > remarks_kept) {
    remarks_.pop_front();
  }
}

Error povray_error(const fs::path& folder, int exit_code, std::string_view fatal_text,
                   const PovrayConsole& console) {
  if (exit_code > 128) {
    return killed(exit_code - 128);
  }
  const auto& remarks = console.remarks();
  if (is_out_of_memory(fatal_text) || std::ranges::any_of(remarks, is_out_of_memory)) {
    return out_of_memory(folder);
  }
  if (const std::optional<Failure> failure = failure_in(fatal_text)) {
    const std::string place = failure->file.empty()
                                  ? folder.string()
                                  : (folder / failure->file).string() + ":" + failure->line;
    return Error::outside_program(place + ": POV-Ray: " + failure->message,
                                  "mend the template, or make the scene again");
  }
  std::string said;
  for (const std::string& line : remarks) {
    said += said.empty() ? line : " / " + line;
  }
  return Error::outside_program(folder.string() + ": POV-Ray failed with exit code " +
                                    std::to_string(exit_code) + (said.empty() ? "" : ": " + said),
                                "check the folder's permissions and free space");
}

}  // namespace collage
