#include "cli/command_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <new>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include "base/error.h"
#include "base/memory.h"
#include "cli/commands.h"
#include "cli/stop_signals.h"
#include "cli/terminal.h"
#include "cli/version.h"
#include "scene/options_table.h"

namespace collage {
namespace {

enum ExitCode { success = 0, bad_input = 2, outside_program_failed = 3 };

/// "640x480".
std::array<int, 2> parse_size(const std::string& text) {
  std::array<int, 2> size{};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size[0]);
  const bool has_height = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_height ? std::from_chars(width.ptr + 1, end, size[1]) : width;
  constexpr int largest_side = 8192;
  if (!has_height || height.ec != std::errc() || height.ptr != end ||
      std::min(size[0], size[1]) < 1 || std::max(size[0], size[1]) > largest_side) {
    throw CLI::ValidationError(
        "--size",
        fmt::format("'{}' is not a size such as 640x480 (sides 1 to {})", text, largest_side));
  }
  return size;
}

/// CLI::Range() lets "nan" through, as it is neither below nor above.
CLI::Validator within(double low, double high) {
  const CLI::Validator range = CLI::Range(low, high);
  const auto check = [=](std::string& text) {
    double number = 0.0;
    const bool is_nan = CLI::detail::lexical_cast(text, number) && std::isnan(number);
    return is_nan ? "Value " + text + " is not a number" : range(text);
  };
  return {check, range.get_description()};
}

/// The arguments of all commands and, once parsed, what is to be run.
class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Nothing to be run: the exit code of --help, --version or a mistake, which has been printed.
  std::optional<int> parse(int argc, char** argv);
  [[nodiscard]] TerminalStyle::Verbosity verbosity() const { return common_.verbosity; }
  /// The exit code. Throws where the command did not come to its end.
  int run(Terminal& terminal) const;

 private:
  CLI::App* add(const char* name, const char* help);
  static void add_draft(CLI::App* command, Pictures& pictures);
  void add_common(CLI::App* command);
  void add_json(CLI::App* command);
  static void add_scene_options(CLI::App* command, SceneArguments& scene);
  static void add_size(CLI::App* command, std::array<int, 2>& size);
  CLI::App* add_scene_command(const char* name, const char* help,
                              int (*runner)(const SceneArguments&, const CommonArguments&,
                                            Terminal&));
  CLI::App* add_picture_command(const char* name, const char* help,
                                int (*runner)(const PictureArguments&, const CommonArguments&,
                                              Terminal&));
  void add_preview();
  void add_sweep();
  void add_sheet();
  void add_compare();
  void add_export();
  void add_model();
  void add_small_commands();
  [[nodiscard]] std::string complaint(const CLI::ParseError& error, int argc, char** argv) const;

  CLI::App app_{
      "Fills a shape with copies of other shapes, biggest first, without overlap, and "
      "has POV-Ray make pictures of it.\n\n"
      "To begin with: collage make scenes/teapot"};
  std::function<int(Terminal&)> run_;
  CommonArguments common_;
  SceneArguments scene_;
  PictureArguments picture_;
  PreviewArguments preview_;
  SweepArguments sweep_;
  AuditArguments audit_;
  GalleryArguments gallery_;
  SheetArguments sheet_;
  CompareArguments compare_;
  ExportArguments export_;
  std::vector<std::filesystem::path> meshes_;
  ModelArguments model_;
};

CommandLine::CommandLine() {
  app_.name("collage");
  app_.require_subcommand(1);
  app_.set_version_flag("--version", std::string("collage ") + version);
  add_draft(add_scene_command("make", "Pack a scene and render all that it asks for", run_make),
            scene_.pictures);
  add_scene_command("pack", "Pack a scene, without pictures", run_pack);
  CLI::App* still = add_picture_command("still", "Render stills of a finished folder", run_still);
  still
      ->add_option("--view", picture_.views,
                   "front, three-quarter, …, or azimuth/elevation in degrees, as 30/15")
      ->allow_extra_args(false);
  still->add_option("--stage", picture_.stage, "Share of the instances shown")
      ->check(within(0.0001, 1.0));
  still->add_option("--element", picture_.element, "Show the element of this number alone, from 0")
      ->check(CLI::Range(0, 9999));
  still->add_option("-o,--output", picture_.output, "The picture, .png or .exr");
  add_picture_command("turntable", "Render a turntable of a finished folder", run_turntable);
  CLI::App* render = add_picture_command(
      "render", "Render everything or some frames of a finished folder", run_render);
  CLI::Option* frames = render->add_option("--frames", picture_.frames,
                                           "Only these frames of the turntable, as 5-12");
  add_draft(render, picture_.pictures);
  render->get_option("--draft")->excludes(frames);
  add_preview();
  add_sweep();
  add_sheet();
  add_compare();
  add_export();
  add_small_commands();
}

