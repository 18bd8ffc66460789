#include <gtest/gtest.h>

#include "creepcontact/config/suggestion.hpp"

namespace creepcontact::config {
namespace {

TEST(Suggestion, EditDistanceInHalves) {
  EXPECT_EQ(edit_distance("norton", "norton"), 0);
  EXPECT_EQ(edit_distance("nortan", "norton"), 2);
  EXPECT_EQ(edit_distance("Norton", "norton"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 6);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 6);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 6);
}

TEST(Suggestion, Nearest) {
  EXPECT_EQ(nearest("exponent", {"law", "A", "n"}), "n");
  EXPECT_EQ(nearest("N", {"A", "n"}), "n");
  EXPECT_EQ(nearest("--out", {"--set", "--output"}), "--output");
  EXPECT_EQ(nearest("x", {}), "");
}

}  // namespace
}  // namespace creepcontact::config
