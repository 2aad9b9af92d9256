#include "render/report_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "render/embedded_picture.h"
#include "render/html_text.h"
#include "render/report_style.h"

namespace collage {
namespace {

// The longest side in pixels: as wide as the picture is shown, twice on a fine screen or on paper.
constexpr int hero_side = 1600;
constexpr int picture_side = 1024;
constexpr int card_side = 720;

/// More columns than stand beside a heading.
constexpr std::size_t wide_columns = 6;
constexpr std::size_t narrow_columns = 3;

/// `<tag attributes>text</tag>` with the text escaped, or nothing without a text.
std::string element(std::string_view tag, std::string_view attributes, std::string_view text) {
  return text.empty() ? ""
                      : fmt::format("<{0}{1}{2}>{3}</{0}>\n", tag, attributes.empty() ? "" : " ",
                                    attributes, html_text(text));
}

/// Already HTML, in a `<tag class="...">`; nothing where it is empty.
std::string group(std::string_view tag, std::string_view name, const std::string& html) {
  return html.empty() ? "" : fmt::format("<{0} class=\"{1}\">\n{2}</{0}>\n", tag, name, html);
}

template <class Items, class Function>
std::string each(const Items& items, const Function& html) {
  std::string text;
  for (const auto& item : items) {
    text += html(item);
  }
  return text;
}

std::string image(const PagePicture& picture, int side) {
  const EmbeddedPicture embedded = embedded_picture(picture.path, side);
  return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">\n", embedded.uri,
                     embedded.width, embedded.height, html_text(picture.alt));
}

std::string figure(const PagePicture& picture, int side) {
  return "<figure>\n" + image(picture, side) + element("figcaption", "", picture.caption) +
         "</figure>\n";
}

std::string pictures_html(const std::vector<PagePicture>& pictures) {
  return group("div", "pictures", each(pictures, [](const PagePicture& picture) {
                 return figure(picture, picture_side);
               }));
}

std::string hero_pictures(const std::vector<PagePicture>& pictures) {
  if (pictures.empty()) {
    return "";
  }
  return group("div", "hero", figure(pictures.front(), hero_side)) +
         pictures_html({pictures.begin() + 1, pictures.end()});
}

std::string numbers_html(const std::vector<PageNumber>& numbers) {
  return group("dl", "numbers", each(numbers, [](const PageNumber& number) {
                 return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html_text(number.label),
                                    html_text(number.value));
               }));
}

std::string plots_html(const std::vector<Plot>& plots) {
  return group("div", "plots", each(plots, [](const Plot& plot) {
                 return "<figure>\n" + element("figcaption", "", plot.title) + svg_plot(plot) +
                        "</figure>\n";
               }));
}

std::string kind_class(const PageColumn& column) {
  return column.kind == PageColumn::Kind::number ? " class=\"number\"" : "";
}

std::string row_html(const PageRow& row, const std::vector<PageColumn>& columns) {
  std::string text = "<tr>";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string cell = i < row.cells.size() ? html_text(row.cells[i]) : "";
    if (i == 0) {
      text += "<th scope=\"row\">" + cell + element("span", "class=\"note\"", row.note) + "</th>";
    } else {
      text += fmt::format("<td{}>{}</td>", kind_class(columns[i]), cell);
    }
  }
  return text + "</tr>\n";
}

/// Can be scrolled with the keyboard, and is named for those who cannot see it.
std::string table_html(const PageTable& table) {
  std::string head;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    head += fmt::format("<th scope=\"col\"{}>{}</th>", i == 0 ? "" : kind_class(table.columns[i]),
                        html_text(table.columns[i].header));
  }
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n"
      "<table{}>\n{}<thead>\n<tr>{}</tr>\n</thead>\n<tbody>\n{}</tbody>\n</table>\n</div>\n",
      table.caption.empty() ? "Table" : html_text(table.caption),
      table.columns.size() <= narrow_columns ? " class=\"narrow\"" : "",
      element("caption", "", table.caption), head,
      each(table.rows, [&](const PageRow& row) { return row_html(row, table.columns); }));
}

std::string card_html(const PageCard& card) {
  const std::string title = card.link.empty()
                                ? element("h3", "", card.title)
                                : fmt::format("<h3><a href=\"./{}\">{}</a></h3>\n",
                                              url_path(card.link), html_text(card.title));
  return group("article", "card",
               (card.picture.path.empty() ? "" : figure(card.picture, card_side)) + title +
                   element("p", "", card.text) + numbers_html(card.numbers));
}

/// Broken between its words only, so that no line ends within "--set".
std::string command_html(const std::string& command) {
  std::string words = html_text(command);
  for (std::size_t at = 0; (at = words.find(' ', at)) != std::string::npos;) {
    constexpr std::string_view gap = "</span> <span>";
    words.replace(at, 1, gap);
    at += gap.size();
  }
  return "<code><span>" + words + "</span></code>";
}

std::string commands_html(const std::vector<std::string>& commands) {
  return commands.empty() ? "" : "<pre>" + each(commands, command_html) + "</pre>\n";
}

bool is_wide(const PageSection& section) {
  return !section.cards.empty() || std::ranges::any_of(section.tables, [](const PageTable& table) {
    return table.columns.size() > wide_columns;
  });
}

std::string section_html(const PageSection& section) {
  return fmt::format(
      "<section{}>\n<h2>{}</h2>\n<div class=\"content\">\n{}{}{}{}{}{}</div>\n</section>\n",
      is_wide(section) ? " class=\"wide\"" : "", html_text(section.heading),
      each(section.paragraphs, [](const std::string& text) { return element("p", "", text); }),
      commands_html(section.commands), pictures_html(section.pictures), plots_html(section.plots),
      each(section.tables, table_html), group("div", "cards", each(section.cards, card_html)));
}

std::string credit_html(const PageCredit& credit) {
  std::string text = "<cite>" + html_text(credit.title) + "</cite>";
  for (const std::string& part : {credit.author, credit.licence, credit.link}) {
    text += part.empty() ? "" : ", " + html_text(part);
  }
  return "<li>" + text + "</li>\n";
}

std::string credits_html(const std::vector<PageCredit>& credits) {
  if (credits.empty()) {
    return "";
  }
  return "<section>\n<h2>Credits</h2>\n<div class=\"content\">\n" +
         group("ul", "credits", each(credits, credit_html)) + "</div>\n</section>\n";
}

std::string verdict_html(const std::optional<PageVerdict>& verdict) {
  if (!verdict) {
    return "";
  }
  const bool is_passed = verdict->outcome == PageVerdict::Outcome::passed;
  return fmt::format("<p class=\"verdict {}\"><strong>{}</strong> {}</p>\n",
                     is_passed ? "passed" : "failed", is_passed ? "Passed." : "Failed.",
                     html_text(verdict->sentence));
}

constexpr std::string_view policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; "
    "form-action 'none'";

}  // namespace

std::string report_html(const ReportPage& page) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{}{}</style>\n</head>\n"
      "<body>\n<header>\n<h1>{}</h1>\n{}{}{}{}</header>\n<main>\n{}{}</main>\n{}</body>\n</html>\n",
      policy, html_text(page.title), report_style(), plot_style(), html_text(page.title),
      element("p", "class=\"lede\"", page.lede), verdict_html(page.verdict),
      hero_pictures(page.pictures), numbers_html(page.numbers), each(page.sections, section_html),
      credits_html(page.credits), element("footer", "", page.footer));
}

}  // namespace collage
