#include "render/render_pictures.h"

#include <algorithm>
#include <future>
#include <list>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/stage.h"
#include "render/imaging.h"
#include "render/picture_file.h"
#include "render/picture_key.h"
#include "render/sandbox.h"
#include "render/scratch.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// A day of computing a thread, and never so little memory that POV-Ray does not start.
constexpr std::uint64_t most_seconds = 86400;
constexpr std::uint64_t least_memory = std::uint64_t{1} << 30;

/// A POV-Ray at work on one picture.
struct Run {
  Run(const fs::path& folder, const PictureJob& job_, std::string key_)
      : job(job_), key(std::move(key_)), files(folder) {}

  const PictureJob& job;
  std::string key;
  Scratch files;
  PovrayConsole console;
  CommandRunner::Id id = 0;
};

/// What one POV-Ray may take of the machine.
struct Share {
  int threads;
  std::uint64_t memory_bytes;
};

Command povray_command(const RenderTools& tools, const fs::path& folder, const Run& run,
                       const Share& share) {
  std::vector<std::string> arguments = {
      "+I" + run.files.name(".pov"), "+O" + run.files.name(extension(run.job.shot.format)),
      "+GF" + run.files.name(".fatal"), "+WT" + std::to_string(share.threads)};
  const std::vector<std::string> options = povray_options(run.job.shot);
  arguments.insert(arguments.end(), options.begin(), options.end());
  // POVINI could change any option that we leave at its default. Huge pages (glibc 2.35) take a
  // tenth off the time: rays go criss-cross through the memory of the meshes.
  Command command{.program = tools.povray.program,
                  .arguments = std::move(arguments),
                  .folder = folder,
                  .environment = {{"POVINI", std::nullopt},
                                  {"LC_ALL", "C"},
                                  {"GLIBC_TUNABLES", "glibc.malloc.hugetlb=1"}},
                  .memory_bytes = share.memory_bytes,
                  .cpu_seconds = most_seconds * static_cast<std::uint64_t>(share.threads)};
  return tools.povray.sandbox ? sandboxed(*tools.povray.sandbox, command) : command;
}

std::string text_or_nothing(const fs::path& path) {
  return fs::exists(path) ? read_file(path) : std::string();
}

/// POV-Ray's picture, or Error where it is not what was asked for.
Picture finished_picture(const Run& run) {
  const Shot& shot = run.job.shot;
  Picture picture;
  try {
    picture = read_picture(run.files.path(extension(shot.format)));
  } catch (const Error& error) {
    throw Error::outside_program(std::string("POV-Ray left no whole picture: ") + error.what(),
                                 "check the free space");
  }
  if (picture.width != shot.width || picture.height != shot.height) {
    throw Error::outside_program("POV-Ray made a picture of another size than asked for",
                                 "remove povray.ini files that set a size");
  }
  return picture;
}

class Batch {
 public:
  Batch(const RenderTools& tools, const fs::path& folder, std::size_t total, std::string_view noun)
      : tools_(tools), folder_(folder), total_(total), noun_(noun) {}
  ~Batch() { tools_.runner.stop_all(); }
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  struct Task {
    const PictureJob* job;
    std::string key;
  };

  void render(const std::vector<Task>& tasks) {
    const bool alone = tasks.size() == 1 || tools_.threads == 1;
    const int at_once = alone ? 1 : tools_.threads + 1;  // each idles when it comes and goes
    const Share share{.threads = tasks.size() == 1 ? tools_.threads : 1,
                      .memory_bytes = std::max(
                          memory_to_take() / static_cast<std::uint64_t>(at_once), least_memory)};
    done_ = total_ - tasks.size();
    std::shared_future<void> loading;
    auto next = tasks.begin();
    while (next != tasks.end() || !runs_.empty()) {
      while (next != tasks.end() && static_cast<int>(runs_.size()) < at_once) {
        start(*next++, share);
      }
      if (!loading.valid()) {  // while POV-Ray parses, which takes one thread
        loading = std::async(std::launch::async, [] { imaging(); });
      }
      report();
      if (const auto finished = wait_or_stop(tools_.runner, tools_.status)) {
        loading.get();  // else a library that cannot be loaded would pass for a broken picture
        finish(*finished);
      }
    }
  }

 private:
  void start(const Task& task, const Share& share) {
    Run& run = runs_.emplace_back(folder_, *task.job, task.key);
    const Shot& shot = task.job->shot;
    write_file(run.files.path(".pov"),
               (tools_.prologue ? tools_.prologue(folder_, shot) : "") + job_text(shot));
    run.id = tools_.runner.start(povray_command(tools_, folder_, run, share),
                                 [&run](std::string_view line) { run.console.read_line(line); });
  }

  void finish(const CommandRunner::Finished& finished) {
    const auto run = std::ranges::find(runs_, finished.id, &Run::id);
    if (finished.exit_code != 0) {
      throw povray_error(folder_, finished.exit_code, text_or_nothing(run->files.path(".fatal")),
                         run->console);
    }
    Picture picture = finished_picture(*run);
    picture.key = run->key;
    write_picture(run->job.output, picture);
    runs_.erase(run);
    ++done_;
  }

  void report() const {
    double sum = static_cast<double>(done_);
    for (const Run& run : runs_) {
      sum += run.console.fraction();
    }
    const std::string detail = total_ == 1
                                   ? noun_
                                   : noun_ + " " + std::to_string(std::min(done_ + 1, total_)) +
                                         " of " + std::to_string(total_);
    tools_.status.update(sum / static_cast<double>(total_), detail);
  }

  const RenderTools& tools_;
  const fs::path& folder_;
  std::size_t total_;
  std::string noun_;
  std::list<Run> runs_;
  std::size_t done_ = 0;
};

bool is_there(const fs::path& path, const std::string& key) {
  if (!fs::exists(path)) {
    return false;
  }
  try {
    return read_picture(path).key == key;
  } catch (const Error&) {
    return false;  // cut short, or another thing altogether: rendered again
  }
}

void clean_up(const fs::path& folder, std::span<const PictureJob> jobs) {
  std::set<fs::path> folders = {folder};
  for (const PictureJob& job : jobs) {
    folders.insert(job.output.parent_path());
  }
  std::ranges::for_each(folders, remove_stale_scratch);
}

}  // namespace

RenderCount render_pictures(const RenderTools& tools, const fs::path& folder,
                            std::span<const PictureJob> jobs, std::string_view noun) {
  const std::string digest = scene_digest(folder);
  std::vector<Batch::Task> tasks;
  for (const PictureJob& job : jobs) {
    check_shot(job.shot, folder);
    std::string key = picture_key(digest, job.shot, tools.povray);
    if (!is_there(job.output, key)) {
      tasks.push_back({&job, std::move(key)});
    }
  }
  clean_up(folder, jobs);
  if (!tasks.empty()) {
    const Stage stage(tools.status, "rendering");
    Batch(tools, folder, jobs.size(), noun).render(tasks);
  }
  const int rendered = static_cast<int>(tasks.size());
  return {rendered, static_cast<int>(jobs.size()) - rendered};
}

}  // namespace collage
