#pragma once

#include <algorithm>
#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"
#include "render/picture_file.h"
#include "render/process.h"

namespace collage::testing {

namespace fs = std::filesystem;

/// A folder of a test's own, kept where the test fails.
class TestFolder {
 public:
  TestFolder() {
    static std::atomic<int> counter{0};
    path_ = fs::temp_directory_path() /
            ("collage-render-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    fs::create_directories(path_);
  }
  ~TestFolder() {
    if (!::testing::Test::HasFailure()) {
      fs::remove_all(path_);
    }
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }

  /// Names of all files below, hidden ones too, sorted.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path_)) {
      if (!entry.is_directory()) {
        names.push_back(entry.path().lexically_relative(path_).string());
      }
    }
    std::ranges::sort(names);
    return names;
  }

 private:
  fs::path path_;
};

/// A picture of one colour, 8 bits a channel.
inline Picture plain_picture(int width, int height, float value = 0.4F, int channels = 3) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  picture.channels = channels;
  picture.values.assign(picture.pixels() * static_cast<std::size_t>(channels), value);
  return picture;
}

inline void cut_in_half(const fs::path& path) { fs::resize_file(path, fs::file_size(path) / 2); }

template <class Call>
std::string error_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// Collects what a user would see; asks to stop once `stops_after` looks were taken.
class RecordingStatus : public Status {
 public:
  void update(double fraction, std::string_view detail) override {
    fractions.push_back(fraction);
    details.emplace_back(detail);
  }
  void begin(std::string_view stage) override { stages.emplace_back(stage); }
  void end() override { ++ended; }
  void note(std::string_view line) override { notes.emplace_back(line); }
  [[nodiscard]] bool stop_requested() const override { return --stops_after == 0; }

  std::vector<double> fractions;
  std::vector<std::string> details;
  std::vector<std::string> stages;
  std::vector<std::string> notes;
  int ended = 0;
  mutable int stops_after = -1;
};

/// Runs nothing: each start() takes the next of the prepared answers.
class FakeRunner : public CommandRunner {
 public:
  struct Answer {
    std::vector<std::string> lines{};
    int exit_code = 0;
    std::function<void(const Command&)> effect{};
    bool never_ends = false;
  };

  [[nodiscard]] std::optional<fs::path> find(const std::string& name) const override {
    const auto found = programs.find(name);
    return found == programs.end() ? std::nullopt : std::optional<fs::path>(found->second);
  }
  Id start(const Command& command, LineSink on_line) override {
    commands.push_back(command);
    const Answer answer = answers.empty() ? Answer{} : answers.front();
    if (!answers.empty()) {
      answers.pop_front();
    }
    for (const std::string& line : answer.lines) {
      on_line(line);
    }
    if (answer.effect) {
      answer.effect(command);
    }
    running.push_back({next_id, answer.exit_code, answer.never_ends});
    most_at_once = std::max(most_at_once, running.size());
    return next_id++;
  }
  std::optional<Finished> wait(std::chrono::milliseconds) override {
    const auto ended = std::ranges::find(running, false, &Running::never_ends);
    if (ended == running.end()) {
      return std::nullopt;
    }
    const Finished finished{ended->id, ended->exit_code};
    running.erase(ended);
    return finished;
  }
  void stop_all() noexcept override {
    stopped += running.size();
    running.clear();
  }

  struct Running {
    Id id;
    int exit_code;
    bool never_ends;
  };
  std::map<std::string, fs::path> programs;
  std::deque<Answer> answers;
  std::vector<Command> commands;
  std::deque<Running> running;
  std::size_t most_at_once = 0;
  std::size_t stopped = 0;
  Id next_id = 0;
};

}  // namespace collage::testing
