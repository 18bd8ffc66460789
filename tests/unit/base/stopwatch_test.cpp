#include "creepcontact/base/stopwatch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace creepcontact {
namespace {

void spend() {
  for (const auto begin = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() == begin;) continue;
}

TEST(Stopwatch, EveryInstantBelongsToOnePart) {
  Stopwatch watch;
  spend();
  {
    const auto lap = watch.lap(Part::contact);
    spend();
    const PartSeconds before = watch.seconds();
    {
      const auto inner = watch.lap(Part::solve);
      spend();
    }
    const PartSeconds after = watch.seconds();
    EXPECT_GT(after[static_cast<std::size_t>(Part::solve)], 0);
    EXPECT_EQ(after[static_cast<std::size_t>(Part::prepare)], before[static_cast<std::size_t>(Part::prepare)]);
    EXPECT_GT(before[static_cast<std::size_t>(Part::contact)], 0);
  }
  const PartSeconds before = watch.seconds();
  spend();
  PartSeconds after = watch.seconds();
  EXPECT_GT(after[static_cast<std::size_t>(Part::prepare)], before[static_cast<std::size_t>(Part::prepare)]);
  after[static_cast<std::size_t>(Part::prepare)] = before[static_cast<std::size_t>(Part::prepare)];
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace creepcontact
