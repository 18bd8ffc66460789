/// Texts of strangers become text on a page, with a few marks, and never more.

#include "../../../src/report/markdown.hpp"

#include <gtest/gtest.h>

namespace creepcontact::report {
namespace {

bool has(const std::string& html, const std::string& part) {
  return html.find(part) != std::string::npos;
}

TEST(Markdown, ParagraphsListsAndTables) {
  const std::string html = markdown("Is it **tight** for *long*?\n\n- a\n- b\n\n| x | y |\n|---|--:|\n| 1 | 2 |\n", 3);
  for (const char* part : {"<p>Is it <strong>tight</strong> for <em>long</em>?</p>", "<ul>", "<li>a</li>", "<th>x</th>",
                           "<td class=\"number\">2</td>"})
    EXPECT_TRUE(has(html, part)) << html;
  EXPECT_TRUE(has(markdown("# Title", 3), "<h3>Title</h3>"));
  EXPECT_TRUE(has(markdown("###### Deep", 4), "<h6>Deep</h6>"));
}

TEST(Markdown, HtmlIsText) {
  for (const char* text :
       {"<script>alert(1)</script>", "a <img src=x onerror=alert(1)> b", "<div onclick=\"x\">\n\nc\n\n</div>", "`<b>`",
        "    <b>", "```\n<b>\n```", "<!-- x -->", "| <b> |\n|---|\n| <i> |"}) {
    const std::string html = markdown(text, 3);
    EXPECT_TRUE(has(html, "&lt;")) << html;
    for (const char* tag : {"<script", "<img", "<div o", "<b>", "<i>", "<!--"}) EXPECT_FALSE(has(html, tag)) << html;
  }
}

TEST(Markdown, LinksLeadToTheWebAlone) {
  EXPECT_TRUE(has(markdown("[a](https://example.org/?x=1&y=\"2\")", 3), "<a href=\"https://example.org/?x=1&amp;y="));
  EXPECT_TRUE(has(markdown("[a](mailto:a@b.c)", 3), "<a href=\"mailto:a@b.c\""));
  for (const char* text :
       {"[a](javascript:alert(1))", "[a](JaVaScRiPt:alert(1))", "[a](data:text/html,x)", "[a](file:///etc/passwd)",
        "[a](//example.org)", "<javascript:alert(1)>", "[a](&#106;avascript:alert(1))"})
    EXPECT_FALSE(has(markdown(text, 3), "<a")) << markdown(text, 3);
  EXPECT_FALSE(has(markdown("![a](https://example.org/a.png)", 3), "<img"));
}

TEST(Markdown, AnyBytes) {
  EXPECT_EQ(markdown("", 3), "");
  EXPECT_TRUE(has(markdown("a\xFF", 3), "\uFFFD"));
  EXPECT_FALSE(has(markdown("[a](https://x\xFF\"onclick=\"y)", 3), "\"onclick"));
}

}  // namespace
}  // namespace creepcontact::report
