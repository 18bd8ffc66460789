#include <algorithm>
#include <cmath>
#include <random>

#include "creepcontact/base/error.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

/// Noise of these sizes in the creep strains makes the stress of every point another one.
std::vector<double> random_state(const System& system, double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> y(system.rate.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = number(generator) * system.rate.scale()[i];
  return y;
}

std::vector<double> rate_at(System& system, double t, const std::vector<double>& y) {
  std::vector<double> rate(y.size());
  system.rate.rate(t, y, rate);
  return rate;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(a[i]));
  }
  return difference / size;
}

TEST(CreepSystemOverflow, StressBeyondAllBoundsIsNoRate) {
  const Case blocks;
  System system(blocks.config(""));
  for (const double huge : {1e306, 1e308}) {
    const std::vector<double> y = random_state(system, huge, 1);
    EXPECT_THROW(rate_at(system, 0, y), RecoverableError) << huge;
  }
}

constexpr const char* direct_contact = "contact_solver.method=active_set";
/// Overlap at x = 0, a gap at x = 2.
const std::vector<std::string> partly_open{"contacts.0.gap=0.03*x-0.01", "supports.3.displacement.z=-0.01"};

/// Heat that flows down through the joint and makes everything depend on the temperature.
std::vector<std::string> with_heat(std::vector<std::string> overrides) {
  for (const char* one :
       {"heat.start=100+10*z", "heat.time_unit=1", "heat.films=[{ on = \"top\", coefficient = 0.5, fluid = 150 }]",
        "heat.temperatures=[{ on = \"bottom\", value = 80 }]", "contacts.0.conductance=0.02/(1+gap/0.01)+0.1*p+1e-4*T",
        "materials.soft.creep.0.A=1e-5*T", "materials.hard.thermal_expansion=1e-4",
        "materials.hard.reference_temperature=90", "materials.soft.thermal_expansion=2e-4",
        "materials.soft.reference_temperature=90"})
    overrides.emplace_back(one);
  for (const std::string material : {"soft", "hard"})
    for (const char* key : {"conductivity=0.05+1e-4*T", "heat_capacity=1+1e-3*T", "density=1"})
      overrides.push_back("materials." + material + "." + key);
  return overrides;
}

struct JacobianCase {
  const char* name;
  int active;  ///< contact conditions in force, of 12 (tied: 36, 7 of them held by planes of symmetry); -1: some, not
               ///< all
  std::vector<std::string> overrides;
  double error = 1e-6;
};

class CreepSystemJacobian : public testing::TestWithParam<JacobianCase> {};