CLI::App* CommandLine::add(const char* name, const char* help) {
  return app_.add_subcommand(name, help);
}

void CommandLine::add_draft(CLI::App* command, Pictures& pictures) {
  command->add_flag_callback(
      "--draft", [&pictures] { pictures = Pictures::preview; },
      "Previews in place of POV-Ray's pictures, in the folder draft/");
}

void CommandLine::add_common(CLI::App* command) {
  command->add_option("--threads", common_.threads, "How many to use; all by default")
      ->check(CLI::Range(1, 1024));
  command->add_option("--memory-limit", common_.memory_limit,
                      "How much to take, as 500M or 2.5G; 80 % of what is free by default");
  command->add_flag_callback(
      "--quiet", [this] { common_.verbosity = TerminalStyle::Verbosity::quiet; },
      "Say nothing but errors");
  command->add_flag_callback(
      "--verbose", [this] { common_.verbosity = TerminalStyle::Verbosity::verbose; }, "Say more");
}

void CommandLine::add_json(CLI::App* command) {
  command->add_flag_callback(
      "--json", [this] { common_.output = CommonArguments::Output::json; },
      "Print the result as JSON");
}

void CommandLine::add_scene_options(CLI::App* command, SceneArguments& scene) {
  command
      ->add_option("--set", scene.settings,
                   "Another value for an option of the scene, as packing.threshold=0.01; "
                   "`collage options` lists them")
      ->allow_extra_args(false);
  command->add_option("--seed", scene.seed, "The same as --set packing.seed=…")->type_name("UINT");
}

void CommandLine::add_size(CLI::App* command, std::array<int, 2>& size) {
  command
      ->add_option_function<std::string>(
          "--size", [&size](const std::string& text) { size = parse_size(text); },
          "Width and height of a picture in pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", size[0], size[1]));
}

CLI::App* CommandLine::add_scene_command(const char* name, const char* help,
                                         int (*runner)(const SceneArguments&,
                                                       const CommonArguments&, Terminal&)) {
  CLI::App* command = add(name, help);
  command->add_option("scene", scene_.scene, "A scene.toml, its folder, or the name of a scene")
      ->required();
  command->add_option("-o,--output", scene_.folder, "Folder to write to; out/<scene> by default");
  add_scene_options(command, scene_);
  command
      ->add_option("--time-limit", scene_.time_limit_seconds,
                   "Seconds after which packing ends with what is placed")
      ->check(within(0.001, 1e7));
  add_common(command);
  add_json(command);
  command->callback([this, runner] {
    run_ = [this, runner](Terminal& t) { return runner(scene_, common_, t); };
  });
  return command;
}

CLI::App* CommandLine::add_picture_command(const char* name, const char* help,
                                           int (*runner)(const PictureArguments&,
                                                         const CommonArguments&, Terminal&)) {
  CLI::App* command = add(name, help);
  command->add_option("folder", picture_.folder, "A folder that make or pack has written")
      ->required();
  command
      ->add_option("--set", picture_.settings,
                   "Another value for an option of its scene, as render.template=clay")
      ->allow_extra_args(false);
  add_common(command);
  command->callback([this, runner] {
    run_ = [this, runner](Terminal& t) { return runner(picture_, common_, t); };
  });
  return command;
}

void CommandLine::add_preview() {
  CLI::App* command =
      add("preview", "Show a finished folder, or a scene, in seconds and without POV-Ray");
  command
      ->add_option("scene", preview_.scene.scene,
                   "A folder that make or pack has written, or a scene, which is packed first")
      ->required();
  command
      ->add_option("--view", preview_.views,
                   "front, three-quarter, …, or azimuth/elevation in degrees, as 30/15")
      ->allow_extra_args(false);
  add_size(command, preview_.size);
  command->add_option("-o,--output", preview_.output,
                      "The picture, .png; by default previews/<view>.png in the folder");
  add_scene_options(command, preview_.scene);
  add_common(command);
  command->callback([this] { run_ = [this](Terminal& t) { return run_preview(preview_, t); }; });
}

