#include "creepcontact/base/utf8.hpp"

#include <gtest/gtest.h>

namespace creepcontact {
namespace {

TEST(Utf8, LengthsOfCharacters) {
  for (const auto& [text, length] : {std::pair("a", 1U), {"\u00e4x", 2U}, {"\u20ac", 3U}, {"\U0001f600", 4U}})
    EXPECT_EQ(utf8_length(text), length) << text;
  EXPECT_EQ(utf8_length(std::string_view("\0", 1)), 1U);
}

TEST(Utf8, BytesThatBeginNone) {
  for (const char* text : {"", "\x80", "\xc3", "\xc3(", "\xe2\x82", "\xff", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                           "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80"})
    EXPECT_EQ(utf8_length(text), 0U) << text;
}

}  // namespace
}  // namespace creepcontact
