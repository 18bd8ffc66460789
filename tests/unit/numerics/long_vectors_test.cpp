#include "creepcontact/numerics/long_vectors.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <limits>
#include <vector>

namespace creepcontact::numerics {
namespace {

TEST(LongVectors, AreCopiedAndCompared) {
  for (const int threads : {1, 3}) {
    omp_set_num_threads(threads);
    for (const std::size_t n : {0, 1, 4096, 4097, 100000}) {
      std::vector<double> from(n), into;
      for (std::size_t i = 0; i < n; ++i) from[i] = static_cast<double>(i);
      copy(from, into);
      EXPECT_EQ(from, into);
      EXPECT_TRUE(equal(from, into));
      if (n == 0) continue;
      into.back() += 1;
      EXPECT_FALSE(equal(from, into));
      into.pop_back();
      EXPECT_FALSE(equal(from, into));
    }
  }
  omp_set_num_threads(1);
}

TEST(LongVectors, AreFiniteIfAllEntriesAre) {
  std::vector<double> values(100000, -1.0);
  EXPECT_TRUE(is_finite(values));
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for (const std::size_t at : {0, 50000, 99999}) {
      values[at] = bad;
      EXPECT_FALSE(is_finite(values));
      values[at] = 1;
    }
}

}  // namespace
}  // namespace creepcontact::numerics
