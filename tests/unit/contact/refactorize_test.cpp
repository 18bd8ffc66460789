/// Bodies whose stiffness changes with their temperature: the interface and what was made of it follow.

#include <gtest/gtest.h>

#include "assembly.hpp"

namespace creepcontact::test {
namespace {

/// The lower box softens with the temperature t, the upper one stays; part of the surfaces touches.
struct HotBoxes {
  explicit HotBoxes(double dense_bytes) {
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
    bodies.push_back(std::make_unique<mechanics::Body>("lower", low, soft, held_low, temperature));
    bodies.push_back(std::make_unique<mechanics::Body>("upper", up, elastic_material(), held_up, temperature));
    contact::Pair pair;
    pair.name = "joint";
    pair.slave_body = 0;
    pair.master_body = 1;
    pair.coupling = contact::mortar_coupling(surface(0, "z1"), surface(1, "z0"), contact::ContactType::unilateral);
    pair.gap = Function::expression("0.04*x - 0.01", {"x"});
    pairs.push_back(std::move(pair));
    limit = dense_bytes;
  }
  contact::Surface surface(std::size_t body, const std::string& name) const {
    return {name, &bodies[body]->mesh(), &bodies[body]->constraints(), mesh::boundary_faces(bodies[body]->mesh(), name),
            1.0};
  }
  /// Factors at the time, or at 0 and anew at the time.
  contact::CondensedInterface interface(double t) {
    for (const auto& body : bodies) body->set_time(t);
    return contact::CondensedInterface(bodies, pairs, limit);
  }

  std::vector<std::unique_ptr<mechanics::Body>> bodies;
  std::vector<contact::Pair> pairs;
  double limit = 0;
};

class Refactorized : public testing::TestWithParam<bool> {};

TEST_P(Refactorized, InterfaceAndSolversAreThoseOfTheNewStiffness) {
  const double limit = GetParam() ? contact::CondensedInterface::unbounded : 1.0;
  HotBoxes fresh(limit), changed(limit);
  const contact::CondensedInterface expected = fresh.interface(1);
  contact::CondensedInterface interface = changed.interface(0);
  for (const bool schwarz : {true, false}) {
    if (!schwarz && !GetParam()) continue;  // the active-set method needs the matrices
    const auto make = [&](const contact::ContactProblem& problem) {
      return schwarz ? contact::schwarz_solver(problem, {.tolerance = 1e-12}) : contact::active_set_solver(problem);
    };
    const auto solver = make(interface.problem()), exact = make(expected.problem());
    const Equilibrium before = equilibrium(changed.bodies, interface, *solver, 0);
    const std::vector<std::size_t> lower{0};
    for (const auto& body : changed.bodies) body->set_time(1);
    interface.refactorize(lower);
    solver->flexibility_changed();
    const Equilibrium after = equilibrium(changed.bodies, interface, *solver, 1);
    const Equilibrium reference = equilibrium(fresh.bodies, expected, *exact, 1);
    const Eigen::VectorXd& found = after.result.state.multiplier;
    EXPECT_EQ(after.result.state.active, reference.result.state.active);
    EXPECT_FALSE(reference.result.state.active.empty());
    EXPECT_LT((found - reference.result.state.multiplier).norm(), 1e-10 * found.norm());
    EXPECT_GT((found - before.result.state.multiplier).norm(), 0.1 * found.norm()) << "the stiffness matters";
    if (GetParam()) {
      EXPECT_LT((interface.problem().total - expected.problem().total).norm(), 1e-12 * expected.problem().total.norm());
    }
    for (const auto& body : changed.bodies) body->set_time(0);
    interface.refactorize(lower);
  }
  EXPECT_EQ(interface.is_dense(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(DenseAndMatrixFree, Refactorized, testing::Bool());

}  // namespace
}  // namespace creepcontact::test
