#include "creepcontact/base/suggestion.hpp"

#include <gtest/gtest.h>

namespace creepcontact {
namespace {

TEST(Suggestion, EditDistanceInHalves) {
  EXPECT_EQ(edit_distance("norton", "norton"), 0);
  EXPECT_EQ(edit_distance("nortan", "norton"), 2);
  EXPECT_EQ(edit_distance("Norton", "norton"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 6);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 6);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 6);
  EXPECT_EQ(edit_distance("tiem", "time"), 2);
}

TEST(Suggestion, Nearest) {
  EXPECT_EQ(nearest("N", {"A", "n"}), "n");
  EXPECT_EQ(nearest("--out", {"--set", "--output"}), "--output");
  EXPECT_EQ(nearest("mises", {"stress_xx", "von_mises"}), "von_mises");
  EXPECT_EQ(nearest("x", {}), "");
}

TEST(Suggestion, WithinAThirdOfTheLetters) {
  EXPECT_EQ(nearest("blok", {"block"}), "block");
  EXPECT_EQ(nearest("friction", {"name", "between", "type"}), "");
  EXPECT_EQ(nearest("preload", {"pressure"}), "");
  EXPECT_EQ(nearest("abcdef", {"abcdxy"}), "abcdxy");
  EXPECT_EQ(nearest("abcde", {"abcxy"}), "");
  EXPECT_EQ(nearest("ab", {"ac"}), "");
  EXPECT_EQ(did_you_mean("blok", {"block"}), "; did you mean 'block'?");
  EXPECT_EQ(did_you_mean("c", {"a", "b"}), "");
}

}  // namespace
}  // namespace creepcontact
