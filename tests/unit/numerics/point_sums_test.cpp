#include "creepcontact/numerics/point_sums.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <vector>

namespace creepcontact::numerics {
namespace {

TEST(PointSums, SumOfAllTerms) {
  for (const std::size_t n : {0, 1, 999, 1000, 1001, 5000})
    EXPECT_EQ(sum_over_points(n, [](std::size_t p) { return static_cast<double>(p); }),
              0.5 * static_cast<double>(n) * (static_cast<double>(n) - 1));
}

TEST(PointSums, TheSameBitsForAnyNumberOfThreads) {
  const auto sum = [](int threads) {
    omp_set_num_threads(threads);
    return sum_over_points(12345, [](std::size_t p) { return std::sin(static_cast<double>(p)); });
  };
  const double alone = sum(1);
  for (const int threads : {2, 3, 4}) EXPECT_EQ(sum(threads), alone) << threads;
  omp_set_num_threads(1);
}

TEST(Parallel, EveryIndexOnce) {
  omp_set_num_threads(3);
  for (const std::size_t n : {0, 9, 10, 11, 100}) {
    std::vector<int> seen(n);
    for_each_index(n, 10, [&](std::size_t i) { ++seen[i]; });
    EXPECT_EQ(seen, std::vector<int>(n, 1));
  }
  omp_set_num_threads(1);
}

}  // namespace
}  // namespace creepcontact::numerics
