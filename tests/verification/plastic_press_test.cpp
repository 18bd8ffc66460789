/// A crowned block that is pressed on another one; both yield while contact spreads. Steps of the load against very
/// many of them.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "creepcontact/model/model.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace plastic_press_tests {
namespace {

using namespace test;

std::string pressed_blocks(const std::string& contact) {
  return section_of("plane_strain", 1) + body("low", 1000, 0.3) +
         "plasticity = { yield_stress = 1, hardening_modulus = 10 }\n" + body("up", 1000, 0.3) +
         "plasticity = { yield_stress = 1.2, kinematic = [{ C = 20, gamma = 0 }] }\n" + support("low_y0", "y") +
         support("low_x0", "x") + support("up_x0", "x") +
         support("up_y1", "y", "{ t = [0, 1, 2], values = [0, -0.008, -0.005] }") +
         contact_table("low_y1", "up_y0", "gap = \"0.003*x^2\"\nslave = \"low_y1\"\n" + contact) + "[time]\nend = 2\n" +
         probe("force", "reaction_y", "on = \"up_y1\"") +
         probe("area", "contact_area", "on = \"low_y1\"\nreduce = \"sum\"");
}

std::string blocks_geo() {
  return regions_geo({{"low", {0, 2, 16}, {-1, 0, 6, 0.8}}, {"up", {0, 2, 20}, {0, 1, 6, 1.25}}});
}

/// The state after equal steps to a time, each from the accepted one before.
class Pressed {
 public:
  explicit Pressed(const std::string& contact)
      : directory_(blocks_geo()), model_(model::build_model(directory_.config(pressed_blocks(contact), {}))) {
    model_.solver.plastic_tolerance = 1e-9;
  }
  creep::Equilibrium after(double time, int n_steps) {
    Stopwatch watch;
    creep::EquilibriumSolver solver(model_.assembly, model_.solver, watch);
    creep::History history = solver.initial_history();
    const std::vector<mechanics::CreepStrainView> no_creep(model_.bodies().size());
    creep::Equilibrium at;
    for (int i = 1; i <= n_steps; ++i) {
      solver.solve(time * i / n_steps, no_creep, history, at);
      solver.accept(at, no_creep, history, {.tolerance = std::numeric_limits<double>::infinity()});
    }
    return at;
  }
  /// Root of the mean square of the difference of the stresses; the yield stress is 1.
  double difference(const creep::Equilibrium& a, const creep::Equilibrium& b) const {
    double sum = 0, volume = 0;
    for (std::size_t body = 0; body < a.bodies.size(); ++body) {
      const std::span<const double> weights = model_.bodies()[body].discretization().weights();
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const Tensor6 change = tensor::view(a.bodies[body].stress, i) - tensor::view(b.bodies[body].stress, i);
        sum += weights[i] * change.squaredNorm();
        volume += weights[i];
      }
    }
    return std::sqrt(sum / volume);
  }

 private:
  CaseDirectory directory_;
  model::Model model_;
};

TEST(PlasticPress, StepsConvergeWhileContactSpreads) {
  Pressed blocks("");
  const creep::Equilibrium fine = blocks.after(1, 256);
  double before = 0;
  for (const auto& [n, bound] : {std::pair{8, 8e-3}, {16, 2.5e-3}, {32, 8e-4}}) {
    const double error = blocks.difference(blocks.after(1, n), fine);
    EXPECT_LT(error, bound) << n;
    if (before > 0) {
      EXPECT_GT(before / error, 2.5) << n;
    }
    before = error;
  }
}

/// Back by a part of the way, from the end of a step.
TEST(PlasticPress, StepsConvergeWhenUnloaded) {
  Pressed blocks("");
  const creep::Equilibrium fine = blocks.after(2, 256);
  EXPECT_LT(blocks.difference(blocks.after(2, 32), fine), 2.5e-3);
  EXPECT_LT(blocks.difference(blocks.after(2, 64), fine), 8e-4);
}

/// What sticks where it closes is a kink at every node that closes.
TEST(PlasticPress, StepsConvergeWithFriction) {
  Pressed blocks("friction = 0.3");
  const creep::Equilibrium fine = blocks.after(1, 256);
  EXPECT_LT(blocks.difference(blocks.after(1, 8), fine), 2e-2);
  EXPECT_LT(blocks.difference(blocks.after(1, 32), fine), 4e-3);
}

}  // namespace
}  // namespace plastic_press_tests
}  // namespace creepcontact
