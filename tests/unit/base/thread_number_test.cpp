#include "../../../src/base/thread_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <set>
#include <thread>
#include <vector>

#include "creepcontact/base/function.hpp"

namespace creepcontact {
namespace {

TEST(ThreadNumber, IsUniqueAmongLivingThreadsAndUsedAgain) {
  constexpr std::size_t n = 8;
  for (int round = 0; round < 3; ++round) {
    std::vector<std::size_t> numbers(n);
    std::barrier all(n);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < n; ++i)
      threads.emplace_back([&, i] {
        numbers[i] = thread_number();
        EXPECT_EQ(numbers[i], thread_number());
        all.arrive_and_wait();
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(std::set(numbers.begin(), numbers.end()).size(), n);
    EXPECT_LT(*std::max_element(numbers.begin(), numbers.end()), 4 * n) << "numbers are given again";
  }
}

TEST(Function, ExpressionsAreEvaluatedByAnyThreads) {
  const Function square = Function::expression("x*x + t", {"x", "t"});
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&, i] {
      for (int k = 0; k < 2000; ++k) {
        const double x = i + 1e-3 * k;
        ASSERT_EQ(square({.x = x, .t = double(i)}), x * x + i);
      }
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace creepcontact
