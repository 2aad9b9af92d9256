// report_page_sample OUTPUT PICTURE...: writes pages with all that a page can hold, for tests and
// for the eye: report.html of a sculpture, gallery.html of many, and hostile.html of names and
// numbers that mean harm.
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>

#include <fmt/format.h>

#include "base/file.h"
#include "base/text.h"
#include "render/report_page.h"

namespace {

namespace fs = std::filesystem;
using namespace collage;
using Kind = PageColumn::Kind;
using Mark = PlotSeries::Mark;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Pictures = std::vector<fs::path>;

const fs::path& picture(const Pictures& pictures, std::size_t index) {
  return pictures[index % pictures.size()];
}

PlotSeries fill_curve(const std::string& name, double most, int count) {
  PlotSeries series{.name = name};
  for (int n = 1; n <= count; ++n) {
    series.x.push_back(n);
    series.y.push_back(most * std::pow(static_cast<double>(n) / count, 0.4));
  }
  return series;
}

/// Sizes fall off by a power law.
PlotSeries size_histogram() {
  PlotSeries series{.mark = Mark::bars};
  for (int i = 0; i <= 16; ++i) {
    series.x.push_back(0.012 * std::pow(10.0, i / 16.0));
  }
  for (int i = 0; i < 16; ++i) {
    series.y.push_back(std::floor(620.0 * std::pow(10.0, -2.5 * i / 16.0) + i % 3));
  }
  return series;
}

PlotSeries distance_histogram(const std::string& name, double mean) {
  PlotSeries series{.name = name, .mark = Mark::step};
  for (int i = 0; i <= 30; ++i) {
    series.x.push_back(i * 0.1);
  }
  for (int i = 0; i < 30; ++i) {
    series.y.push_back(9.0 * std::exp(-std::pow((i * 0.1 - mean) / 0.45, 2.0)));
  }
  return series;
}

PlotSeries shells() {
  return {.mark = Mark::bars,
          .x = {0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100},
          .y = {5.1, 9.4, 13.2, 15.9, 17.3, 18.8, 19.0, 20.2, 21.7, 22.4}};
}

std::vector<Plot> plots() {
  return {{.title = "How full the teapot is, copy by copy",
           .x = {"copies placed"},
           .y = {"fill, %"},
           .series = {fill_curve("to shape", 21.4, 2043), fill_curve("to sphere", 14.4, 1610)}},
          {.title = "How many copies there are of each size",
           .x = {"size, of the longest side", AxisScale::logarithmic},
           .y = {"copies", AxisScale::logarithmic},
           .series = {size_histogram()}},
          {.title = "How far the surface of the teapot is from the nearest copy",
           .x = {"distance, % of the longest side"},
           .y = {"share of the surface, %"},
           .series = {distance_histogram("to shape", 0.7), distance_histogram("to sphere", 1.3)}},
          {.title = "How full each shell is, from the surface to the middle",
           .x = {"depth, %"},
           .y = {"fill, %"},
           .series = {shells()}}};
}

PageTable promises() {
  return {.caption = "What the audit looked at",
          .columns = {{"promise", Kind::text}, {"looked at"}, {"broken"}},
          .rows = {{{"No overlap", "2,086,903", "0"},
                    "Pairs of copies whose surfaces meet, or one of which lies in the other."},
                   {{"No protrusion", "2,043", "0"},
                    "Copies that meet the surface of the teapot or reach out of it."},
                   {{"Rigid", "2,043", "0"},
                    "Copies that are anything but turned, moved and scaled evenly."}}};
}

PageTable figures() {
  return {
      .caption = "Figures",
      .columns = {{"measure", Kind::text}, {"value"}},
      .rows = {{{"Fill", "14.39 %"}, "Volume of the copies by that of the teapot."},
               {{"Largest hole left", "0.0120"},
                "Radius of the largest sphere that still fits, as a share of the longest side."},
               {{"Voxels", "338,130"}, "The grid in which holes are looked for."},
               {{"Time to pack", "1.02 s"}, "On two cores, without pictures."}}};
}

ReportPage report(const Pictures& pictures) {
  return {
      .title = "A teapot of teacups",
      .lede =
          "2,043 teacups in five glazes fill the teapot that Martin Newell drew in 1975. They "
          "do not touch, and none is bent.",
      .verdict =
          PageVerdict{PageVerdict::Outcome::passed, "Nothing overlaps, sticks out or is deformed."},
      .pictures = {{picture(pictures, 0), "The teapot from three quarters, made of teacups",
                    "Three quarters, in the light of the studio."},
                   {picture(pictures, 1), "The teapot from the front", "From the front."},
                   {picture(pictures, 2), "The teapot from the left and above",
                    "From the left, 35° above the horizon."}},
      .numbers = {{"2,043", "teacups"},
                  {"14.4 %", "of the teapot filled"},
                  {"1.0 s", "to pack"},
                  {"0", "overlaps"}},
      .sections =
          {{.heading = "Promises",
            .paragraphs = {"The audit shares no code with the packing. It compares surfaces "
                           "triangle by triangle with exact predicates, and reads the matrices "
                           "back from the scene that was rendered."},
            .tables = {promises()}},
           {.heading = "Stages",
            .paragraphs = {"The largest hole is filled first. What comes later is smaller."},
            .pictures = {{picture(pictures, 3), "The teapot after 2 %, 20 % and all of its cups",
                          "After 2 %, 20 % and all of the cups."}}},
           {.heading = "Measures", .plots = plots(), .tables = {figures()}},
           {.heading = "Make it again",
            .paragraphs =
                {"The same scene and seed give the same bytes, on any number of threads."},
            .commands = {"collage make scenes/teapot --seed 1 --set packing.threshold=0.012 "
                         "--set target.resolution=100",
                         "collage audit out/teapot"},
            .tables = {{.columns = {{"made with", Kind::text}, {"", Kind::text}},
                        .rows = {{{"seed", "1"}, ""},
                                 {{"collage", "0.1.0"}, ""},
                                 {{"POV-Ray", "3.7.0.10"}, ""}}}}}},
      .credits = {{"Utah teapot", "Martin Newell, 1975", "public domain", ""},
                  {"Teacup", "the collage authors", "Apache-2.0", "https://example.org/teacup"}},
      .footer = "collage 0.1.0 · seed 1 · scene.toml 3fb2a9c1"};
}

PageCard card(const Pictures& pictures, std::size_t index) {
  const std::string name = fmt::format("Sculpture {}", index + 1);
  return {.title = name,
          .picture = {picture(pictures, index), "A picture of " + name, ""},
          .text = "Teacups in a teapot, from three quarters.",
          .numbers = {{grouped(700 * (index + 1)), "copies"}, {"14.4 %", "fill"}},
          .link = fmt::format("sculpture {}/report.html", index + 1)};
}

PageTable comparison() {
  PageTable table{.caption = "All sculptures", .columns = {{"sculpture", Kind::text}}};
  for (const char* name :
       {"copies", "fill, %", "largest hole", "overlaps", "protrusions", "pack, s", "update, s",
        "audit, s", "render, s", "memory, MB", "faces"}) {
    table.columns.push_back({name});
  }
  for (int i = 1; i <= 8; ++i) {
    table.rows.push_back(
        {{fmt::format("Sculpture {}", i), grouped(700U * static_cast<unsigned>(i)),
          fmt::format("{:.1f}", 9.0 + i), "0.0120", "0", "0", fmt::format("{:.2f}", 0.4 * i),
          "0.23", "1.10", "91.4", "214", "653,760"},
         ""});
  }
  return table;
}

ReportPage gallery(const Pictures& pictures) {
  PageSection cards{.heading = "Sculptures"};
  for (std::size_t i = 0; i < std::max<std::size_t>(7, pictures.size()); ++i) {
    cards.cards.push_back(card(pictures, i));
  }
  return {.title = "Gallery",
          .lede = "Everything that the scenes make.",
          .sections = {cards, {.heading = "Compared", .tables = {comparison(), comparison()}}},
          .footer = "collage 0.1.0"};
}

/// Names that try to be HTML, and numbers that are none.
ReportPage hostile(const Pictures& pictures) {
  const std::string script = "</title></style><script>document.title = 'run'</script>";
  const std::string quoted = "\" onerror=\"document.title='run'\" x='";
  const std::string endless(300, 'n');
  const std::vector<double> wild = {nan, infinity, -infinity, 1e308, -1e308, 1e-320, 0.0, 1.0};
  const PagePicture image{picture(pictures, 0), quoted, script};
  const PageTable table{script,
                        {{script, Kind::text}, {quoted}, {endless}},
                        {{{quoted, script, endless}, script}, {{}, ""}}};
  PageSection section{.heading = script,
                      .paragraphs = {script, endless},
                      .commands = {script, endless},
                      .pictures = {image, image},
                      .tables = {table}};
  section.cards = {{script, image, endless, {{script, endless}}, "javascript:alert(1)//" + script}};
  for (const AxisScale scale : {AxisScale::linear, AxisScale::logarithmic}) {
    section.plots.push_back(
        {script, {endless.substr(0, 20), scale}, {script.substr(0, 20), scale}, {}});
    for (const Mark mark : {Mark::line, Mark::step, Mark::bars}) {
      section.plots.push_back({quoted,
                               {"x", scale},
                               {"y", scale},
                               {{script, mark, wild, wild}, {endless, mark, {1.0, 1.0}, {1.0}}}});
      section.plots.push_back(
          {quoted, {"x", scale}, {"y", scale}, {{"one", mark, {3.0, 3.5}, {2.0}}}});
      section.plots.push_back(
          {quoted, {"x", scale}, {"y", scale}, {{"", mark, {1e-9, 1e3, 2e7}, {-4e-12, 5e8, 7e9}}}});
    }
  }
  return {script,
          endless,
          PageVerdict{PageVerdict::Outcome::failed, script},
          {image},
          {{endless, script}},
          {section},
          {{script, endless, quoted, script}},
          script};
}

int run(const fs::path& output, const Pictures& pictures) {
  write_file(output / "report.html", report_html(report(pictures)));
  write_file(output / "gallery.html", report_html(gallery(pictures)));
  write_file(output / "hostile.html", report_html(hostile(pictures)));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: report_page_sample OUTPUT PICTURE...\n");
    return 2;
  }
  try {
    return run(argv[1], {argv + 2, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
}
