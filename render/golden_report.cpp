#include "render/golden_report.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/file.h"
#include "base/text.h"
#include "render/html_text.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Golden pictures</title>
<style>
:root { color-scheme: light dark; --page: #fff; --text: #222; --quiet: #666; --line: #ddd; --bad: #b3261e; --good: #2e7d32; }
@media (prefers-color-scheme: dark) {
  :root { --page: #161616; --text: #e6e6e6; --quiet: #9a9a9a; --line: #333; --bad: #ff8a80; --good: #81c784; }
}
body { margin: 2.5rem auto; max-width: 72rem; padding: 0 1.5rem; background: var(--page); color: var(--text); font: 15px/1.5 system-ui, sans-serif; }
h1 { font-weight: 600; font-size: 1.5rem; margin: 0; }
h2 { font-weight: 600; font-size: 1.05rem; margin: 0; }
section { border-top: 1px solid var(--line); padding: 1.25rem 0 1.5rem; }
.row { display: grid; grid-template-columns: repeat(3, 1fr); gap: 1rem; margin-top: .75rem; }
.passed .row { grid-template-columns: repeat(3, minmax(0, 12rem)); }
figure { margin: 0; }
img { width: 100%; height: auto; display: block; image-rendering: pixelated; }
.none { aspect-ratio: 4 / 3; display: grid; place-items: center; border: 1px dashed var(--line); color: var(--quiet); box-sizing: border-box; }
figcaption, .quiet { color: var(--quiet); font-size: .85rem; }
h2 span { color: var(--bad); font-weight: 400; margin-left: .35em; }
.passed h2 span { color: var(--good); }
code { background: color-mix(in srgb, var(--quiet) 15%, transparent); padding: .15em .4em; border-radius: 4px; }
</style>
</head>
<body>
)";

std::string link(const fs::path& path, const fs::path& page) {
  const fs::path folder = fs::absolute(page).parent_path();
  return url_path(fs::absolute(path).lexically_relative(folder).generic_string());
}

bool passes(const GoldenRow& row) {
  return row.comparison && row.comparison->verdict != Verdict::differs;
}

std::string figure(std::string_view caption, const fs::path& picture, const fs::path& page) {
  if (picture.empty()) {
    return fmt::format(
        "<figure><div class=\"none\">none</div><figcaption>{}</figcaption></figure>\n", caption);
  }
  const std::string url = link(picture, page);
  return fmt::format(
      "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a><figcaption>{1}</figcaption>"
      "</figure>\n",
      url, caption);
}

std::string numbers_text(const Comparison::Numbers& numbers) {
  const std::string psnr =
      numbers.psnr_decibels ? fmt::format("{:.1f} dB", *numbers.psnr_decibels) : "infinite";
  return fmt::format(
      "mean error {:.3g} · maximum {:.3g} at {}, {} · PSNR {} · {} of {} pixels fail",
      numbers.mean_error, numbers.max_error, numbers.max_x, numbers.max_y, psnr,
      grouped(static_cast<std::uint64_t>(numbers.failing_pixels)),
      grouped(static_cast<std::uint64_t>(numbers.pixels)));
}

std::string section(const GoldenRow& row, const fs::path& page) {
  const std::string& reason = row.comparison ? row.comparison->reason : row.problem;
  std::string text =
      fmt::format("<section class=\"{}\">\n<h2>{} <span>{}</span></h2>\n<div>{}</div>\n",
                  passes(row) ? "passed" : "failed", html_text(row.name),
                  passes(row) ? "passes" : "fails", html_text(reason));
  if (row.comparison && row.comparison->numbers && row.comparison->verdict != Verdict::same) {
    text += fmt::format("<div class=\"quiet\">{}</div>\n", numbers_text(*row.comparison->numbers));
  }
  return text + "<div class=\"row\">\n" + figure("reference", row.reference, page) +
         figure("new", row.picture, page) + figure("difference, amplified", row.difference, page) +
         "</div>\n</section>\n";
}

}  // namespace

void write_golden_report(const std::vector<GoldenRow>& rows, const std::string& update_command,
                         const fs::path& output) {
  std::vector<GoldenRow> sorted = rows;
  std::stable_partition(sorted.begin(), sorted.end(),
                        [](const GoldenRow& row) { return !passes(row); });
  const auto failures = std::ranges::count_if(rows, [](const auto& row) { return !passes(row); });
  std::string page(head);
  page += fmt::format("<h1>Golden pictures</h1>\n<p>{} of {} pass.",
                      static_cast<std::ptrdiff_t>(rows.size()) - failures, rows.size());
  if (failures > 0) {
    page += fmt::format(
        " Look at the new pictures; if they are right, make them the references with "
        "<code>{}</code>",
        html_text(update_command));
  }
  page += "</p>\n";
  for (const GoldenRow& row : sorted) {
    page += section(row, output);
  }
  write_file(output, page + "</body>\n</html>\n");
}

}  // namespace collage
