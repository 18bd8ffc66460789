#include "creepcontact/platform/background.hpp"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>

namespace creepcontact::platform {
namespace {

TEST(Background, WorksBesideItsOwner) {
  std::promise<void> go;
  std::thread::id other;
  Background work;
  work.start([&] {
    go.get_future().wait();
    other = std::this_thread::get_id();
  });
  EXPECT_TRUE(work.busy());
  go.set_value();
  work.wait();
  EXPECT_FALSE(work.busy());
  EXPECT_NE(other, std::this_thread::get_id());
}

TEST(Background, OnePieceAtATimeInOrder) {
  std::string done;
  {
    Background work;
    for (const char piece : {'a', 'b', 'c'}) work.start([&done, piece] { done += piece; });
  }
  EXPECT_EQ(done, "abc") << "all of it, before the end of its owner";
}

TEST(Background, FailuresReachTheOwnerOnce) {
  Background work;
  work.wait();  // for nothing
  bool second = false;
  work.start([] { throw std::runtime_error("first"); });
  EXPECT_THROW(work.start([&] { second = true; }), std::runtime_error);
  work.wait();
  EXPECT_FALSE(second);
  work.start([] { throw std::runtime_error("third"); });
  EXPECT_THROW(work.wait(), std::runtime_error);
  EXPECT_NO_THROW(work.wait());
}

}  // namespace
}  // namespace creepcontact::platform
