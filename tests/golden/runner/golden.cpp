#include "golden/runner/golden.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/file.h"
#include "render/golden_report.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool passes(const GoldenRow& row) {
  return row.comparison && row.comparison->verdict != Verdict::differs;
}

const std::string& reason(const GoldenRow& row) {
  return row.comparison ? row.comparison->reason : row.problem;
}

std::string update_command(const std::vector<GoldenRow>& rows) {
  std::string command = "./run golden --update";
  for (const GoldenRow& row : rows) {
    command += passes(row) ? "" : " " + row.name;
  }
  return command;
}

/// A fresh copy of what the command reads.
void copy_case(const GoldenCase& golden, const fs::path& folder) {
  fs::remove_all(folder);
  fs::copy(golden.folder, folder, fs::copy_options::recursive);
  for (const char* ours : {"command", "tolerance", "reference.png"}) {
    fs::remove(folder / ours);
  }
}

Command command_of(const GoldenCase& golden, const GoldenRun& run) {
  Command command;
  command.program = "bash";
  command.arguments = {"-eu", fs::absolute(golden.folder / "command").string()};
  command.folder = run.output / golden.name;
  const fs::path bin = fs::canonical(run.program).parent_path();
  command.environment = {{"PATH", bin.string() + ":" + environment("PATH")},
                         {"COLLAGE_DATA", std::nullopt},
                         {"LC_ALL", "C.UTF-8"}};
  return command;
}

/// Runs the commands of all cases; their results are in the order of the cases.
std::vector<CommandResult> run_commands(const std::vector<GoldenCase>& cases, const GoldenRun& run,
                                        CommandRunner& runner, Status& status) {
  const std::size_t at_once = std::max(1U, std::thread::hardware_concurrency());
  std::vector<CommandResult> results(cases.size());
  std::map<CommandRunner::Id, std::size_t> running;
  std::size_t started = 0;
  status.begin("golden pictures");
  while (started < cases.size() || !running.empty()) {
    if (started < cases.size() && running.size() < at_once) {
      copy_case(cases[started], run.output / cases[started].name);
      auto& lines = results[started].lines;
      const auto keep = [&lines](std::string_view line) { lines.emplace_back(line); };
      running[runner.start(command_of(cases[started], run), keep)] = started;
      ++started;
    } else if (const auto finished = wait_or_stop(runner, status)) {
      results[running.at(finished->id)].exit_code = finished->exit_code;
      running.erase(finished->id);
      const std::size_t done = started - running.size();
      status.update(static_cast<double>(done) / static_cast<double>(cases.size()),
                    fmt::format("{} of {}", done, cases.size()));
    }
  }
  status.end();
  return results;
}

/// Lays the picture that a command left over its reference. The reference is copied beside it, so
/// that the output folder can be looked at elsewhere.
GoldenRow judged(const GoldenCase& golden, const fs::path& folder, const CommandResult& result) {
  GoldenRow row;
  row.name = golden.name;
  if (fs::exists(golden.folder / "reference.png")) {
    row.reference = folder / "reference.png";
    fs::copy_file(golden.folder / "reference.png", row.reference,
                  fs::copy_options::overwrite_existing);
  }
  if (result.exit_code != 0) {
    row.problem = fmt::format("its command ended with exit code {}: {}", result.exit_code,
                              fmt::join(result.lines, "; "));
    return row;
  }
  if (!fs::exists(folder / "picture.png")) {
    row.problem = "its command left no picture.png";
    return row;
  }
  row.picture = folder / "picture.png";
  if (row.reference.empty()) {
    row.problem = "there is no reference.png";
    return row;
  }
  try {
    row.comparison = compare_pictures(row.reference, row.picture, golden.thresholds);
    if (row.comparison->numbers) {
      write_difference(row.reference, row.picture, folder / "difference.png");
      row.difference = folder / "difference.png";
    }
  } catch (const Error& error) {
    row.problem = error.what();
  }
  return row;
}

