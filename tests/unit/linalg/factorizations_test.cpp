#include "creepcontact/linalg/factorizations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <vector>

#include "creepcontact/base/thread_count.hpp"

namespace creepcontact::linalg {
namespace {

TEST(Factorizations, OfEqualBodiesAreMadeSideBySide) {
  EXPECT_TRUE(side_by_side(std::array{1e6, 1e6}, 2));
  EXPECT_TRUE(side_by_side(std::array{1e6, 1e6, 1e6, 1e6}, 2));
}

TEST(Factorizations, OfOneLargeBodyAreMadeByAllThreads) {
  EXPECT_FALSE(side_by_side(std::array{1e6}, 2));
  EXPECT_FALSE(side_by_side(std::array{1e6, 1e5}, 2));
  EXPECT_FALSE(side_by_side(std::array{1e6, 1e6}, 8));
  EXPECT_FALSE(side_by_side(std::array{1e6, 1e6}, 1));
}

TEST(Factorizations, ThrowTheFirstErrorAfterThoseUnderWay) {
  for (const int threads : {1, 2}) {
    const ThreadCount set(threads);
    std::atomic<int> ended{0};
    const std::vector<double> entries(4, 1e6);
    const auto work = [&](std::size_t i) {
      ++ended;
      if (i == 1) throw std::runtime_error("first");
      if (i == 3) throw std::runtime_error("second");
    };
    try {
      for_each_factorization(entries, work);
      ADD_FAILURE() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "first");
    }
    EXPECT_EQ(ended, threads == 1 ? 2 : 4);
  }
}

}  // namespace
}  // namespace creepcontact::linalg
