#include "render/report_page.h"

#include "unit/render/support.h"

namespace collage {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::plain_picture;
using testing::TestFolder;

class ReportPageTest : public ::testing::Test {
 protected:
  ReportPageTest() { write_picture(folder_ / "a.png", plain_picture(40, 30)); }

  /// A page with `text` in every place that takes one.
  [[nodiscard]] ReportPage page_of(const std::string& text) const {
    const PagePicture picture{folder_ / "a.png", text, text};
    const PageNumber number{text, text};
    const Plot plot{text, {text}, {text}, {{.name = text, .x = {1, 2}, .y = {1, 2}}}};
    const PageSection section{.heading = text,
                              .paragraphs = {text},
                              .commands = {text},
                              .pictures = {picture},
                              .plots = {plot},
                              .tables = {{text, {{text}, {text}}, {{{text, text}, text}}}},
                              .cards = {{text, picture, text, {number}, text}}};
    return {.title = text,
            .lede = text,
            .verdict = PageVerdict{PageVerdict::Outcome::failed, text},
            .pictures = {picture, picture},
            .numbers = {number},
            .sections = {section},
            .credits = {{text, text, text, text}},
            .footer = text};
  }
  TestFolder folder_;
};

TEST_F(ReportPageTest, escapes_every_text) {
  const std::string plain = report_html(page_of("x"));
  const std::string page = report_html(page_of("</style><script>\"'&"));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_EQ(std::ranges::count(page, '<'), std::ranges::count(plain, '<'))
      << "text never becomes an element";
  EXPECT_THAT(page, Not(HasSubstr("\"'&\"")));
}

TEST_F(ReportPageTest, reaches_for_nothing_outside) {
  const std::string page = report_html(page_of("https://example.org/ url(x) @import"));
  for (const std::string_view attribute : {" src=\"", " href=\"", " srcset=\"", " data=\""}) {
    for (std::size_t at = page.find(attribute); at != std::string::npos;
         at = page.find(attribute, at + 1)) {
      const std::string target = page.substr(at + attribute.size(), 80);
      EXPECT_TRUE(target.starts_with("data:") || target.starts_with("./")) << target;
    }
  }
  const std::size_t from = page.find("<style>");
  const std::string style = page.substr(from, page.find("</style>") - from);
  EXPECT_THAT(style, Not(HasSubstr("url(")));
  EXPECT_THAT(style, Not(HasSubstr("@import")));
  EXPECT_THAT(page, HasSubstr("content=\"default-src 'none'; img-src data:; "
                              "style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\""));
}

TEST_F(ReportPageTest, a_link_is_always_a_path) {
  const auto link = [](const std::string& target) {
    return report_html({.sections = {{.cards = {{.title = "t", .link = target}}}}});
  };
  EXPECT_THAT(link("a b/report.html"), HasSubstr("href=\"./a%20b/report.html\""));
  EXPECT_THAT(link("javascript:alert(1)"), HasSubstr("href=\"./javascript%3Aalert%281%29\""));
  EXPECT_THAT(link("//example.org"), HasSubstr("href=\".///example.org\""));
  EXPECT_THAT(link(""), Not(HasSubstr("<a ")));
}

TEST_F(ReportPageTest, pictures_have_their_size_and_words) {
  const std::string page =
      report_html({.pictures = {{folder_ / "a.png", "a grey picture", "Grey."}}});
  EXPECT_THAT(page, HasSubstr("width=\"40\" height=\"30\" alt=\"a grey picture\">"));
  EXPECT_THAT(page, HasSubstr("<figcaption>Grey.</figcaption>"));
  EXPECT_THAT(page, HasSubstr("src=\"data:image/png;base64,"));
}

TEST_F(ReportPageTest, tables_name_their_rows_and_set_numbers_to_the_right) {
  const PageTable table{.caption = "Figures",
                        .columns = {{"measure", PageColumn::Kind::text}, {"value"}},
                        .rows = {{{"fill", "14.4 %"}, "What is full."}, {{"short"}, ""}}};
  const std::string page = report_html({.sections = {{.tables = {table}}}});
  EXPECT_THAT(page, HasSubstr("<th scope=\"col\">measure</th><th scope=\"col\" class=\"number\">"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">fill<span class=\"note\">What is full.</span>"));
  EXPECT_THAT(page, HasSubstr("<td class=\"number\">14.4 %</td>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">short</th><td class=\"number\"></td>"));
}

TEST_F(ReportPageTest, the_verdict_is_a_word_and_not_only_a_colour) {
  const auto verdict = [](PageVerdict::Outcome outcome) {
    return report_html({.verdict = PageVerdict{outcome, "As promised."}});
  };
  EXPECT_THAT(verdict(PageVerdict::Outcome::passed), HasSubstr("<strong>Passed.</strong> As"));
  EXPECT_THAT(verdict(PageVerdict::Outcome::failed), HasSubstr("<strong>Failed.</strong> As"));
}

TEST_F(ReportPageTest, commands_can_be_copied_as_they_are) {
  const std::string page = report_html({.sections = {{.commands = {"collage make 'a  b'"}}}});
  std::string text;
  bool is_tag = false;
  for (const char c : page.substr(page.find("<pre>"), page.find("</pre>") - page.find("<pre>"))) {
    is_tag = is_tag || c == '<';
    text += is_tag ? "" : std::string(1, c);
    is_tag = is_tag && c != '>';
  }
  EXPECT_EQ(text, "collage make &#39;a  b&#39;");
}

TEST_F(ReportPageTest, what_is_left_out_leaves_nothing_behind) {
  const std::string page = report_html({.title = "Bare"});
  const std::string body = page.substr(page.find("<body>"));
  EXPECT_EQ(body,
            "<body>\n<header>\n<h1>Bare</h1>\n</header>\n<main>\n</main>\n</body>\n</html>\n");
}

TEST_F(ReportPageTest, equal_pages_give_equal_bytes) {
  EXPECT_EQ(report_html(page_of("x")), report_html(page_of("x")));
}

TEST_F(ReportPageTest, says_which_picture_is_missing) {
  EXPECT_THAT(error_of([] {
                report_html({.pictures = {{"none.png", "", ""}}});
              }),
              HasSubstr("none.png"));
}

}  // namespace
}  // namespace collage
