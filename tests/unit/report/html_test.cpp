/// Pieces of pages: nothing that a user writes can become a part of the page itself.

#include "../../../src/report/html.hpp"

#include <gtest/gtest.h>

namespace creepcontact::report {
namespace {

TEST(Escaped, LeavesNoMarkup) {
  EXPECT_EQ(escaped("<script>\"a\" & 'b'</script>"), "&lt;script&gt;&quot;a&quot; &amp; &#39;b&#39;&lt;/script&gt;");
  EXPECT_EQ(escaped("500 °C, mm³"), "500 °C, mm³");
  EXPECT_EQ(escaped("a\xE9z\xFF"), "a\xEF\xBF\xBDz\xEF\xBF\xBD");  // Latin-1 is no UTF-8
  EXPECT_EQ(escaped("\xC3"), "\xEF\xBF\xBD");                      // a sequence cut short
}

TEST(Html, TablesAlignNumbersAndEscapeCells) {
  Html page;
  page.table({"body", "force", "share"}, {{"a<b", "1.5e3", "98 %"}, {"c", "-", "2 %"}}, "Forces & more");
  const std::string& text = page.text();
  EXPECT_NE(text.find("<th scope=\"row\">a&lt;b</th>"), std::string::npos);
  EXPECT_NE(text.find("<td class=\"number\">1.5e3</td>"), std::string::npos);
  EXPECT_NE(text.find("<td class=\"number\">98 %</td>"), std::string::npos);
  EXPECT_NE(text.find("<caption>Forces &amp; more</caption>"), std::string::npos);
}

}  // namespace
}  // namespace creepcontact::report
