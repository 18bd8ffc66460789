/// States long enough for the threaded vector operations give what the short ones give.

#include <omp.h>

#include <cmath>

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

TEST_P(LongState, HasTheSameBitsForAnyNumberOfThreads) {
  const int usual = omp_get_max_threads();
  Values lambda(25001);
  for (std::size_t i = 0; i < lambda.size(); ++i) lambda[i] = -1 - std::abs(std::sin(static_cast<double>(i)));
  std::vector<Values> ends;
  for (int threads : {1, 3, 4, 4, 5}) {
    omp_set_num_threads(threads);
    LinearSystem system(lambda, true);
    auto run = make(system, 1e-3);
    ends.push_back(integrate(*run, 0, Values(lambda.size(), 0.5), {0.3}).back());
  }
  omp_set_num_threads(usual);
  for (const Values& end : ends) EXPECT_TRUE(end == ends.front());
}

INSTANTIATE_TEST_SUITE_P(All, LongState, testing::ValuesIn(all_names()), test_name);

}  // namespace
}  // namespace creepcontact::ode
