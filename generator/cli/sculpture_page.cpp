#include "cli/sculpture_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/file.h"
#include "base/text.h"
#include "cli/outline.h"
#include "cli/render_outputs.h"
#include "render/report_page.h"

namespace collage {
namespace {

namespace fs = std::filesystem;
using Kind = PageColumn::Kind;

std::string percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

/// Writes the page's parts for one sculpture.
class PageWriter {
 public:
  PageWriter(const fs::path& folder, const FinishedFolder& finished, const Report& report,
             const FolderAudit& audit)
      : folder_(folder),
        sculpture_(finished.sculpture),
        scene_(finished.sculpture.options),
        report_(report),
        audit_(audit),
        measures_(audit.measures) {}

  [[nodiscard]] ReportPage page() const {
    ReportPage page;
    page.title = scene_.name;
    page.lede = fmt::format("{} filled with {} of {}, biggest first.", target_name(),
                            grouped(report_.instances) + " copies", element_names());
    if (report_.stopped) {
      page.lede += " Not complete: packing was ended early, by " + *report_.stopped + ".";
    }
    page.verdict = {audit_.passed() ? PageVerdict::Outcome::passed : PageVerdict::Outcome::failed,
                    verdict_sentence(audit_)};
    page.pictures = stills();
    page.numbers = numbers();
    page.sections = {measured("What is proved", AuditLine::Group::promise),
                     likeness(),
                     density(),
                     variety(),
                     elements(),
                     stages(),
                     again()};
    page.credits = credits();
    page.footer = fmt::format("collage {}, seed {}", sculpture_.version, report_.seed);
    return page;
  }

 private:
  [[nodiscard]] std::string target_name() const { return sculpture_.target.path.stem().string(); }
  [[nodiscard]] std::string element_names() const {
    std::vector<std::string> names;
    for (const Sculpture::Element& element : sculpture_.elements) {
      if (std::ranges::find(names, element.name) == names.end()) {
        names.push_back(element.name);
      }
    }
    constexpr std::size_t most = 4;
    if (names.size() > most) {
      return fmt::format("{} shapes", names.size());
    }
    std::string text = names.front();
    for (std::size_t i = 1; i < names.size(); ++i) {
      text += (i + 1 < names.size() ? ", " : " and ") + names[i];
    }
    return text;
  }

  [[nodiscard]] std::vector<PagePicture> stills() const {
    std::vector<PagePicture> pictures;
    for (const std::string& view : scene_.render.stills) {
      const fs::path path = still_path(folder_, still_shot(scene_, view));
      if (fs::exists(path)) {
        pictures.push_back({path, fmt::format("{} seen from {}", scene_.name, view), view});
      }
    }
    return pictures;
  }

  [[nodiscard]] std::vector<PageNumber> numbers() const {
    std::vector<PageNumber> numbers{{grouped(report_.instances), "copies"},
                                    {percent(report_.fill), "of the volume filled"}};
    if (measures_.silhouette_iou) {
      numbers.push_back({percent(measures_.silhouette_iou->mean), "of the outline kept"});
    }
    numbers.push_back(
        {fmt::format("{:.1f} s", report_.seconds.place + report_.seconds.update), "to place them"});
    return numbers;
  }

  /// A table of those lines that belong under one heading.
  [[nodiscard]] PageSection measured(const char* heading, AuditLine::Group group) const {
    PageSection section;
    section.heading = heading;
    section.tables = {{"", {{"what", Kind::text}, {"found"}}, {}}};
    for (const AuditLine& line : audit_lines(audit_)) {
      if (line.group == group) {
        section.tables[0].rows.push_back({{line.name, line.value}, line.meaning});
      }
    }
    return section;
  }

  [[nodiscard]] PageSection likeness() const {
    PageSection section = measured("Is it recognisable?", AuditLine::Group::likeness);
    if (const auto& surface = measures_.surface_distance) {
      PlotSeries series{"", PlotSeries::Mark::bars, {0.0}, {}};
      for (std::size_t i = 0; i < surface->histogram.size(); ++i) {
        series.x.push_back(100.0 * surface->bin_width * static_cast<double>(i + 1));
        series.y.push_back(100.0 * static_cast<double>(surface->histogram[i]) /
                           static_cast<double>(surface->points));
      }
      section.plots.push_back({"How far the target's surface is from the nearest copy",
                               {"distance, % of the longest side"},
                               {"share of the surface, %"},
                               {series}});
    }
    const fs::path outline = outline_path(folder_);
    if (fs::exists(outline)) {
      section.pictures.push_back(
          {outline, "The outlines of target and sculpture laid over each other",
           "From where the outlines agree least: dark where both are, red where the sculpture "
           "is missing"});
    }
    return section;
  }

  [[nodiscard]] PageSection density() const {
    PageSection section = measured("How full is it?", AuditLine::Group::density);
    if (measures_.fill) {
      section.plots = {growth_plot(*measures_.fill), shells_plot(*measures_.fill)};
    }
    return section;
  }

