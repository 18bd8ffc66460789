/// Long histories are drawn with few points, and with all their peaks.

#include "../../../src/report/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace creepcontact::report {
namespace {

TEST(Thinned, KeepsEndsAndPeaks) {
  plot::Series series{"p", {}, {}};
  for (int i = 0; i < 60000; ++i) {
    series.x.push_back(i);
    series.y.push_back(std::sin(0.01 * i));
  }
  series.y[31234] = 7;
  series.y[47777] = -5;
  for (const bool logarithmic : {false, true}) {
    const plot::Series few = thinned(series, logarithmic);
    EXPECT_LE(few.x.size(), 2001U);
    EXPECT_EQ(few.x.size(), few.y.size());
    EXPECT_EQ(few.x.front(), 0);
    EXPECT_EQ(few.x.back(), 59999);
    EXPECT_EQ(*std::ranges::max_element(few.y), 7);
    EXPECT_EQ(*std::ranges::min_element(few.y), -5);
    EXPECT_TRUE(std::ranges::is_sorted(few.x));
  }
}

TEST(Thinned, ShortOnesStay) {
  const plot::Series series{"p", {0, 1, 2}, {3, NAN, 5}};
  EXPECT_EQ(thinned(series, true).x, series.x);
}

TEST(BeginsFast, StartUpsThatALinearAxisHides) {
  EXPECT_TRUE(begins_fast({0, 1, 1e5}, {0, 100, 100}));
  EXPECT_FALSE(begins_fast({0, 5e4, 1e5}, {0, 100, 100}));
  EXPECT_FALSE(begins_fast({0, 1}, {5, 5}));
  std::vector<double> x, y;  // cycles
  for (int i = 0; i < 1000; ++i) {
    x.push_back(i);
    y.push_back(i % 2);
  }
  EXPECT_FALSE(begins_fast(x, y));
}

}  // namespace
}  // namespace creepcontact::report