void CommandLine::add_sweep() {
  CLI::App* command =
      add("sweep", "Pack a scene with all combinations of some values, previewed on one sheet");
  command
      ->add_option("scene", sweep_.scene.scene, "A scene.toml, its folder, or the name of a scene")
      ->required();
  command
      ->add_option("--set", sweep_.scene.settings,
                   "Values to try for an option, as packing.threshold=0.05,0.03,0.02; a list as a "
                   "value stands in brackets")
      ->allow_extra_args(false);
  command->add_option("--seed", sweep_.scene.seed, "Seeds to try, as 1..4 or 1,3,9")
      ->type_name("UINT..UINT");
  command->add_option("-o,--output", sweep_.scene.folder,
                      "Folder to write to; out/<scene>-sweep by default");
  command->add_option("--view", sweep_.view)->capture_default_str();
  add_size(command, sweep_.size);
  command->add_option("--columns", sweep_.columns)
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  add_common(command);
  add_json(command);
  command->callback(
      [this] { run_ = [this](Terminal& t) { return run_sweep(sweep_, common_, t); }; });
}

void CommandLine::add_sheet() {
  CLI::App* command = add("sheet", "Lay pictures out on a contact sheet");
  command->add_option("pictures", sheet_.pictures, "PNG or EXR files")->required();
  command->add_option("-o,--output", sheet_.output, "The sheet")->capture_default_str();
  command->add_option("--columns", sheet_.columns)
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command->add_option("--cell", sheet_.cell_size, "Longest side of a picture on it, in pixels")
      ->check(CLI::Range(16, 4096))
      ->capture_default_str();
  command->add_option("--caption", sheet_.captions, "One a picture, by default its file's name")
      ->allow_extra_args(false);
  command->add_option("--title", sheet_.title);
  command->callback([this] { run_ = [this](Terminal&) { return run_sheet(sheet_); }; });
}

