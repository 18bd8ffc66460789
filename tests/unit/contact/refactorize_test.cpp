/// Bodies whose stiffness changes with their temperature: the interface and what was made of it follow.

#include <gtest/gtest.h>

#include "support/contact/boxes.hpp"

namespace creepcontact::test {
namespace {

contact::Surface surface(const mechanics::Body& body, const std::string& name) {
  return {name, &body.mesh(), &body.constraints(), mesh::boundary_faces(body.mesh(), name), 1.0};
}

/// The lower box softens with the temperature t, the upper one stays; part of the surfaces touches.
Condensed hot_boxes(double dense_bytes, double factored_at) {
  const mesh::Mesh low = box_mesh(mesh::CellType::hex8, {3, 2, 2}, {1, 1, 1}, {0, 0, -1});
  const mesh::Mesh up = box_mesh(mesh::CellType::hex8, {2, 2, 2});
  material::Material soft = elastic_material();
  soft.young_modulus = Function::expression("200 - 100*T", {"T"});
  std::vector<mechanics::Support> held_low = symmetry_supports(low), held_up = symmetry_supports(up);
  held_low.pop_back();
  held_up.pop_back();
  held_low.push_back(support(low, "z0", Vector3::UnitZ()));
  held_up.push_back(support(up, "z1", Vector3::UnitZ(), -0.02));
  const Function temperature = Function::expression("t*(1 + x)/2", {"x", "t"});
  Bodies bodies;
  bodies.emplace_back("lower", low, soft, held_low, temperature);
  bodies.emplace_back("upper", up, elastic_material(), held_up, temperature);
  contact::Pair pair;
  pair.name = "joint";
  pair.slave_body = 0;
  pair.master_body = 1;
  pair.coupling =
      contact::mortar_coupling(surface(bodies[0], "z1"), surface(bodies[1], "z0"), contact::ContactType::unilateral);
  pair.gap = Function::expression("0.04*x - 0.01", {"x"});
  return {std::move(bodies), {std::move(pair)}, dense_bytes, factored_at};
}

class Refactorized : public testing::TestWithParam<bool> {};

TEST_P(Refactorized, InterfaceAndSolversAreThoseOfTheNewStiffness) {
  const double limit = GetParam() ? contact::CondensedInterface::unbounded : 1.0;
  Condensed fresh = hot_boxes(limit, 1), changed = hot_boxes(limit, 0);
  const contact::ContactProblem &expected = fresh.interface.problem(),
                                &problem_of_changed = changed.interface.problem();
  for (const bool schwarz : {true, false}) {
    if (!schwarz && !GetParam()) continue;  // the active-set method needs the matrices
    const auto make = [&](const contact::ContactProblem& problem) {
      return schwarz ? contact::schwarz_solver(problem, {.tolerance = 1e-12}) : contact::active_set_solver(problem);
    };
    const auto solver = make(problem_of_changed), exact = make(expected);
    const ContactEquilibrium before = changed.solve(*solver, 0);
    const std::vector<std::size_t> lower{0};
    changed.interface.flexibility().refactorize(lower, conditions(changed.bodies, 1));
    solver->flexibility_changed();
    const ContactEquilibrium after = changed.solve(*solver, 1);
    const ContactEquilibrium reference = fresh.solve(*exact, 1);
    const Eigen::VectorXd& found = after.result.state.multiplier;
    EXPECT_EQ(after.result.state.active, reference.result.state.active);
    EXPECT_FALSE(reference.result.state.active.empty());
    EXPECT_LT((found - reference.result.state.multiplier).norm(), 1e-10 * found.norm());
    EXPECT_GT((found - before.result.state.multiplier).norm(), 0.1 * found.norm()) << "the stiffness matters";
    if (GetParam()) {
      EXPECT_LT((problem_of_changed.total - expected.total).norm(), 1e-12 * expected.total.norm());
    }
    changed.interface.flexibility().refactorize(lower, conditions(changed.bodies, 0));
  }
  EXPECT_EQ(changed.interface.is_dense(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(DenseAndMatrixFree, Refactorized, testing::Bool());

}  // namespace
}  // namespace creepcontact::test
