/// What the search before the run has not found, and a step would pass over.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "verification/cube.hpp"

namespace creepcontact {
namespace guarded_steps_tests {
namespace {

using namespace test;

constexpr double end = 1e4, window = 0.5, spacing = 5;

/// Output times at which steps end, so that a window of half an hour is not short compared with them.
std::string short_steps(const std::string& integrator) {
  std::vector<double> times;
  for (double t = spacing; t <= end; t += spacing) times.push_back(t);
  return fmt::format("end = {}\noutput = {}\nstop_at_output = true\nintegrator = \"{}\"\n", end, times, integrator);
}

/// Between two samples of the search, which are 0.61 h apart.
Outcome run_with_window(double begin, const std::string& integrator) {
  const std::string rate = fmt::format("1e-14*q^4*(t > {:.6f} && t < {:.6f} ? 10001 : 1)", begin, begin + window);
  return run_cube(creep_law_table("expression", fmt::format("rate = \"{}\"", rate)), pulled("100"),
                  short_steps(integrator));
}

TEST(GuardedSteps, WindowsThatTheSearchMissesAreIntegrated) {
  int n_missed = 0;
  for (const char* integrator : {"log_adams", "cvode_bdf"})
    for (const double begin : {3001.527, 5002.626, 7003.114}) {
      const Outcome outcome = run_with_window(begin, integrator);
      EXPECT_RELATIVE(outcome.history.at("cxx", end), 1e-6 * (end + 1e4 * window), 1e-3) << integrator << begin;
      bool missed = false;
      for (int i = 0; outcome.summary.has(fmt::format("warnings/{}", i)); ++i)
        missed = missed || outcome.summary.text(fmt::format("warnings/{}", i)).find("jumps") != std::string::npos;
      n_missed += missed ? 1 : 0;
    }
  EXPECT_GT(n_missed, 0) << "the search has found all: the windows must be shorter to test the guard";
}

}  // namespace
}  // namespace guarded_steps_tests
}  // namespace creepcontact