void CommandLine::add_compare() {
  CLI::App* command =
      add("compare", "Lay a picture over its reference: exit 0 the same, 1 it differs");
  command->add_option("reference", compare_.reference)->required();
  command->add_option("picture", compare_.picture)->required();
  command->add_option("--difference", compare_.difference, "Write an amplified difference picture");
  command->add_option("--amplify", compare_.amplification)
      ->check(within(0.01, 10000.0))
      ->capture_default_str();
  command
      ->add_option("--fail", compare_.thresholds.fail,
                   "A pixel fails where a channel, 0 to 1, differs by more")
      ->check(within(0.0, 1000.0))
      ->capture_default_str();
  command
      ->add_option("--failing-share", compare_.thresholds.failing_share,
                   "This share of the pixels may fail")
      ->check(within(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--hard-fail", compare_.thresholds.hard_fail, "No pixel may differ by more")
      ->check(within(0.0, 1000.0))
      ->capture_default_str();
  add_json(command);
  command->callback(
      [this] { run_ = [this](Terminal&) { return run_compare(compare_, common_); }; });
}

void CommandLine::add_export() {
  CLI::App* command = add("export", "Write a sculpture as one OBJ, or a mesh as signed distances");
  command->add_option("input", export_.input, "A finished folder, or a mesh")->required();
  command->add_option("--obj", export_.obj, "All instances of the folder, with an MTL beside");
  command->add_option("--sdf", export_.sdf,
                      "Signed distances to the mesh, as target.sdf reads them");
  command->add_option("--resolution", export_.resolution, "Voxels on the longest side, for --sdf")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  add_common(command);
  command->callback([this] { run_ = [this](Terminal& t) { return run_export(export_, t); }; });
}

void CommandLine::add_small_commands() {
  CLI::App* audit = add("audit", "Prove that nothing overlaps or sticks out, and measure the rest");
  audit->add_option("folder", audit_.folder, "A folder that make or pack has written")->required();
  audit->add_option("--offenders", audit_.offenders,
                    "Write a folder that holds only the instances at fault, for `collage still`");
  audit->add_flag_callback(
      "--proof-only", [this] { audit_.measuring = Measuring::nothing; },
      "Measure nothing, which takes longer than the proof");
  add_common(audit);
  add_json(audit);
  audit->callback([this] { run_ = [this](Terminal& t) { return run_audit(audit_, common_, t); }; });

  CLI::App* gallery =
      add("gallery", "Make a still of every scene, and pages that show and compare them");
  gallery->add_option("scenes", gallery_.scenes, "By default all that come along");
  gallery->add_option("-o,--output", gallery_.folder)->capture_default_str();
  gallery->add_option("--quality", gallery_.quality, "By default the scenes' own")
      ->check(CLI::IsMember({"draft", "standard", "fine"}));
  add_common(gallery);
  gallery->callback(
      [this] { run_ = [this](Terminal& t) { return run_gallery(gallery_, common_, t); }; });

  CLI::App* check = add("check", "Say what there is to know of meshes");
  check->add_option("meshes", meshes_, "OBJ files")->required();
  check->callback([this] { run_ = [this](Terminal& t) { return run_check(meshes_, t); }; });

  add_model();
  add("scenes", "List the scenes that come with the program")->callback([this] {
    run_ = [](Terminal&) { return run_scenes(); };
  });

  CLI::App* options = add("options", "List all options of a scene file");
  options->add_flag_callback(
      "--markdown", [this] { common_.output = CommonArguments::Output::json; },
      "As the page docs/scene-reference.md");
  options->callback([this] { run_ = [this](Terminal&) { return run_options(common_.output); }; });
}

void CommandLine::add_model() {
  CLI::App* command =
      add("model", "Write a starter model or letters as OBJ; without either, list the models");
  const auto range = [](const char* key) {
    const Option& option = *find_option(key);
    return within(option.minimum, option.maximum);
  };
  CLI::Option* name = command->add_option("name", model_.name);
  CLI::Option* text =
      command->add_option("--text", model_.letters.string, "Letters, in place of a name")
          ->check([](const std::string& s) { return s.empty() ? "one or more letters" : ""; })
          ->excludes(name);
  command->add_flag("--all", model_.all, "Write all models, -o being a folder")
      ->excludes(name)
      ->excludes(text);
  command
      ->add_option("--covering", model_.covered,
                   "An OBJ file: the spheres that stand for it when it is fitted by its shape")
      ->excludes(name)
      ->excludes(text)
      ->excludes("--all");
  command
      ->add_option("--font", model_.letters.font,
                   "Theirs: a family, as \"DejaVu Serif:bold\", or a .ttf or .otf file")
      ->needs(text)
      ->capture_default_str();
  command->add_option("--depth", model_.letters.depth, "Heights of a capital letter")
      ->needs(text)
      ->check(range("target.text.depth"))
      ->capture_default_str();
  command->add_option("--bevel", model_.letters.bevel, "Heights of a capital letter")
      ->needs(text)
      ->check(range("target.text.bevel"))
      ->capture_default_str();
  command->add_option("-o,--output", model_.output,
                      "By default the name, letters or covering, with .obj");
  command->callback([this] { run_ = [this](Terminal& t) { return run_model(model_, t); }; });
}

/// One line on what is wrong with the arguments.
std::string CommandLine::complaint(const CLI::ParseError& error, int argc, char** argv) const {
  const auto commands = app_.get_subcommands();  // those that were given
  if (commands.empty() && argc > 1 && *argv[1] != '-') {
    std::vector<std::string> names;
    for (const CLI::App* command : app_.get_subcommands({})) {
      names.push_back(command->get_name());
    }
    const std::string guess = did_you_mean(argv[1], names);
    return fmt::format("there is no command '{}'; {}", argv[1],
                       guess.empty() ? "see collage --help" : guess);
  }
  const std::string name = commands.empty() ? "" : " " + commands.front()->get_name();
  return fmt::format("{}; see collage{} --help", error.what(), name);
}

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    app_.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      return app_.exit(error);  // --help and --version
    }
    fmt::print(stderr, "error: {}\n", complaint(error, argc, argv));
    return bad_input;
  }
}

int CommandLine::run(Terminal& terminal) const {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(thread_count(common_)));
  if (!common_.memory_limit.empty()) {
    limit_memory(parse_memory(common_.memory_limit));
  }
  const int code = run_(terminal);
  if (std::fflush(stdout) != 0) {
    throw Error("the result cannot be written to standard output", "check where it goes");
  }
  return code;
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CommandLine command_line;
  if (const std::optional<int> code = command_line.parse(argc, argv)) {
    return *code;
  }
  const StopSignals signals;
  Terminal terminal(standard_error_style(command_line.verbosity()), standard_error_console());
  try {
    return command_line.run(terminal);
  } catch (const Interrupted&) {
    terminal.error("interrupted");
    return interrupted;
  } catch (const Error& error) {
    terminal.error(error.what());
    return error.blame() == Error::Blame::input ? bad_input : outside_program_failed;
  } catch (const std::bad_alloc&) {
    terminal.error("out of memory; lower target.resolution or use smaller meshes");
    return bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    terminal.error(error.what());
    return bad_input;
  }
}

}  // namespace collage
