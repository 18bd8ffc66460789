/// A body whose elements are dealt out among several processes creeps as it does in one.

#include <gtest/gtest.h>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "unit/base/thread_team.hpp"
#include "unit/creep/row_of_cubes.hpp"

namespace creepcontact::creep {
namespace {

constexpr double end = 1000;

struct Course {
  std::vector<double> steps, state, survey, scale;
  double stable_step = 0;
  std::int64_t factorizations = 0;
  CreepSystem::Extreme damage;
};

Course run(const Team& team, int first, int count) {
  Stopwatch watch;
  const Assembly bar = creepcontact::test::row_of_cubes(team, first, count);
  SolverOptions options;
  options.refactor_change = 0.1;
  EquilibriumSolver solver(bar, options, watch);
  const ElasticSurvey survey = survey_elastic_stress(solver, {0, end}, {});
  CreepSystem system(solver, survey, 1e-4, watch);
  const auto integrator = ode::make_integrator("auto", system, {.tolerance = 1e-4, .end_time = end});
  integrator->initialize(0, std::vector<double>(system.size()));
  Course course;
  while (integrator->time() < end) course.steps.push_back(integrator->step(end).step);
  course.state.assign(integrator->state().begin(), integrator->state().end());
  course.survey = survey.stress;
  course.scale.assign(system.scale().begin(), system.scale().begin() + 1);
  course.stable_step = system.stable_step(end, integrator->state());
  course.factorizations = system.run_counters().factorizations;
  course.damage =
      system.largest(material::damage, 0, system.evaluate_step(end, integrator->state()), course.state).value();
  return course;
}

void expect_near(double value, double expected, double relative) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected));
}

TEST(TeamOfCreepSystems, CreepsAsOneProcessDoes) {
  const Course alone = run(serial_team(), 0, 3);
  EXPECT_GT(alone.factorizations, 1) << "the stiffness is to change by more than refactor_change";
  EXPECT_GT(alone.damage.value, 0.01);
  std::vector<Course> parts(2);
  on_team(2, [&](const Team& team) {
    parts[team.rank()] = team.rank() == 0 ? run(team, 2, 1) : run(team, 0, 2);  // the largest stress is not on rank 0
  });
  for (const Course& part : parts) {
    EXPECT_EQ(part.steps, parts[0].steps) << "to the last bit";
    EXPECT_EQ(part.scale, parts[0].scale);
    ASSERT_EQ(part.steps.size(), alone.steps.size());
    for (std::size_t i = 0; i < part.steps.size(); ++i) expect_near(part.steps[i], alone.steps[i], 1e-6);
    expect_near(part.survey[0], alone.survey[0], 1e-12);
    expect_near(part.scale[0], alone.scale[0], 1e-6);
    expect_near(part.stable_step, alone.stable_step, 1e-6);
    EXPECT_EQ(part.factorizations, alone.factorizations);
    expect_near(part.damage.value, alone.damage.value, 1e-6);
    EXPECT_NEAR((part.damage.position - alone.damage.position).norm(), 0, 1e-12);
  }
  std::vector<double> state = parts[1].state;
  state.insert(state.end(), parts[0].state.begin(), parts[0].state.end());
  ASSERT_EQ(state.size(), alone.state.size());
  for (std::size_t i = 0; i < state.size(); ++i)
    EXPECT_NEAR(state[i], alone.state[i], 1e-8 * alone.scale[0] + 1e-7 * std::abs(alone.state[i])) << i;
}

/// Where the rate of one process cannot be evaluated, all retry with a shorter step; a fatal error ends all.
TEST(TeamOfCreepSystems, FailsTogether) {
  std::vector<int> recovered(2);
  on_team(2, [&](const Team& team) {
    Stopwatch watch;
    const Assembly bar = creepcontact::test::row_of_cubes(team, team.rank(), 1);
    EquilibriumSolver solver(bar, {}, watch);
    CreepSystem system(solver, survey_elastic_stress(solver, {0, end}, {}), 1e-4, watch);
    std::vector<double> y(system.size(), team.rank() == 1 ? 1e306 : 0.0), rate(system.size());
    try {
      system.rate(0, y, rate);
    } catch (const RecoverableError&) {
      ++recovered[team.rank()];
    }
    std::ranges::fill(y, 0.0);
    system.rate(0, y, rate);
  });
  EXPECT_EQ(recovered, (std::vector<int>{1, 1}));
}

}  // namespace
}  // namespace creepcontact::creep
