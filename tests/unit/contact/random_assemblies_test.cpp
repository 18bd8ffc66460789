/// Schwarz and active set on assemblies of finite elements: random ones, and bodies as dissimilar as they come.
#include "accelerations.hpp"
#include "creepcontact/contact/solver/friction_uniqueness.hpp"
#include "problems.hpp"
#include "random_assembly.hpp"
#include "support/contact/boxes.hpp"

namespace creepcontact::test {
namespace {

using contact::active_set_solver;
using contact::ContactResult;
using contact::schwarz_solver;

/// Largest difference of the traces that two solutions leave on any body, relative to what the largest multiplier could
/// move. Multipliers themselves need not be unique: where supports hold the slave and the master is coarser, several
/// act on the same unknowns.
double difference(const ContactProblem& problem, const ContactState& one, const ContactState& other) {
  const double largest = other.multiplier.cwiseAbs().maxCoeff();
  double result = 0;
  for (const contact::Flexibility& body : problem.bodies) {
    if (body.rows.empty() || largest == 0) continue;
    const Eigen::VectorXd trace = body.matrix * (one.multiplier - other.multiplier)(body.rows);
    result = std::max(result, trace.cwiseAbs().maxCoeff() / (body.matrix.diagonal().maxCoeff() * largest));
  }
  return result;
}

TEST(RandomAssemblies, SchwarzAgreesWithTheActiveSetMethod) {
  int n_floating = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    RandomAssembly assembly(seed);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << assembly.description);
    const ContactProblem& problem = assembly.condensed->interface.problem();
    const ContactLoad load = assembly.load();
    testing::internal::CaptureStderr();
    const ContactResult direct = active_set_solver(problem)->solve(load, {});
    const ContactResult schwarz = schwarz_solver(problem, {})->solve(load, {});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "no method falls back on another";

    expect_solved(problem, load, direct.state, 1e-8);
    expect_solved(problem, load, schwarz.state, 1e-8);
    if (direct.state.multiplier.maxCoeff() > 10 * multiplier_rounding(problem, load)) {
      EXPECT_LT(difference(problem, schwarz.state, direct.state), 1e-8);
    }
    if (problem.n_motions() > 0 && load.resultant.norm() > 0) {
      ++n_floating;
      const Eigen::VectorXd left = problem.rigid.transpose() * schwarz.state.multiplier + load.resultant;
      EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-9 * load.resultant.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_GT(n_floating, 50) << "pressed by loads and held by contact alone";
}

TEST(RandomAssemblies, FrictionFulfilsCoulombsLawByBothSolvers) {
  int n_slip = 0, n_stick = 0, n_compared = 0, n_unsolved = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const double mu = 0.05 + 0.01 * (seed % 40);
    RandomAssembly assembly(seed, mu);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", mu " << mu << ": " << assembly.description);
    const ContactProblem& problem = assembly.condensed->interface.problem();
    const ContactLoad load = assembly.load();
    ContactState newton;
    try {
      newton = contact::friction_solver(problem, {})->solve(load, {}).state;
    } catch (const SolverError&) {
      ++n_unsolved;
      continue;
    } catch (const contact::UnbalancedLoad&) {
      ++n_unsolved;
      continue;
    }
    expect_friction_solved(problem, load, newton, 1e-8);
    for (const contact::NodeLinearization& node : newton.nodes) {
      n_slip += node.status == contact::ContactStatus::slip ? 1 : 0;
      n_stick += node.status == contact::ContactStatus::stick ? 1 : 0;
    }
    if (contact::friction_kappa(problem, load.friction, newton).value_or(0) > 0.9) continue;
    testing::internal::CaptureStderr();
    ContactState tresca;
    try {
      tresca = contact::friction_solver(problem, {settings::FrictionMethod::tresca, {}})->solve(load, {}).state;
    } catch (const SolverError&) {
      testing::internal::GetCapturedStderr();
      continue;
    }
    const bool by_newton = !testing::internal::GetCapturedStderr().empty();
    expect_friction_solved(problem, load, tresca, 1e-7);
    if (newton.multiplier.maxCoeff() > 10 * multiplier_rounding(problem, load)) {
      n_compared += by_newton ? 0 : 1;
      EXPECT_LT(difference(problem, tresca, newton), 1e-7);
    }
  }
  EXPECT_GT(n_slip, 1000);
  EXPECT_GT(n_stick, 100);
  EXPECT_GT(n_compared, 75) << "solved by Tresca's law, without falling back on Newton's method";
  // All of the load in one step from nothing, to the verge of tilting: the program shortens steps that are not solved.
  EXPECT_LE(n_unsolved, 6);
}

struct Dissimilar {
  const char* name;
  BoxSetup lower, upper;
};

const BoxSetup layer{.divisions = {6, 6, 1}, .lengths = {1, 1, 0.02}};
const BoxSetup column{.divisions = {3, 3, 8}, .lengths = {1, 1, 10}};
const BoxSetup cube{.divisions = {4, 4, 3}};

class DissimilarBodies : public testing::TestWithParam<double> {};

TEST_P(DissimilarBodies, AgreeInEveryAcceleration) {
  for (Dissimilar bodies : {Dissimilar{"layer on column", column, layer}, Dissimilar{"column on layer", layer, column},
                            Dissimilar{"cube on layer", layer, cube}, Dissimilar{"cube on column", column, cube}})
    for (const bool lower_is_slave : {true, false}) {
      bodies.upper.young_modulus = GetParam() * bodies.lower.young_modulus;
      Boxes assembly(bodies.lower, bodies.upper, lower_is_slave, -0.01, contact::ContactType::unilateral,
                     Function::expression("0.01*(x - 0.3*y - 0.2)", {"x", "y", "z", "t"}));
      const auto direct = active_set_solver(assembly.interface().problem());
      assembly.solve(*direct);
      const ContactState reference = assembly.result.state;
      EXPECT_GT(reference.active.size(), 3u);
      for (const Acceleration acceleration : accelerations) {
        SCOPED_TRACE(testing::Message() << bodies.name << ", slave " << (lower_is_slave ? "below" : "above")
                                        << ", acceleration " << static_cast<int>(acceleration));
        testing::internal::CaptureStderr();
        const auto schwarz = schwarz_solver(assembly.interface().problem(), accelerated(acceleration));
        assembly.solve(*schwarz);
        const std::string warnings = testing::internal::GetCapturedStderr();
        if (acceleration == Acceleration::cg) {
          EXPECT_EQ(warnings, "");
        }
        EXPECT_LT(difference(assembly.interface().problem(), assembly.result.state, reference), 1e-8);
      }
    }
}

INSTANTIATE_TEST_SUITE_P(StiffnessRatios, DissimilarBodies, testing::Values(1e-3, 1.0, 1e3));

}  // namespace
}  // namespace creepcontact::test
