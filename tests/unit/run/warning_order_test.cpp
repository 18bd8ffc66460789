/// What makes results mean something else comes before what makes them inaccurate, slow or undrawn.
#include "../../../src/run/warning_order.hpp"

#include <gtest/gtest.h>

namespace creepcontact::run {
namespace {

TEST(Warnings, AreOrderedByConsequence) {
  const std::vector<std::string> given{
      "no pictures: gnuplot is missing",
      "the contact solver took 80 iterations per solve",
      "contact 'fit': at the end the contact zone is about 1 element wide at its narrowest",
      "body 'bolt': the creep life is used up before t = 3",
      "friction: the path of the slip is less accurate than time.tolerance",
  };
  EXPECT_EQ(by_consequence(given), (std::vector<std::string>{given[3], given[2], given[4], given[1], given[0]}));
}

}  // namespace
}  // namespace creepcontact::run