/// Makes the pictures of failing cases the references; returns how many cases have none to offer.
int rewrite_references(const std::vector<GoldenCase>& cases, const std::vector<GoldenRow>& rows,
                       const std::function<void(std::string_view)>& say) {
  int failures = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (passes(rows[i])) {
      say(fmt::format("{}: passes, its reference stays", cases[i].name));
    } else if (rows[i].picture.empty()) {
      say(fmt::format("{}: {}", cases[i].name, reason(rows[i])));
      ++failures;
    } else {
      write_file(cases[i].folder / "reference.png", read_file(rows[i].picture));
      say(fmt::format("{}: has a new reference; before: {}", cases[i].name, reason(rows[i])));
    }
  }
  return failures;
}

int report(const GoldenRun& run, const std::vector<GoldenRow>& rows,
           const std::function<void(std::string_view)>& say) {
  const fs::path page =
      run.output / (run.names.size() == 1 ? run.names.front() + ".html" : "index.html");
  write_golden_report(rows, update_command(rows), page);
  int failures = 0;
  for (const GoldenRow& row : rows) {
    if (!passes(row)) {
      say(fmt::format("{}: {}\n  kept in {}", row.name, reason(row),
                      (run.output / row.name).string()));
      ++failures;
    }
  }
  say(fmt::format("{} of {} golden pictures pass; see {}", rows.size() - failures, rows.size(),
                  page.string()));
  if (failures > 0) {
    say("where the new pictures are right, make them the references: " + update_command(rows));
  }
  return failures;
}

}  // namespace

std::vector<GoldenCase> find_golden_cases(const fs::path& cases,
                                          const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const auto& entry : fs::directory_iterator(cases)) {
    if (fs::exists(entry.path() / "command")) {
      known.push_back(entry.path().filename().string());
    }
  }
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      throw Error({cases}, "there is no golden picture '" + name + "'", did_you_mean(name, known));
    }
  }
  std::ranges::sort(known);
  std::vector<GoldenCase> found;
  for (const std::string& name : known) {
    if (names.empty() || std::ranges::find(names, name) != names.end()) {
      found.push_back({name, cases / name, read_tolerance(cases / name / "tolerance")});
    }
  }
  if (found.empty()) {
    throw Error({cases}, "there is no golden picture", "add a folder with a command");
  }
  return found;
}

Thresholds read_tolerance(const fs::path& file) {
  Thresholds thresholds;
  if (!fs::exists(file)) {
    return thresholds;
  }
  const std::map<std::string, double*> values = {{"fail", &thresholds.fail},
                                                 {"failing-share", &thresholds.failing_share},
                                                 {"hard-fail", &thresholds.hard_fail}};
  bool has_reason = false;
  std::istringstream lines(read_file(file));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.starts_with('#')) {
      has_reason = true;
      continue;
    }
    std::istringstream words(line);
    std::string key;
    const auto value = words >> key ? values.find(key) : values.end();
    if (value == values.end() || !(words >> *value->second) || !(words >> std::ws).eof()) {
      throw Error({file, number}, "is no threshold",
                  "write fail, failing-share or hard-fail and a number");
    }
  }
  if (!has_reason) {
    throw Error({file}, "gives no reason", "say in a comment (#) why the defaults do not do");
  }
  return thresholds;
}

int run_golden(const GoldenRun& run, CommandRunner& runner, Status& status,
               const std::function<void(std::string_view)>& say) {
  if (run.update == GoldenRun::Update::yes && !environment("CI").empty()) {
    throw Error("references are not rewritten in continuous integration",
                "rewrite them where somebody can look at them");
  }
  const std::vector<GoldenCase> cases = find_golden_cases(run.cases, run.names);
  fs::create_directories(run.output);
  if (fs::equivalent(run.output, run.cases)) {
    throw Error({run.output}, "holds the cases themselves", "name another folder for the output");
  }
  const std::vector<CommandResult> results = run_commands(cases, run, runner, status);
  std::vector<GoldenRow> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    rows.push_back(judged(cases[i], run.output / cases[i].name, results[i]));
  }
  const int failures = run.update == GoldenRun::Update::yes ? rewrite_references(cases, rows, say)
                                                            : report(run, rows, say);
  return failures > 0 ? 1 : 0;
}

}  // namespace collage