  static Plot growth_plot(const Fill& fill) {
    PlotSeries series{"", PlotSeries::Mark::line, {}, {}};
    for (const Fill::Step& step : fill.growth) {
      series.x.push_back(static_cast<double>(step.instances));
      series.y.push_back(100.0 * step.by_volume);
    }
    return {"Fill as copies are added", {"copies", AxisScale::logarithmic}, {"fill, %"}, {series}};
  }

  static Plot shells_plot(const Fill& fill) {
    PlotSeries series{"", PlotSeries::Mark::bars, {0.0}, {}};
    for (const Fill::Sample& shell : fill.by_shell) {
      series.x.push_back(series.x.back() + 10.0);
      series.y.push_back(100.0 * shell.share().value_or(0.0));
    }
    return {"Fill from the surface (0 %) to the core (100 %)",
            {"depth, % of the greatest"},
            {"fill, %"},
            {series}};
  }

  [[nodiscard]] PageSection variety() const {
    PageSection section = measured("How varied is it?", AuditLine::Group::variety);
    if (measures_.sizes && measures_.target_side > 0.0) {
      section.plots = {sizes_plot(*measures_.sizes, measures_.target_side)};
    }
    return section;
  }

  static Plot sizes_plot(const Sizes& sizes, double side) {
    PlotSeries series{"", PlotSeries::Mark::step, {}, {}};
    const std::size_t bins = sizes.histogram.size();
    for (std::size_t i = 0; i <= bins; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(bins);
      const double size = sizes.smallest * std::pow(sizes.largest / sizes.smallest, share);
      series.x.push_back(100.0 * size / side);
    }
    series.y.assign(sizes.histogram.begin(), sizes.histogram.end());
    return {"Sizes of the copies",
            {"radius, % of the longest side", AxisScale::logarithmic},
            {"copies", AxisScale::logarithmic},
            {series}};
  }

  [[nodiscard]] PageSection elements() const {
    PageSection section;
    section.heading = "Elements";
    PageTable table{"", {{"element", Kind::text}, {"faces"}, {"copies"}, {"faces in all"}}, {}};
    for (const Report::Element& element : report_.elements) {
      table.rows.push_back({{element.name, grouped(element.faces), grouped(element.instances),
                             grouped(element.faces * element.instances)},
                            ""});
    }
    section.tables = {table};
    return section;
  }

  [[nodiscard]] PageSection stages() const {
    PageSection section;
    for (const char* sheet : {"stages.png", "turntable.png"}) {
      const fs::path path = folder_ / "sheets" / sheet;
      if (fs::exists(path)) {
        section.pictures.push_back({path, "Contact sheet: " + path.stem().string(), ""});
      }
    }
    if (!section.pictures.empty()) {
      section.heading = "Stages and turntable";
    }
    return section;
  }

  [[nodiscard]] PageSection again() const {
    PageSection section;
    section.heading = "Make it again";
    section.paragraphs = {fmt::format(
        "With collage {}, seed {}. The same scene and seed give the same sculpture, byte "
        "for byte, on any machine and any number of threads.",
        sculpture_.version, report_.seed)};
    section.commands = {sculpture_.command, "collage audit FOLDER",
                        "collage still FOLDER --view 30/15"};
    PageTable inputs{"Inputs", {{"file", Kind::text}, {"SHA-256", Kind::text}}, {}};
    inputs.rows.push_back(
        {{sculpture_.target.path.generic_string(), sculpture_.target.sha256}, ""});
    for (const Sculpture::Element& element : sculpture_.elements) {
      inputs.rows.push_back({{element.path.generic_string(), element.sha256}, ""});
    }
    for (const Sculpture::Input& prop : sculpture_.props) {
      inputs.rows.push_back({{prop.path.generic_string(), prop.sha256}, ""});
    }
    section.tables = {inputs};
    return section;
  }

  /// Of each work once.
  [[nodiscard]] std::vector<PageCredit> credits() const {
    std::vector<PageCredit> credits;
    const auto add = [&](const Sculpture::Input& input) {
      if (input.credit &&
          std::ranges::find(credits, input.credit->title, &PageCredit::title) == credits.end()) {
        const Credit& credit = *input.credit;
        credits.push_back({credit.title, credit.author, credit.licence, credit.link});
      }
    };
    add(sculpture_.target);
    std::ranges::for_each(sculpture_.elements, add);
    std::ranges::for_each(sculpture_.props, add);
    return credits;
  }

  const fs::path& folder_;
  const Sculpture& sculpture_;
  const Scene& scene_;
  const Report& report_;
  const FolderAudit& audit_;
  const Measures& measures_;
};

}  // namespace

void write_sculpture_page(const fs::path& folder, const FinishedFolder& finished,
                          const Report& report, const FolderAudit& audit) {
  write_file(folder / "report.html",
             report_html(PageWriter(folder, finished, report, audit).page()));
}

}  // namespace collage