TEST_P(CreepSystemJacobian, IsTheDerivativeOfTheRate) {
  std::vector<std::string> overrides = GetParam().overrides;
  overrides.emplace_back(direct_contact);
  const Case blocks;
  System system(blocks.config("", overrides));
  const std::vector<double> noise = random_state(system, 0.3, 1), v = random_state(system, 1, 2);
  std::vector<double> y = system.rate.initial_state();
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += noise[i];

  std::vector<double> product(y.size());
  system.rate.jacobian_times(0, y, v, product);
  const std::size_t active = system.equilibrium().contact.active.size();
  const std::size_t rows = system.solver.interface().n_rows();
  if (GetParam().active < 0)
    EXPECT_TRUE(active > 0 && active < rows) << active << " of " << rows;
  else
    EXPECT_EQ(active, static_cast<std::size_t>(GetParam().active));

  constexpr double h = 1e-5;
  std::vector<double> plus = y, minus = y, difference(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    plus[i] += h * v[i];
    minus[i] -= h * v[i];
  }
  plus = rate_at(system, 0, plus);
  ASSERT_EQ(system.equilibrium().contact.active.size(), active);
  minus = rate_at(system, 0, minus);
  ASSERT_EQ(system.equilibrium().contact.active.size(), active);
  for (std::size_t i = 0; i < y.size(); ++i) difference[i] = (plus[i] - minus[i]) / (2 * h);
  EXPECT_LT(largest_difference(product, difference), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Contacts, CreepSystemJacobian,
    testing::Values(JacobianCase{"closed", 12, {}}, JacobianCase{"partly_open", -1, partly_open},
                    // four nodes in the plane y = 0, which neither body leaves
                    JacobianCase{"tied", 29, {"contacts.0.type=tied"}}, JacobianCase{"quadratic", 12, {"mesh.order=2"}},
                    JacobianCase{"one_elastic_body", 12, {"materials.hard.creep=[]"}},
                    JacobianCase{"heat", 12, with_heat({})},
                    JacobianCase{"heat_partly_open", -1, with_heat(partly_open)},
                    // products have the stiffness of the factors, which may differ by some per cent
                    JacobianCase{"heat_and_moduli", 12, with_heat({"materials.soft.young_modulus=120-0.2*T"}), 1e-2},
                    JacobianCase{"hot", 12, {"temperature.value=100+10*z", "materials.soft.creep.0.A=1e-5*T"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

class CreepSystemPurity : public testing::TestWithParam<const char*> {};

TEST_P(CreepSystemPurity, EvaluationsInBetweenChangeNothing) {
  const Case blocks;
  std::vector<std::string> overrides = partly_open;
  overrides.push_back(std::string("contact_solver.method=") + GetParam());
  System system(blocks.config("", overrides));
  const std::vector<double> y = random_state(system, 0.3, 1), other = random_state(system, 2, 2);
  const std::vector<double> first = rate_at(system, 0, y);

  const std::vector<double> elsewhere = rate_at(system, 0, other);
  EXPECT_GT(largest_difference(first, elsewhere), 0.1);
  EXPECT_EQ(rate_at(system, 0, y), first);

  std::vector<double> product(y.size());
  system.rate.jacobian_times(0, other, y, product);
  system.rate.prepare_preconditioner(0, other);
  system.rate.precondition(0.1, y, product);
  EXPECT_EQ(rate_at(system, 0, y), first);

  // Right after a Jacobian product at the same point too: it must leave the stress of the point as it was.
  system.rate.jacobian_times(0, y, other, product);
  EXPECT_EQ(rate_at(system, 0, y), first);
}

TEST_P(CreepSystemPurity, AcceptedStepsChangeTheCostOnly) {
  const Case blocks;
  std::vector<std::string> overrides = partly_open;
  overrides.push_back(std::string("contact_solver.method=") + GetParam());
  overrides.emplace_back("contact_solver.tolerance=1e-14");
  System system(blocks.config("", overrides));
  const std::vector<double> y = random_state(system, 0.3, 1), other = random_state(system, 2, 2);
  const std::vector<double> first = rate_at(system, 0, y);
  rate_at(system, 0, other);
  system.rate.accept(0, other);
  EXPECT_LT(largest_difference(rate_at(system, 0, y), first), 1e-12);
}

TEST(CreepSystem, AcceptMakesTheNextContactSolveCheaper) {
  const Case blocks;
  System system(blocks.config("", partly_open));
  const std::vector<double> y = random_state(system, 0.3, 1), other(y.size());
  const auto iterations = [&](const std::vector<double>& at) {
    const std::int64_t before = system.rate.run_counters().schwarz_iterations;
    rate_at(system, 0, at);
    return system.rate.run_counters().schwarz_iterations - before;
  };
  const std::int64_t cold = iterations(y);
  system.rate.accept(0, y);
  iterations(other);
  EXPECT_LT(iterations(y), cold);
}

INSTANTIATE_TEST_SUITE_P(Methods, CreepSystemPurity, testing::Values("schwarz", "active_set"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(CreepSystem, ScaleIsTypicalStressOverYoungsModulus) {
  const Case blocks;
  const System system(blocks.config());
  const StateLayout& layout = system.rate.layout();
  ASSERT_EQ(layout.size(), system.rate.scale().size());
  for (std::size_t b = 0; b < 2; ++b)
    for (const double scale : layout.part(b, system.rate.scale()))
      ASSERT_NEAR(scale, b == 0 ? 1.0 / 100 : 1.0 / 200, 1e-11);
}

TEST(StateLayout, PartsOfTheBodiesAreTheWholeVector) {
  const Case blocks;
  const System elastic_upper(blocks.config("", {"materials.hard.creep=[]"})), system(blocks.config());
  for (const System* of : {&elastic_upper, &system}) {
    const StateLayout& layout = of->rate.layout();
    const std::vector<double> y(layout.size());
    const double* begin = y.data();
    for (std::size_t b = 0; b < 2; ++b) {
      const std::span<const double> part = layout.part(b, std::span(y));
      EXPECT_EQ(part.data(), begin);
      EXPECT_EQ(part.size(), layout.stride(b) * of->model.bodies()[b].discretization().n_points());
      begin += part.size();
    }
    EXPECT_EQ(begin, y.data() + y.size());
  }
  const std::vector<double> none(elastic_upper.rate.layout().size());
  EXPECT_TRUE(elastic_upper.rate.layout().part(1, std::span(none)).empty());
}

TEST(CreepSystem, ScaleSeesLoadsThatComeLater) {
  const Case blocks;
  const System ramp(blocks.config("", {"supports.3.displacement.z=-0.025*t", "time.end=2"}));
  EXPECT_NEAR(ramp.rate.scale()[0], 2.0 / 100, 1e-11);
  const System peak(
      blocks.config("", {"supports.3.displacement.z={t=[0,1,2],values=[0,-0.075,-0.025]}", "time.end=4"}));
  EXPECT_NEAR(peak.rate.scale()[0], 3.0 / 100, 1e-11);
}

TEST(CreepSystem, ScaleOfABodyAtRestIsAShareOfTheLargest) {
  const Case blocks;
  const std::string load = "[[loads]]\non = \"side_x\"\nbody = \"lower\"\npressure = 2\n";
  const System system(blocks.config(load, {"contacts.0.gap=1", "supports.3.displacement.z=0"}));
  EXPECT_NEAR(system.rate.scale()[0], 2.0 / 100, 1e-11);
  EXPECT_NEAR(system.rate.scale()[system.rate.layout().offset(1)], 0.01 * 2.0 / 200, 1e-13);
}

TEST(CreepSystem, NothingThatLoadsIsAMistake) {
  const Case blocks;
  const config::Config config = blocks.config("", {"supports.3.displacement.z=0"});
  EXPECT_TRUE(says(message_of<ModelError>([&] { const System system(config); }), {"not loaded"}));
}

TEST(CreepSystem, StableStepIsCormeaus) {
  const Case blocks;
  // The step of the upper, stiffer block limits: 4 (1 + nu) / (3 E n A q^(n-1)) at q = 2
  System system(blocks.config("", {"supports.3.displacement.z=-0.05"}));
  const std::vector<double> y(system.rate.size());
  const double expected = 4 * 1.3 / (3 * 200 * 4 * 1e-3 * std::pow(2.0, 3));
  EXPECT_NEAR(system.rate.stable_step(0, y), expected, 1e-10 * expected);

  System at_rest(blocks.config("", {"supports.3.displacement.z=-0.05*t"}));
  EXPECT_TRUE(std::isinf(at_rest.rate.stable_step(0, y)));
}

TEST(CreepSystem, ElasticBodiesTakeNoPlaceInTheState) {
  const Case blocks;
  const System both(blocks.config()), lower(blocks.config("", {"materials.hard.creep=[]"})),
      none(blocks.config("", {"materials.hard.creep=[]", "materials.soft.creep=[]"}));
  EXPECT_EQ(lower.rate.size(), 6 * lower.model.bodies()[0].discretization().n_points());
  EXPECT_EQ(both.rate.size(), lower.rate.size() + 6 * both.model.bodies()[1].discretization().n_points());
  EXPECT_EQ(none.rate.size(), 0U);
  EXPECT_FALSE(none.model.assembly.creeps());
}

TEST(CreepSystem, OverflowMayBeMendedByASmallerStep) {
  const Case blocks;
  System system(blocks.config());
  std::vector<double> y(system.rate.size(), 0.0), rate(y.size());
  y[0] = 1e150;
  EXPECT_THROW(system.rate.rate(0, y, rate), RecoverableError);
  // and leaves the system usable
  y[0] = 0;
  system.rate.rate(0, y, rate);
  EXPECT_TRUE(std::all_of(rate.begin(), rate.end(), [](double value) { return std::isfinite(value); }));
}

TEST(CreepSystem, CountsWhatItCosts) {
  const Case blocks;
  System system(blocks.config());
  const RunCounters before = system.rate.run_counters();
  const std::vector<double> y = random_state(system, 0.1, 1);
  std::vector<double> product(y.size());
  rate_at(system, 0, y);
  system.rate.jacobian_times(0, y, y, product);  // at the same point: one linear solve more
  const RunCounters after = system.rate.run_counters();
  EXPECT_EQ(after.rhs_evaluations - before.rhs_evaluations, 1);
  EXPECT_EQ(after.jacobian_products - before.jacobian_products, 1);
  EXPECT_EQ(after.elastic_solves - before.elastic_solves, 2);
  EXPECT_EQ(after.contact_solves - before.contact_solves, 1);
  EXPECT_EQ(after.factorizations, 2);
}

/// The top jumps from -0.025 to -0.05 at t = 1, written with < or with <=, or as a table.
TEST(CreepSystemSegments, LoadsAtTheirEndsAreLimitsFromWithin) {
  const Case blocks;
  for (const char* value :
       {"'t<1 ? -0.025 : -0.05'", "'t<=1 ? -0.025 : -0.05'", "{t=[0,1,1,2],values=[-0.025,-0.025,-0.05,-0.05]}"}) {
    System system(
        blocks.config("", {std::string("supports.3.displacement.z=") + value, direct_contact, "time.breakpoints=[1]"}));
    const std::vector<double> y(system.rate.size(), 0.0);
    const auto pressure = [&](double begin, double end) {
      system.rate.begin_segment(begin, end);
      rate_at(system, 1, y);
      return system.equilibrium().contact.multiplier.maxCoeff();
    };
    EXPECT_NEAR(pressure(0, 1), 1, 1e-9) << value;
    EXPECT_NEAR(pressure(1, 4), 2, 1e-9) << value;
  }
}

TEST(CreepSystemMemory, MakesTheNextEvaluationTheSame) {
  const Case blocks;
  const config::Config config = blocks.config("", partly_open);
  System one(config), other(config);
  const std::vector<double> y = random_state(one, 0.3, 1), next = random_state(one, 0.3, 2);
  rate_at(one, 0, y);
  one.rate.accept(0, y);
  creep::Memory memory;
  one.rate.save(memory);
  other.rate.restore(memory);
  EXPECT_EQ(rate_at(other, 0, next), rate_at(one, 0, next));
  EXPECT_EQ(one.equilibrium().contact.multiplier, other.equilibrium().contact.multiplier);
  memory.erase("history.contact.active");
  EXPECT_THROW(other.rate.restore(memory), std::out_of_range);
}

TEST(CreepSystemMemory, ForgottenEvaluationsAreMadeAnew) {
  const Case blocks;
  System system(blocks.config());
  const std::vector<double> y(system.rate.size(), 0.0);
  rate_at(system, 0, y);
  const auto solves = [&] { return system.rate.run_counters().elastic_solves; };
  const auto before = solves();
  rate_at(system, 0, y);
  EXPECT_EQ(solves(), before);
  system.rate.forget_evaluations();
  rate_at(system, 0, y);
  EXPECT_EQ(solves(), before + 1);
}

}  // namespace
}  // namespace creepcontact::run::test
