#include "scene/options_reference.h"

#include <algorithm>

#include "scene/options_table.h"

namespace collage {
namespace {

constexpr const char* introduction = R"(# Scene reference

All keys of a scene file, `scene.toml`. Any of them can be set for one run with
`--set section.key=value`, those of elements with the element's number, `--set element.0.color=#c8102e`.
Lengths are fractions of the target's longest side and angles are degrees; meshes are as big as their
files say, and up is +y. A key that is not listed here is an error.

Letters can stand in for a mesh: `text = { string = "C", font = "DejaVu Sans:bold", depth = 0.5 }`. Fonts are
those that `fc-list` lists, with a style after the colon, or files; a capital letter is 1 high. The finished
folder holds the letters as a mesh and needs no font.

A template of your own (`render.template = "mine.inc"`) is POV-Ray code, not data: it can read and write
files. Render only scenes whose template you would run as a program.
)";

std::string heading(const std::string& section) {
  return section == "element" ? "[[element]]" : "[" + section + "]";
}

/// The default of an option, "" where it has none; it comes from the structs alone.
std::string default_text(const Option& option) {
  Scene scene;
  scene.elements.resize(1);
  const OptionValue value = option.load(scene, 0);
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr && text->empty() ? "" : shown(value);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

std::string text_line(const Option& option) {
  const std::string value = default_text(option);
  return "  " + padded(option.name() + (value.empty() ? "" : " = " + value), 36) + "  " +
         option.help + " (" + accepted_values(option) + ")\n";
}

std::string markdown_row(const Option& option) {
  return "| " + code(option.name()) + " | " + code(default_text(option)) + " | " +
         accepted_values(option) + " | " + option.help + " |\n";
}

template <class Line>
std::string section_lines(const std::string& section, Line line) {
  std::string text;
  for (const Option& option : options_table()) {
    text += option.section() == section ? line(option) : "";
  }
  return text;
}

}  // namespace

std::string options_text() {
  std::string text;
  for (const std::string& section : option_sections()) {
    text += heading(section) + "\n" + section_lines(section, text_line);
  }
  return text;
}

std::string scene_reference_markdown() {
  std::string text = introduction;
  for (const std::string& section : option_sections()) {
    text += "\n## `" + heading(section) +
            "`\n\n| key | default | takes | meaning |\n|---|---|---|---|\n" +
            section_lines(section, markdown_row);
  }
  return text;
}

}  // namespace collage
