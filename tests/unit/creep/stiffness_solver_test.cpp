/// Other solvers of the stiffness in the place of CHOLMOD's: all that the rest of the program asks of one.

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "support/run/blocks.hpp"
#include "support/run/dense_solvers.hpp"

namespace creepcontact::run::test {
namespace {

struct SolverCase {
  const char* name;
  std::vector<std::string> overrides;
  bool dense = true;  ///< matrices of the contact zone; else products are iterated
};

/// Rates, Jacobian products and, if there are tangents, their solutions, one after the other.
std::vector<std::vector<double>> results(const SolverCase& tested, const linalg::StiffnessSolverFactory& make_solver) {
  const Case blocks;
  const config::Config config = blocks.config("", tested.overrides);
  Stopwatch watch;
  Model model = build_model(config);
  model.solver.stiffness_solver = make_solver;
  creep::EquilibriumSolver solver(model.assembly, model.solver, watch);
  creep::CreepSystem system(solver, creep::survey_elastic_stress(solver, config.time.output, model.breakpoints), 1e-4,
                            watch);
  std::vector<double> y(system.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = 0.2 * std::sin(static_cast<double>(i)) * system.scale()[i];
  std::vector<std::vector<double>> all(3, std::vector<double>(y.size()));
  system.rate(0.1, y, all[0]);
  system.jacobian_times(0.1, y, y, all[1]);
  if (tested.dense && solver.interface().error_bound() == 0) {
    system.prepare_tangent(0.1, y, 0.01);
    system.solve_tangent(y, all[2]);
  } else {
    all.pop_back();
  }
  return all;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  const auto vector = [](const std::vector<double>& v) { return Eigen::VectorXd::Map(v.data(), std::ssize(v)); };
  return (vector(a) - vector(b)).norm() / vector(b).norm();
}

class AnotherStiffnessSolver : public testing::TestWithParam<SolverCase> {};

TEST_P(AnotherStiffnessSolver, GivesTheSameRates) {
  const auto expected = results(GetParam(), linalg::default_stiffness_solver);
  const auto found = results(GetParam(), dense_cholesky);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LE(difference(found[i], expected[i]), GetParam().dense ? 1e-8 : 1e-5) << "of rate, product, solution: " << i;
}

/// A solver that is wrong by a known part is repeated until the stress is right.
TEST_P(AnotherStiffnessSolver, MayBeInexact) {
  const auto expected = results(GetParam(), linalg::default_stiffness_solver);
  for (const double error : {0.3, 0.01, 1e-7}) {
    const auto found = results(GetParam(), inexact_solvers(error));
    EXPECT_LE(difference(found[0], expected[0]), 1e-8) << error;
    EXPECT_LE(difference(found[1], expected[1]), 2e-3) << error;
  }
}

INSTANTIATE_TEST_SUITE_P(Contacts, AnotherStiffnessSolver,
                         testing::Values(SolverCase{"closed", {}}, SolverCase{"tied", {"contacts.0.type=tied"}},
                                         SolverCase{"matrix_free", {"contact_solver.dense_limit_mb=1e-6"}, false},
                                         SolverCase{"hot",
                                                    {"temperature.value=100*t*(1+0.3*x)",
                                                     "materials.soft.young_modulus='100-0.08*T'"}}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace creepcontact::run::test
