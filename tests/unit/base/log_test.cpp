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

TEST(Redirection, OfOneThreadAlone) {
  std::vector<std::string> mine, theirs;
  const auto sink = [](std::vector<std::string>& into) {
    return std::make_shared<const Sink>([&into](Level, std::string_view text) { into.emplace_back(text); });
  };
  const WarningRecord outside;
  {
    const Redirection redirection(sink(mine));
    const WarningRecord own;
    std::thread([&] {
      const Redirection other(sink(theirs));
      const WarningRecord record;
      warning("theirs");
      EXPECT_EQ(record.texts(), std::vector<std::string>{"theirs"});
    }).join();
    // A helper thread that has been given the sink.
    std::thread([given = log::sink()] {
      const Redirection same(given);
      warning("of a helper");
    }).join();
    info("mine");
    EXPECT_EQ(own.texts(), std::vector<std::string>{"of a helper"});
  }
  set_level(Level::off);
  warning("after");
  set_level(Level::info);
  EXPECT_EQ(mine, (std::vector<std::string>{"of a helper", "mine"}));
  EXPECT_EQ(theirs, std::vector<std::string>{"theirs"});
  EXPECT_EQ(outside.texts(), std::vector<std::string>{"after"});
}

}  // namespace
}  // namespace creepcontact::log
