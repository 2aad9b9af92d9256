#include "scene/options_table.h"

#include <algorithm>
#include <utility>

#include "scene/option_row.h"

namespace collage {
namespace {

using option_row::element_option;
using option_row::option;

constexpr double largest_exact_integer = 9007199254740992.0;  // 2^53: the same in JSON and TOML
constexpr double largest_picture = 16384.0;

constexpr const char* mesh_places =
    "starting from the scene's folder, or \"LIBRARY:PATH\" for one of a mesh library";
constexpr const char* repair_help =
    "whether the mesh is put right, by welding, closing small holes, and turning faces so that "
    "they agree and its parts face outwards, or taken as the file has it";
const std::vector<std::string> repair_words{"full", "none"};
const std::vector<std::string> qualities{"draft", "standard", "fine"};
const std::vector<std::string> looks{"studio", "daylight", "clay", "x-ray", "breakdown"};
const std::vector<std::string> views{"front", "three-quarter", "right", "back", "left", "top"};

/// The letters that stand in for a mesh. `row` makes a row of the table from the field that a
/// lambda finds, `letters_of` finds the letters.
template <class Row, class LettersOf>
void append_letter_options(std::vector<Option>& table, const std::string& section,
                           const std::string& help, Row row, LettersOf letters_of) {
  const auto append = [&](const char* name, auto field, OptionText text) {
    table.push_back(row(
        section + ".text." + name, [=](auto& owner) -> auto& { return letters_of(owner).*field; },
        std::move(text)));
  };
  append("string", &LetterOptions::string, {.help = help, .form = TextForm::letters});
  append("font", &LetterOptions::font,
         {.unit = "starting from the scene's folder",
          .help = "font of the letters",
          .form = TextForm::font});
  append("depth", &LetterOptions::depth,
         {.minimum = 0.01,
          .maximum = 10,
          .unit = "a fraction of a capital letter's height",
          .help = "how thick the letters are"});
  append("bevel", &LetterOptions::bevel,
         {.minimum = 0,
          .maximum = 0.5,
          .unit = "a fraction of a capital letter's height",
          .help = "how much of their edges is cut off, less where strokes are thin"});
}

void append_target_options(std::vector<Option>& table) {
  table.push_back(option(
      "target.mesh", [](auto& s) -> auto& { return s.target.mesh; },
      {.unit = mesh_places, .help = "OBJ file of the shape to fill", .form = TextForm::path}));
  table.push_back(option("target.sdf", [](auto& s) -> auto& { return s.target.sdf; },
                         {.unit = "starting from the scene's folder",
                          .help = "grid of signed distances to fill, instead of a mesh",
                          .form = TextForm::path}));
  append_letter_options(
      table, "target", "letters to fill, instead of a mesh",
      [](auto... arguments) { return option(std::move(arguments)...); },
      [](auto& scene) -> auto& { return scene.target.text; });
  table.push_back(option("target.repair", [](auto& s) -> auto& { return s.target.repair; },
                         {.help = repair_help, .words = repair_words}));
  table.push_back(option("target.resolution", [](auto& s) -> auto& { return s.target.resolution; },
                         {.minimum = 1,
                          .maximum = 2048,
                          .unit = "voxels on the target's longest side",
                          .help = "how finely holes are looked for"}));
  table.push_back(option("target.jitter", [](auto& s) -> auto& { return s.target.jitter; },
                         {.minimum = 0,
                          .maximum = 1,
                          .unit = "a fraction of a voxel's side",
                          .help = "how far sample points stray from the voxels' centres"}));
}

void append_element_options(std::vector<Option>& table) {
  table.push_back(element_option(
      "element.mesh", [](auto& e) -> auto& { return e.mesh; },
      {.unit = mesh_places, .help = "OBJ file of the shape to fill with", .form = TextForm::path}));
  append_letter_options(
      table, "element", "letters to fill with, instead of a mesh",
      [](auto... arguments) { return element_option(std::move(arguments)...); },
      [](auto& element) -> auto& { return element.text; });
  table.push_back(element_option("element.repair", [](auto& e) -> auto& { return e.repair; },
                                 {.help = repair_help, .words = repair_words}));
  table.push_back(
      element_option("element.scales", [](auto& e) -> auto& { return e.scales; },
                     {.minimum = 1e-6,
                      .maximum = 1e6,
                      .unit = "factors of the mesh's own size",
                      .help = "the sizes it may have where packing.scaling is \"fixed\"",
                      .least_count = 1}));
  table.push_back(element_option("element.weight", [](auto& e) -> auto& { return e.weight; },
                                 {.minimum = 0,
                                  .maximum = 1e6,
                                  .unit = "relative to the other elements",
                                  .help = "how often it is taken where packing.choose is "
                                          "\"weighted\""}));
  const auto append_side = [&](const char* key, auto field, std::string help) {
    table.push_back(element_option(key, [=](auto& e) -> auto& { return e.*field; },
                                   {.minimum = 0,
                                    .maximum = 1,
                                    .unit = "a fraction of the target's width, from -x to +x",
                                    .help = std::move(help)}));
  };
  append_side("element.left", &Scene::Element::left,
              "where the stretch begins that it is placed in, by its centre");
  append_side("element.right", &Scene::Element::right, "where that stretch ends");
  table.push_back(element_option("element.color", [](auto& e) -> auto& { return e.color; },
                                 {.unit = "in sRGB",
                                  .help = "its colour, in place of the mesh file's materials",
                                  .form = TextForm::color}));
  table.push_back(element_option(
      "element.finish", [](auto& e) -> auto& { return e.finish; },
      {.help = "how it reflects light; \"auto\": as its materials say", .words = finish_words()}));
}

void append_packing_options(std::vector<Option>& table) {
  table.push_back(option("packing.threshold", [](auto& s) -> auto& { return s.packing.threshold; },
                         {.minimum = 0.0001,
                          .maximum = 1,
                          .unit = "a fraction of the target's longest side",
                          .help = "radius of the smallest hole that is still filled; by shape, "
                                  "of the smallest element"}));
  table.push_back(option("packing.threshold_core",
                         [](auto& s) -> auto& { return s.packing.threshold_core; },
                         {.minimum = 0,
                          .maximum = 1,
                          .unit = "a fraction of the target's longest side, 0 for the same",
                          .help = "by shape: the threshold at the deepest point of the target, "
                                  "blended by depth to the power of 1.5"}));
  table.push_back(option("packing.largest", [](auto& s) -> auto& { return s.packing.largest; },
                         {.minimum = 0.0001,
                          .maximum = 1,
                          .unit = "a fraction of the target's longest side",
                          .help = "by shape: radius of the largest element where packing.scaling "
                                  "is \"to-hole\""}));
  table.push_back(option("packing.scaling", [](auto& s) -> auto& { return s.packing.scaling; },
                         {.help = "whether elements keep their sizes or grow to fit the hole",
                          .words = {"fixed", "to-hole"}}));
  table.push_back(option("packing.choose", [](auto& s) -> auto& { return s.packing.choose; },
                         {.help = "which of the elements that fit is taken",
                          .words = {"largest", "alternate", "weighted"}}));
  table.push_back(
      option("packing.fit", [](auto& s) -> auto& { return s.packing.fit; },
             {.help = "what must lie in the hole: the element's bounding sphere, or itself",
              .words = {"sphere", "shape"}}));
  table.push_back(option("packing.linking", [](auto& s) -> auto& { return s.packing.linking; },
                         {.help = "by shape: whether rings may hang in one another",
                          .words = {"avoid", "allow", "seek"}}));
  table.push_back(option("packing.distance", [](auto& s) -> auto& { return s.packing.distance; },
                         {.help = "distance to surfaces, or to vertices only, which overlaps",
                          .words = {"exact", "vertices"}}));
  table.push_back(option("packing.spacing", [](auto& s) -> auto& { return s.packing.spacing; },
                         {.minimum = 0,
                          .maximum = 0.5,
                          .unit = "a fraction of the target's longest side",
                          .help = "air kept between instances and to the target"}));
  table.push_back(option("packing.climb", [](auto& s) -> auto& { return s.packing.climb; },
                         {.help = "by spheres: whether an element is centred where the hole is "
                                  "widest, between the voxels, which fills more and takes a few "
                                  "times as long"}));
  table.push_back(option("packing.seed", [](auto& s) -> auto& { return s.packing.seed; },
                         {.minimum = 0,
                          .maximum = largest_exact_integer,
                          .help = "start of all random choices; the same seed, the same result"}));
}

void append_render_options(std::vector<Option>& table) {
  table.push_back(option("render.template", [](auto& s) -> auto& { return s.render.look; },
                         {.help = "light, floor, camera and finish; a .inc file of your own is "
                                  "code that POV-Ray runs",
                          .form = TextForm::look,
                          .words = looks}));
  table.push_back(option("render.size", [](auto& s) -> auto& { return s.render.size; },
                         {.minimum = 16,
                          .maximum = largest_picture,
                          .unit = "width and height in pixels",
                          .help = "size of a still"}));
  table.push_back(
      option("render.stills", [](auto& s) -> auto& { return s.render.stills; },
             {.help = "views that pictures are made of", .form = TextForm::view, .words = views}));
  table.push_back(option("render.quality", [](auto& s) -> auto& { return s.render.quality; },
                         {.help = "light of the stills: \"draft\" and \"standard\" are the same "
                                  "pixels every time",
                          .form = TextForm::word,
                          .words = qualities}));
  table.push_back(option("render.exr", [](auto& s) -> auto& { return s.render.exr; },
                         {.help = "also write stills as OpenEXR with linear light"}));
  table.push_back(option("render.props", [](auto& s) -> auto& { return s.render.props; },
                         {.unit = mesh_places,
                          .help = "OBJ files shown as they stand beside what is packed, such as a "
                                  "bowl; nothing keeps clear of them",
                          .form = TextForm::path}));
}

void append_turntable_options(std::vector<Option>& table) {
  table.push_back(option(
      "turntable.frames", [](auto& s) -> auto& { return s.turntable.frames; },
      {.minimum = 0, .maximum = 3600, .unit = "0 for no turntable", .help = "pictures all round"}));
  table.push_back(option("turntable.size", [](auto& s) -> auto& { return s.turntable.size; },
                         {.minimum = 16,
                          .maximum = largest_picture,
                          .unit = "width and height in pixels",
                          .help = "size of a frame"}));
  table.push_back(
      option("turntable.quality", [](auto& s) -> auto& { return s.turntable.quality; },
             {.help = "light of the frames", .form = TextForm::word, .words = qualities}));
  table.push_back(option("turntable.elevation",
                         [](auto& s) -> auto& { return s.turntable.elevation_degrees; },
                         {.minimum = -90,
                          .maximum = 90,
                          .unit = "degrees above the horizon",
                          .help = "where the camera looks from"}));
  table.push_back(option(
      "turntable.fps", [](auto& s) -> auto& { return s.turntable.frames_per_second; },
      {.minimum = 1, .maximum = 120, .unit = "frames a second", .help = "speed of the film"}));
}

void append_sheet_options(std::vector<Option>& table) {
  table.push_back(option("contact_sheet.columns",
                         [](auto& s) -> auto& { return s.contact_sheet.columns; },
                         {.minimum = 1, .maximum = 100, .help = "pictures side by side"}));
  table.push_back(option("contact_sheet.stages",
                         [](auto& s) -> auto& { return s.contact_sheet.stages; },
                         {.minimum = 0.0001,
                          .maximum = 1,
                          .unit = "shares of the number of instances",
                          .help = "stages of assembly shown; an empty list for no such sheet"}));
  table.push_back(
      option("contact_sheet.quality", [](auto& s) -> auto& { return s.contact_sheet.quality; },
             {.help = "light of the stages", .form = TextForm::word, .words = qualities}));
  table.push_back(option("contact_sheet.size",
                         [](auto& s) -> auto& { return s.contact_sheet.size; },
                         {.minimum = 16,
                          .maximum = largest_picture,
                          .unit = "width and height in pixels",
                          .help = "size of one picture on the sheet"}));
}

std::vector<Option> make_table() {
  std::vector<Option> table;
  append_target_options(table);
  append_element_options(table);
  append_packing_options(table);
  append_render_options(table);
  append_turntable_options(table);
  append_sheet_options(table);
  return table;
}

std::vector<std::string> make_sections() {
  std::vector<std::string> sections;
  for (const Option& option : options_table()) {
    if (sections.empty() || sections.back() != option.section()) {
      sections.push_back(option.section());
    }
  }
  return sections;
}

}  // namespace

const std::vector<Option>& options_table() {
  static const std::vector<Option> table = make_table();
  return table;
}

const std::vector<std::string>& option_sections() {
  static const std::vector<std::string> sections = make_sections();
  return sections;
}

const Option* find_option(const std::string& key) {
  const auto& table = options_table();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Option& option) { return option.key == key; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace collage
