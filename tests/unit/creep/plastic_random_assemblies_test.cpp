/// Random assemblies that yield under loads that come and go out of step: every accepted state must meet all conditions
/// of equilibrium, contact and plastic flow, each computed here from the state alone.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/material/plasticity.hpp"
#include "unit/contact/random_assembly.hpp"

namespace creepcontact::creep {
namespace plastic_assemblies_tests {
namespace {

using creepcontact::test::RandomBoxes;
using material::Plasticity;

constexpr double tolerance = 1e-8;  // relative; iterations go on to a hundredth of it

/// Loads swing around their mean, each body's in its own way.
std::string course(int body) {
  return fmt::format("0.7 + 0.3*sin({}*t + {})", 2.1 + 0.8 * body, 0.9 * body - 1);
}

double size_of(const Tensor6& deviator) {
  return std::sqrt(1.5) * deviator.norm();
}

struct Yielding {
  Assembly assembly;
  Stopwatch watch = {};
  EquilibriumSolver solver;
  History history;

  explicit Yielding(Assembly of)
      : assembly(std::move(of)), solver(assembly, options(), watch), history(solver.initial_history()) {}
  static SolverOptions options() {
    SolverOptions result;
    result.plastic_tolerance = 1e-2 * tolerance;
    result.schwarz.tolerance = 1e-12;
    result.refactor_change = 0.05;
    return result;
  }
  Equilibrium at(double t) {
    const std::vector<mechanics::CreepStrainView> no_creep(assembly.bodies().size());
    Equilibrium result;
    solver.solve(t, no_creep, history, result);
    return result;
  }
  /// As one step: what follows it again in parts may end elsewhere.
  void accept(const Equilibrium& step) {
    const std::vector<mechanics::CreepStrainView> no_creep(assembly.bodies().size());
    solver.accept(step, no_creep, history, {.tolerance = std::numeric_limits<double>::infinity()});
  }
};

/// How assemblies differ apart from their seed.
struct Kind {
  double friction = 0;
  bool is_heated = false;  ///< moduli, yield stresses and back stresses change with it, and all expand

