#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/svg_plot.h"

namespace collage {

// A page of text, tables, plots and pictures: the report of a sculpture, or a gallery of many. All
// texts are plain UTF-8 of any origin and are escaped; "" and empty lists leave their part out.

struct PagePicture {
  /// PNG or EXR.
  std::filesystem::path path{};
  /// What there is to see, for those who cannot see it.
  std::string alt{};
  std::string caption{};
};

/// A large number with its name below: "2,043", "teacups".
struct PageNumber {
  std::string value{};
  std::string label{};
};

struct PageColumn {
  enum class Kind { text, number };
  std::string header{};
  /// Numbers stand to the right, digit below digit; give those of a column equally many decimals.
  Kind kind = Kind::number;
};

struct PageRow {
  /// One for each column; the first names the row.
  std::vector<std::string> cells{};
  /// One sentence that says what the row's numbers mean; below its name.
  std::string note{};
};

/// A table wider than the page scrolls within its own width.
struct PageTable {
  std::string caption{};
  std::vector<PageColumn> columns{};
  std::vector<PageRow> rows{};
};

/// One of many: a picture with its title, text and numbers.
struct PageCard {
  std::string title{};
  PagePicture picture{};
  std::string text{};
  std::vector<PageNumber> numbers{};
  /// Where the title leads, relative to the page: "teapot/report.html". Always taken for a path.
  std::string link{};
};

/// Shown in the order of the members.
struct PageSection {
  std::string heading{};
  std::vector<std::string> paragraphs{};
  /// Each a line to type into a shell.
  std::vector<std::string> commands{};
  std::vector<PagePicture> pictures{};
  std::vector<Plot> plots{};
  std::vector<PageTable> tables{};
  std::vector<PageCard> cards{};
};

struct PageVerdict {
  enum class Outcome { passed, failed };
  Outcome outcome = Outcome::passed;
  std::string sentence{};
};

/// Whose work is in it. `link` is printed and leads nowhere: the page reaches for nothing outside.
struct PageCredit {
  std::string title{};
  std::string author{};
  std::string licence{};
  std::string link{};
};

struct ReportPage {
  std::string title{};
  /// One or two sentences below the title.
  std::string lede{};
  std::optional<PageVerdict> verdict{};
  /// The first across the page, the others in a row below.
  std::vector<PagePicture> pictures{};
  std::vector<PageNumber> numbers{};
  std::vector<PageSection> sections{};
  std::vector<PageCredit> credits{};
  /// The last line: "collage 0.1.0, seed 1".
  std::string footer{};
};

/// The page as one file of HTML that needs nothing else: pictures are data: URIs made small enough
/// for a page (about 200 KB each), plots inline SVG, no script at all; a Content-Security-Policy
/// forbids anything else. It follows the reader's light or dark, and goes from a phone to paper.
/// Equal input gives equal bytes. Throws Error where a picture cannot be read. Write it with
/// write_file().
std::string report_html(const ReportPage& page);

}  // namespace collage
