/// Names of files within lines.
#include "creepcontact/base/one_line.hpp"

#include <gtest/gtest.h>

namespace creepcontact {
namespace {

TEST(OneLine, EndsNoLine) {
  EXPECT_EQ(one_line("tests of 2020 (°C).csv"), "tests of 2020 (°C).csv");
  EXPECT_EQ(one_line("a\nlaw = \"b\"\r\t\x1b[31m\x7f"), "a law = \"b\"   [31m ");
  EXPECT_EQ(one_line("a\u0085b\u2028c"), "a b c");
  EXPECT_EQ(one_line("Pr\xFC\x66ung"), "Pr?fung");                                     // Latin-1
  EXPECT_EQ(one_line("\xC0\xAF\xED\xA0\x80\xF4\x90\x80\x80\xE2\x82"), "???????????");  // no characters
}

}  // namespace
}  // namespace creepcontact
