/// States long enough for the threaded vector operations give what the short ones give.

#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

using LongState = EveryIntegrator;

TEST_P(LongState, GivesTheSameAsAShortOne) {
  constexpr std::size_t copies = 30001;  // an odd length, above the threshold of the threads
  LinearSystem one({-2.0});
  LinearSystem many(Values(copies, -2.0));
  auto short_run = make(one, 1e-3);
  auto long_run = make(many, 1e-3);
  const Values times = {0.3, 1};
  const auto expected = integrate(*short_run, 0, {1}, times);
  const auto found = integrate(*long_run, 0, Values(copies, 1.0), times);
  // Sums differ by rounding, which the choice of the steps may amplify to a fraction of the tolerance.
  for (std::size_t k = 0; k < times.size(); ++k)
    for (std::size_t i : {std::size_t{0}, copies / 2, copies - 1})
      EXPECT_NEAR(found[k][i], expected[k][0], 1e-6) << "t = " << times[k] << ", entry " << i;
  EXPECT_EQ(long_run->counters().steps, short_run->counters().steps);
}

INSTANTIATE_TEST_SUITE_P(All, LongState, testing::ValuesIn(all_names()), test_name);

}  // namespace
}  // namespace creepcontact::ode
