/// A request to end is heeded by the iterations of every contact solver, and costs nothing but the present solve.
#include "accelerations.hpp"
#include "creepcontact/contact/solver/active_set_system.hpp"
#include "problems.hpp"

namespace creepcontact::test {
namespace {

using contact::FrictionOptions;

/// Asks for the end from the n-th question on.
struct Countdown {
  int left = 0;
  StopRequest request() {
    return StopRequest([this] { return --left < 0; });
  }
};

/// A solve is cancelled at its first, second, ... question; the solver then solves the problem as if nothing had been.
void expect_heeded(contact::ContactSolver& solver, const ContactLoad& load) {
  const Eigen::VectorXd undisturbed = solver.solve(load, {}).state.multiplier;
  for (int questions = 0; questions < 1000; ++questions) {
    Countdown countdown{questions};
    solver.set_stop(countdown.request());
    bool cancelled = false;
    try {
      solver.solve(load, {});
    } catch (const Cancelled&) {
      cancelled = true;
    }
    solver.set_stop({});
    EXPECT_EQ(solver.solve(load, {}).state.multiplier, undisturbed);
    EXPECT_EQ(cancelled, countdown.left < 0);
    if (cancelled) continue;
    EXPECT_GE(questions, 2) << "questions in a solve";
    return;
  }
  FAIL() << "the solver does not end";
}

TEST(StopRequest, EndsTheIterationsOfAllMethods) {
  std::mt19937 generator(5);
  const ContactProblem problem = chain(2, 8, 3.0, generator);
  const ContactLoad load{Eigen::VectorXd::LinSpaced(16, -1.0, 0.7), {}};
  expect_heeded(*contact::active_set_solver(problem), load);
  for (const Acceleration acceleration : accelerations)
    expect_heeded(*contact::schwarz_solver(problem, accelerated(acceleration)), load);
}

TEST(StopRequest, EndsTheSearchForBodiesHeldByContactAlone) {
  std::mt19937 generator(5);
  const ContactProblem problem = chain(2, 8, 3.0, generator, 1);
  const ContactLoad load{Eigen::VectorXd::Constant(16, 1000.0), Eigen::Vector2d(-8.0, 1.0)};
  expect_heeded(*contact::active_set_solver(problem), load);
  expect_heeded(*contact::schwarz_solver(problem, {}), load);
}

TEST(StopRequest, EndsTheIterationsOfFriction) {
  std::mt19937 generator(5);
  for (const settings::FrictionMethod method : {settings::FrictionMethod::newton, settings::FrictionMethod::tresca}) {
    const ContactProblem problem = frictional(8, 2, 0.2, generator);
    ContactLoad load{Eigen::VectorXd::LinSpaced(24, -2.0, 0.5), {}, {}};
    load.friction.coefficient.setConstant(8, 0.2);
    expect_heeded(*contact::friction_solver(problem, FrictionOptions{method, {}}), load);
  }
}

}  // namespace
}  // namespace creepcontact::test