  creepcontact::test::RandomChoice choice() const {
    creepcontact::test::RandomChoice result{.material = [this](int, double E) { return elastic(E); }, .course = course};
    if (is_heated) result.temperature = Function::expression("100 + 40*sin(2.5*t) + 10*z*cos(t)", {"x", "y", "z", "t"});
    return result;
  }
  material::Material elastic(double young_modulus) const {
    material::Material result = creepcontact::test::elastic_material(young_modulus);
    if (is_heated) {
      result.young_modulus = of_temperature(young_modulus, 0.002);
      result.thermal_expansion = Function(2e-6);
      result.reference_temperature = 100;
    }
    return result;
  }
  Function of_temperature(double at_mean, double falls_by) const {
    return is_heated ? Function::expression(fmt::format("{}*(1 - {}*(T - 100))", at_mean, falls_by), {"T"}) : at_mean;
  }
};

Assembly made(RandomBoxes boxes) {
  return {std::move(boxes.bodies), std::move(boxes.pairs)};
}

std::vector<double> largest_stresses(unsigned seed, const Kind& kind) {
  Yielding elastic(made(RandomBoxes(seed, kind.friction, kind.choice())));
  std::vector<double> result(elastic.assembly.bodies().size(), 0.0);
  for (double t = 0; t < 3; t += 0.5) {
    const Equilibrium at = elastic.at(t);
    for (std::size_t b = 0; b < result.size(); ++b)
      for (std::size_t i = 0; i < at.bodies[b].stress.size() / 6; ++i)
        result[b] = std::max(result[b], tensor::von_mises(tensor::view(at.bodies[b].stress, i)));
  }
  return result;
}

/// Below the largest stress of the elastic body: isotropic, linear kinematic, or Armstrong and Frederick's hardening.
std::shared_ptr<const Plasticity> plasticity(double largest_stress, double young_modulus, const Kind& kind,
                                             std::mt19937& generator) {
  std::uniform_real_distribution<double> number(0, 1);
  const double yield = largest_stress * (0.3 + 0.6 * number(generator));
  const double modulus = young_modulus * std::pow(10.0, -2 + 1.5 * number(generator));
  std::vector<material::BackStress> back;
  if (number(generator) < 0.6) back.push_back({kind.of_temperature(2 * modulus, 0.003), 0.0});
  if (number(generator) < 0.6) back.push_back({5 * modulus, 5 * modulus / (0.3 * yield)});
  return std::make_shared<const Plasticity>(kind.of_temperature(yield, 0.004), modulus, std::move(back));
}

/// Directions of the first yield and of the end, from the quadratic equation J(xi + a d) = sy.
Tensor6 first_direction(const Tensor6& xi, const Tensor6& d, double yield) {
  const double a = 1.5 * d.squaredNorm(), b = 1.5 * xi.dot(d), c = 1.5 * xi.squaredNorm() - yield * yield;
  double part = 0;
  const double on_surface = 2e-9 * yield * yield;
  if (c < -on_surface)
    part = (-b + std::sqrt(b * b - a * c)) / a;
  else if (b < 0)
    part = (-b + std::sqrt(std::max(0.0, b * b - a * (c <= on_surface ? 0 : c)))) / a;
  const Tensor6 at = xi + std::clamp(part, 0.0, 1.0) * d;
  return at / size_of(at);
}

/// @returns the number of points that have flowed
int expect_flow(const mechanics::Body& body, const PlasticState& before, const Equilibrium& at, std::size_t b) {
  const Plasticity& law = *body.material().plasticity;
  const PlasticState& after = at.plastic.bodies[b];
  std::vector<double> constants(law.n_constants());
  const std::size_t n = body.discretization().n_points(), width = 6 * law.n_back();
  const auto tensor_of = [](const std::vector<double>& values, std::size_t point) {
    return values.empty() ? Tensor6(Tensor6::Zero()) : Tensor6(tensor::view(values, point));
  };
  const auto back_of = [&](const PlasticState& state, std::size_t point) {
    return state.back.empty() ? std::span<const double>() : std::span(state.back).subspan(point * width, width);
  };
  int flowing = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double T = at.conditions[b].temperature.empty() ? 0 : at.conditions[b].temperature[i];
    const double mu = at.conditions[b].elastic().at(i).mu;
    law.evaluate(T, constants);
    const double p0 = before.accumulated.empty() ? 0 : before.accumulated[i];
    const double p = after.accumulated.empty() ? 0 : after.accumulated[i], D = p - p0;
    const Tensor6 change = tensor_of(after.strain, i) - tensor_of(before.strain, i);
    const Tensor6 s = tensor::deviator(tensor_of(at.bodies[b].stress, i));
    const Tensor6 X0 = law.back_stress(back_of(before, i), constants),
                  X = law.back_stress(back_of(after, i), constants);
    const double yield = law.yield_stress(p, T, constants).stress,
                 before_yield = law.yield_stress(p0, T, constants).stress;
    EXPECT_LE(size_of(s - X), (1 + tolerance) * yield) << i;
    EXPECT_GE(D, 0);
    if (D == 0) {
      EXPECT_TRUE(change.isZero(0)) << i;
      EXPECT_EQ(X, X0) << i;
      continue;
    }
    ++flowing;
    EXPECT_NEAR(size_of(s - X) / yield, 1, tolerance) << i;
    EXPECT_NEAR(tensor::trace(change), 0, tolerance * D) << i;
    const Tensor6 xi = tensor::deviator(tensor_of(before.stress, i)) - X0, trial = s + 2 * mu * change;
    const Tensor6 N = (s - X) / size_of(s - X), first = first_direction(xi, trial - X0 - xi, before_yield);
    const Tensor6 mean = 0.5 * (first + N);
    // As a strain within what the tolerance of the stress leaves of it.
    const double error = tolerance * (D + yield / (3 * mu));
    EXPECT_LE((change - 1.5 * D * mean).norm(), error) << i << " D " << D;
    for (std::size_t k = 0; k < law.n_back(); ++k) {
      const double gamma = constants[3 + 2 * k], kept = std::exp(-gamma * D);
      const double length = gamma > 0 ? (1 - kept) / gamma : D;
      const Tensor6 alpha0 =
          before.back.empty() ? Tensor6(Tensor6::Zero()) : Tensor6(tensor::view(back_of(before, i), k));
      EXPECT_LE((Tensor6(tensor::view(back_of(after, i), k)) - kept * alpha0 - 1.5 * length * mean).norm(), error) << i;
    }
  }
  return flowing;
}

double largest(std::span<const double> values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

/// The stress is that of the displacement without creep and plastic strain, and balances loads and contact. Errors are
/// relative to the largest of all bodies, some of which carry nothing.
void expect_equilibrium(const Assembly& assembly, const Equilibrium& at) {
  double unbalanced = 0, force = 0, difference = 0, size = 0;
  for (std::size_t b = 0; b < assembly.bodies().size(); ++b) {
    const mechanics::Body& body = assembly.bodies()[b];
    const std::vector<double>& stress = at.bodies[b].stress;
    std::vector<double> forces(body.constraints().n_full()), free(body.constraints().n_free()), internal(forces.size()),
        elastic(stress.size());
    body.residual_forces(at.conditions[b], stress, forces);
    Eigen::Map<Eigen::VectorXd> left(forces.data(), std::ssize(forces));
    for (const contact::Pair& pair : assembly.pairs()) {
      const auto own = at.contact.multiplier.segment(pair.first_row, pair.coupling.n_rows());
      if (pair.slave_body == b) left -= pair.coupling.slave_rows.transpose() * own;
      if (pair.master_body == b) left -= pair.coupling.master_rows.transpose() * own;
    }
    body.constraints().restrict_to_free(forces, free);
    body.discretization().add_internal_force(stress, internal);
    unbalanced = std::max(unbalanced, largest(free));
    force = std::max(force, largest(internal));

    const std::vector<double>& plastic = at.plastic.bodies[b].strain;
    body.discretization().stress(
        at.bodies[b].displacement, at.conditions[b].elastic(),
        plastic.empty() ? mechanics::CreepStrainView() : mechanics::CreepStrainView(plastic, 6), elastic);
    size = std::max(size, largest(stress));
    for (std::size_t i = 0; i < stress.size(); ++i) elastic[i] -= stress[i];
    difference = std::max(difference, largest(elastic));
  }
  EXPECT_LE(unbalanced, tolerance * force);
  EXPECT_LE(difference, tolerance * size);
}

/// Pressures press, gaps do not overlap, and not both are there; friction stays within its cone. The gaps are those of
/// the displacements. @returns the number of closed nodes
int expect_contact(const Assembly& assembly, const contact::ContactProblem& problem, double friction,
                   const Equilibrium& at) {
  const Eigen::VectorXd flexibility = contact::row_flexibility(problem);
  const double error = tolerance * at.contact.multiplier.cwiseAbs().maxCoeff();
  const auto displacement = [&](std::size_t b) {
    const std::vector<double>& of = at.bodies[b].displacement;
    return Eigen::Map<const Eigen::VectorXd>(of.data(), std::ssize(of));
  };
  int closed = 0;
  for (const contact::Pair& pair : assembly.pairs()) {
    const contact::MortarCoupling& coupling = pair.coupling;
    const Eigen::VectorXd gap = pair.initial_gap(at.time) + coupling.slave_rows * displacement(pair.slave_body) +
                                coupling.master_rows * displacement(pair.master_body);
    const auto multiplier = at.contact.multiplier.segment(pair.first_row, coupling.n_rows());
    for (std::size_t node = 0; node < coupling.nodes.size(); ++node) {
      const Index row = coupling.row(node);
      EXPECT_NEAR(std::min(multiplier[row], gap[row] / flexibility[pair.first_row + row]), 0, error)
          << pair.name << row;
      EXPECT_LE(multiplier.segment(row + 1, coupling.rows_per_node() - 1).norm(), friction * multiplier[row] + error);
      closed += multiplier[row] > 0 ? 1 : 0;
    }
  }
  return closed;
}

struct Met {
  int flowing = 0, idle = 0, closed = 0, floating = 0, unsolved = 0;
};

/// Checks every step of an assembly, to where loads cannot be carried.
void expect_conditions(unsigned seed, const Kind& kind, Met& met) {
  const std::vector<double> stresses = largest_stresses(seed, kind);
  const double scale = largest(stresses);
  constexpr double rounding = 1e-9;  // moduli are 0.03 to 30, strains about 1e-3
  if (scale < rounding) return;      // the bodies stay apart
  std::mt19937 generator(seed);
  const auto material = [&](int body, double young_modulus) {
    material::Material result = kind.elastic(young_modulus);
    const double largest_stress = stresses[static_cast<std::size_t>(body)];
    if (largest_stress > 1e-6 * scale) result.plasticity = plasticity(largest_stress, young_modulus, kind, generator);
    return result;
  };
  creepcontact::test::RandomChoice choice = kind.choice();
  choice.material = material;
  RandomBoxes boxes(seed, kind.friction, std::move(choice));
  SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << boxes.description);
  Yielding system(made(std::move(boxes)));
  met.floating += system.solver.interface().problem().n_motions() > 0 ? 1 : 0;
  for (double t = 0.25; t <= 2.5; t += 0.25) {
    SCOPED_TRACE(testing::Message() << "t = " << t);
    const PlasticHistory before = system.history.plastic;
    const Equilibrium at = system.at(t);
    for (std::size_t b = 0; b < stresses.size(); ++b) {
      if (!system.assembly.bodies()[b].material().plasticity) continue;
      const int of_body = expect_flow(system.assembly.bodies()[b], before.bodies[b], at, b);
      met.flowing += of_body;
      met.idle += of_body == 0 ? 1 : 0;
    }
    expect_equilibrium(system.assembly, at);
    met.closed += expect_contact(system.assembly, system.solver.interface().problem(), kind.friction, at);
    system.accept(at);
    if (kind.friction > 0) continue;  // whose path may end elsewhere
    const Equilibrium again = system.at(t);
    for (std::size_t b = 0; b < stresses.size(); ++b)
      for (std::size_t i = 0; i < at.bodies[b].stress.size(); ++i)
        EXPECT_NEAR(again.bodies[b].stress[i], at.bodies[b].stress[i], 10 * tolerance * scale) << "goes on from there";
  }
}

TEST(PlasticAssemblies, MeetEveryConditionAfterEveryStep) {
  Met met;
  for (unsigned seed = 1; seed <= 16; ++seed) expect_conditions(seed, {}, met);
  EXPECT_GT(met.flowing, 5000) << "points";
  EXPECT_GT(met.idle, 200) << "bodies that rest or unload in a step";
  EXPECT_GT(met.closed, 2000);
  EXPECT_GT(met.floating, 10);
}

TEST(PlasticAssemblies, MeetEveryConditionWhileTheirTemperatureChanges) {
  Met met;
  for (unsigned seed = 1; seed <= 12; ++seed) expect_conditions(seed, {.is_heated = true}, met);
  EXPECT_GT(met.flowing, 5000) << "points";
  EXPECT_GT(met.closed, 1000);
}

TEST(PlasticAssemblies, MeetEveryConditionWithFriction) {
  Met met;
  for (unsigned seed = 1; seed <= 7; ++seed) {
    try {
      expect_conditions(seed, {.friction = 0.1 + 0.02 * (seed % 20)}, met);
    } catch (const contact::SlidingOff&) {
      ++met.unsolved;
    }
  }
  EXPECT_GT(met.flowing, 1000) << "points";
  EXPECT_GT(met.closed, 800);
  EXPECT_LE(met.unsolved, 1) << "tilts over under its loads";
}

/// Plain iterations without acceleration converge in these.
TEST(PlasticAssemblies, ConvergeInEveryStep) {
  for (const unsigned seed : {56U, 107U}) {
    Met met;
    EXPECT_NO_THROW(expect_conditions(seed, {}, met)) << seed;
  }
}

TEST(PlasticAssemblies, ConvergeInEveryStepWhileTheirTemperatureChanges) {
  for (const unsigned seed : {16U, 43U, 79U, 98U, 111U}) {
    Met met;
    EXPECT_NO_THROW(expect_conditions(seed, {.is_heated = true}, met)) << seed;
  }
}

}  // namespace
}  // namespace plastic_assemblies_tests
}  // namespace creepcontact::creep
