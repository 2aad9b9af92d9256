#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/audit_folder.h"
#include "cli/terminal.h"
#include "geometry/letters.h"
#include "render/compare.h"

namespace collage {

/// One struct a command: what the command line gave. Each run function returns the exit code and
/// prints its result on standard output; progress, notes and errors go to the terminal.

/// Exit code of a command that answers a question with "no".
inline constexpr int answer_no = 1;
/// The user stopped it; what there is of a result is whole.
inline constexpr int interrupted = 130;

struct CommonArguments {
  enum class Output { text, json };
  Output output = Output::text;
  TerminalStyle::Verbosity verbosity = TerminalStyle::Verbosity::normal;
  /// 0: as many as the machine has.
  int threads = 0;
  /// As parse_memory() reads it; empty: as memory_to_take().
  std::string memory_limit{};
};

/// Those asked for, else as many as the machine has.
int thread_count(const CommonArguments& common);

/// Who makes the pictures: POV-Ray, or the preview, in seconds.
enum class Pictures { povray, preview };

/// `make` and `pack`.
struct SceneArguments {
  std::string scene;
  /// Empty: out/<name of the scene>.
  std::filesystem::path folder;
  std::vector<std::string> settings;
  /// Empty: the scene's own.
  std::string seed;
  /// Of `make`: who makes the pictures.
  Pictures pictures = Pictures::povray;
  /// Packing ends after so many seconds.
  std::optional<double> time_limit_seconds{};
};
int run_make(const SceneArguments& arguments, const CommonArguments& common, Terminal& terminal);
int run_pack(const SceneArguments& arguments, const CommonArguments& common, Terminal& terminal);

/// Makes a still of every scene that comes along, or of those named, and pages that show and
/// compare them.
struct GalleryArguments {
  std::vector<std::string> scenes;
  std::filesystem::path folder = "out/gallery";
  /// Empty: the scenes' own.
  std::string quality;
};
int run_gallery(const GalleryArguments& arguments, const CommonArguments& common,
                Terminal& terminal);

struct AuditArguments {
  std::filesystem::path folder;
  /// Where the instances that break a promise go; empty: nowhere.
  std::filesystem::path offenders;
  Measuring measuring = Measuring::all;
};
/// Holds the promises against a finished folder and measures it; writes audit.json there; exit code
/// 1: a promise is broken.
int run_audit(const AuditArguments& arguments, const CommonArguments& common, Terminal& terminal);

/// `still`, `turntable`, `render` and `sheet`: pictures of a finished folder. What is not given is
/// as its scene has it.
struct PictureArguments {
  std::filesystem::path folder;
  std::vector<std::string> settings;
  std::vector<std::string> views;
  std::string frames;
  std::optional<double> stage;
  std::optional<int> element;
  std::filesystem::path output;
  /// Of `render`.
  Pictures pictures = Pictures::povray;
};
int run_still(const PictureArguments& arguments, const CommonArguments& common, Terminal& terminal);
int run_turntable(const PictureArguments& arguments, const CommonArguments& common,
                  Terminal& terminal);
int run_render(const PictureArguments& arguments, const CommonArguments& common,
               Terminal& terminal);

/// Quick pictures of a finished folder, or of a scene that is packed for it.
struct PreviewArguments {
  /// Its `scene` may be a finished folder.
  SceneArguments scene;
  std::vector<std::string> views;
  std::array<int, 2> size{640, 480};
  std::filesystem::path output;
};
int run_preview(const PreviewArguments& arguments, Terminal& terminal);

/// A scene packed with all combinations of some values, and previewed on one contact sheet.
struct SweepArguments {
  /// Its settings may list several values, "packing.threshold=0.05,0.03", its seed several, "1..4".
  SceneArguments scene;
  std::string view = "three-quarter";
  std::array<int, 2> size{480, 360};
  int columns = 4;
};
/// Exit code 1: a combination could not be packed.
int run_sweep(const SweepArguments& arguments, const CommonArguments& common, Terminal& terminal);

struct SheetArguments {
  std::vector<std::filesystem::path> pictures;
  std::vector<std::string> captions;
  std::filesystem::path output = "sheet.png";
  std::string title;
  int columns = 4;
  int cell_size = 400;
};
int run_sheet(const SheetArguments& arguments);

struct CompareArguments {
  std::filesystem::path reference;
  std::filesystem::path picture;
  std::filesystem::path difference;
  double amplification = 16.0;
  Thresholds thresholds;
};
int run_compare(const CompareArguments& arguments, const CommonArguments& common);

struct ExportArguments {
  std::filesystem::path input;
  std::filesystem::path obj;
  std::filesystem::path sdf;
  int resolution = 100;
};
int run_export(const ExportArguments& arguments, Terminal& terminal);

int run_check(const std::vector<std::filesystem::path>& meshes, Terminal& terminal);

/// A starter model by its name, all of them, letters, or the spheres that cover a mesh when it is
/// fitted by its shape; none of these: a list of the names.
struct ModelArguments {
  std::string name;
  bool all = false;
  LetterOptions letters;
  std::filesystem::path covered;
  /// Empty: the name, "letters" or "covering", with .obj. Of all models the folder.
  std::filesystem::path output;
};
int run_model(const ModelArguments& arguments, Terminal& terminal);

/// The folders of the scenes that come with the program, in the order of the alphabet.
std::vector<std::filesystem::path> scene_folders();
int run_scenes();
int run_options(CommonArguments::Output output);

}  // namespace collage
