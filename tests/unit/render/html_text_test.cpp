#include "render/html_text.h"

#include <gtest/gtest.h>

namespace collage {
namespace {

TEST(HtmlText, leaves_nothing_that_has_a_meaning) {
  EXPECT_EQ(html_text("<b a='1' c=\"2\">&amp;"),
            "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;amp;");
  EXPECT_EQ(html_text("größe – 10 %\n"), "größe – 10 %\n");
}

TEST(HtmlText, replaces_control_characters) {
  EXPECT_EQ(html_text(std::string("a\0b\x1B\x7F\t", 6)), "a\uFFFDb\uFFFD\uFFFD\t");
}

TEST(UrlPath, writes_what_a_url_would_read_otherwise_as_numbers) {
  EXPECT_EQ(url_path("../ref/a 1%.png"), "../ref/a%201%25.png");
  EXPECT_EQ(url_path("javascript:alert(1)"), "javascript%3Aalert%281%29");
  EXPECT_EQ(url_path("a?b#c\"'&ö"), "a%3Fb%23c%22%27%26%C3%B6");
}

}  // namespace
}  // namespace collage
