/// What a record keeps of the log.

#include "creepcontact/base/log.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace creepcontact::log {
namespace {

TEST(WarningRecord, KeepsEachWarningOnceWhetherShownOrNot) {
  set_level(Level::off);
  warning("before");
  const WarningRecord outer;
  {
    const WarningRecord inner;
    warning("twice {}", 2);
    warning("twice {}", 2);
    info("no warning");
    error("no warning either");
    std::thread([] { warning("of a thread"); }).join();
    EXPECT_EQ(inner.texts(), (std::vector<std::string>{"twice 2 (2 times)", "of a thread"}));
  }
  warning("after");
  EXPECT_EQ(outer.texts(), (std::vector<std::string>{"twice 2 (2 times)", "of a thread", "after"}));
  set_level(Level::info);
}

}  // namespace
}  // namespace creepcontact::log
