/// The number of threads follows what other programs leave free.

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "creepcontact/platform/useful_threads.hpp"

namespace creepcontact::platform {
namespace {

using namespace std::chrono_literals;

struct WatchedMachine : testing::Test {
  int measured(int most) {
    ++measurements;
    return std::min(most, free);
  }
  int free = 4, measurements = 0;
  ThreadWatch::Clock::time_point start = ThreadWatch::Clock::now();
};

TEST_F(WatchedMachine, IsMeasuredAgainWhenTheIntervalIsOver) {
  ThreadWatch watch(4, 10s, [this](int most) { return measured(most); });
  EXPECT_EQ(watch.threads(), 4);
  free = 1;
  EXPECT_FALSE(watch.update(start + 5s));
  EXPECT_EQ(measurements, 1);
  EXPECT_EQ(watch.update(start + 11s), 1);
  EXPECT_EQ(watch.threads(), 1);
  EXPECT_FALSE(watch.update(start + 12s));
  EXPECT_FALSE(watch.update(start + 22s)) << "nothing has changed";
  free = 4;
  EXPECT_EQ(watch.update(start + 33s), 4) << "all are used again";
  EXPECT_EQ(measurements, 4);
}

TEST_F(WatchedMachine, IsNotMeasuredForOneThread) {
  ThreadWatch watch(1, 10s, [this](int most) { return measured(most); });
  measurements = 0;
  EXPECT_FALSE(watch.update(start + 100s));
  EXPECT_EQ(measurements, 0);
}

TEST(UsefulThreads, AreAtMostThoseAllowed) {
  EXPECT_EQ(useful_threads(1), 1);
  const int threads = useful_threads(2);
  EXPECT_TRUE(threads == 1 || threads == 2);
}

}  // namespace
}  // namespace creepcontact::platform
