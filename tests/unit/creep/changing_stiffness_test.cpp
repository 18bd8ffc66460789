/// A stiffness that follows a temperature that changes in time: the factors may be of another time.

#include <random>

#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace changing_stiffness_tests {
namespace {

/// Both moduli of both bodies change, each in its own way, and not alike everywhere.
const std::vector<std::string> hot{"materials.soft.young_modulus='100-0.08*T'",
                                   "materials.soft.poisson_ratio='0.3+1e-4*T'",
                                   "materials.hard.young_modulus='200-0.3*T'",
                                   "materials.soft.thermal_expansion='1e-5+2e-8*T'",
                                   "materials.hard.thermal_expansion=1.5e-5",
                                   "materials.soft.reference_temperature=0",
                                   "materials.hard.reference_temperature=0",
                                   "temperature.value='100*t*(1+0.3*x+0.2*z)'",
                                   "contact_solver.tolerance=1e-13"};

std::vector<std::string> with(std::vector<std::string> overrides, const std::vector<std::string>& more) {
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

std::string refactor_change(double bound) {
  return "temperature.refactor_change=" + std::to_string(bound);
}

std::vector<double> random_vector(const System& system, double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> y(system.rate.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = number(generator) * system.rate.scale()[i];
  return y;
}

template <typename Vector>
double relative_difference(const Vector& a, const Vector& b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.size()); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(a[i]));
  }
  return difference / size;
}

struct StiffnessCase {
  const char* name;
  std::vector<std::string> overrides;
  bool floating = false;
};

class ChangingStiffness : public testing::TestWithParam<StiffnessCase> {
 protected:
  config::Config config(double bound) const {
    const auto overrides = with(with(hot, GetParam().overrides), {refactor_change(bound)});
    if (!GetParam().floating) return blocks_.config("", overrides);
    std::string text = case_text;
    const std::string held = "[[supports]]\non = \"top\"\ndisplacement = { z = -0.025 }";
    text.replace(text.find(held), held.size(), "[[loads]]\non = \"top\"\npressure = \"1-0.2*t\"");
    return blocks_.parse(text, overrides);
  }

 private:
  Case blocks_;
};

TEST_P(ChangingStiffness, HasTheEquilibriumOfItsTimeWithAnyFactor) {
  System now(config(0)), before(config(0.5));
  const std::vector<double> y = random_vector(now, 0.3, 1);
  std::vector<double> rate(y.size()), same(y.size());
  for (const double t : {0.0, 0.4, 1.0, 0.7}) {
    now.rate.rate(t, y, rate);
    before.rate.rate(t, y, same);
    EXPECT_LT(relative_difference(rate, same), 1e-8) << "t = " << t;
    for (std::size_t b = 0; b < 2; ++b) {
      const BodyState &exact = now.equilibrium().bodies[b], &iterated = before.equilibrium().bodies[b];
      EXPECT_LT(relative_difference(exact.stress, iterated.stress), 1e-9) << "t = " << t;
      EXPECT_LT(relative_difference(exact.displacement, iterated.displacement), 1e-9) << "t = " << t;
    }
    EXPECT_LT(relative_difference(now.equilibrium().contact.multiplier, before.equilibrium().contact.multiplier), 1e-9);
    EXPECT_EQ(now.equilibrium().contact.active, before.equilibrium().contact.active);
  }
  EXPECT_EQ(before.solver.counters().factorizations, 2) << "its bound is not reached";
  EXPECT_GE(now.solver.counters().factorizations, 2 * 4) << "one per body and time";
}

TEST_P(ChangingStiffness, IsQuickerFromAnAcceptedStepAndNotElsewhere) {
  System cold(config(0.5)), warm(config(0.5));
  const std::vector<double> y = random_vector(cold, 0.3, 1);
  std::vector<double> rate(y.size()), same(y.size());
  const auto solves = [](const System& system) { return system.solver.counters().elastic_solves; };
  for (System* system : {&cold, &warm}) system->rate.rate(1.0, y, rate);
  warm.rate.accept(1.0, y);
  const std::int64_t cold_before = solves(cold), warm_before = solves(warm);
  cold.rate.rate(1.001, y, rate);
  warm.rate.rate(1.001, y, same);
  EXPECT_LT(solves(warm) - warm_before, solves(cold) - cold_before);
  EXPECT_LT(relative_difference(rate, same), 1e-8);
}

TEST_P(ChangingStiffness, HasAJacobianThatIsWrongByTheBoundAtMost) {
  for (const double bound : {0.0, 0.5}) {
    System system(config(bound));
    const std::vector<double> y = random_vector(system, 0.3, 1), v = random_vector(system, 1, 2);
    std::vector<double> product(y.size()), moved(y.size()), plus(y.size()), minus(y.size());
    const double h = 1e-4, t = 1.0;
    for (std::size_t i = 0; i < y.size(); ++i) moved[i] = y[i] + h * v[i];
    system.rate.rate(t, moved, plus);
    for (std::size_t i = 0; i < y.size(); ++i) moved[i] = y[i] - h * v[i];
    system.rate.rate(t, moved, minus);
    system.rate.jacobian_times(t, y, v, product);
    for (std::size_t i = 0; i < y.size(); ++i) plus[i] = (plus[i] - minus[i]) / (2 * h);
    const double difference = relative_difference(plus, product);
    if (bound == 0)
      EXPECT_LT(difference, 1e-5);
    else
      EXPECT_LT(difference, 0.15) << "the moduli differ from their mean by up to 0.11";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ChangingStiffness,
    testing::Values(StiffnessCase{"held", {}}, StiffnessCase{"direct", {"contact_solver.method=active_set"}},
                    StiffnessCase{"partly_open", {"contacts.0.gap=0.03*x-0.01", "supports.3.displacement.z=-0.01"}},
                    StiffnessCase{"tied", {"contacts.0.type=tied"}},
                    StiffnessCase{"matrix_free", {"contact_solver.dense_limit_mb=1e-9"}},
                    StiffnessCase{"quadratic", {"mesh.order=2"}}, StiffnessCase{"floating", {}, true}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// hex20 in single rows, which reduced integration leaves the least stiff.
TEST(ChangingStiffnessOfARow, HasTheEquilibriumOfItsTimeWithAnyFactor) {
  std::string geometry = separate_blocks();
  for (const std::string from : {"{1:24} = 3", "{9:12} = 4", "{21:24} = 5"})
    geometry.replace(geometry.find(from), from.size(), from.substr(0, from.size() - 1) + "2");
  const std::string fine = "Transfinite Curve{21:24} = 2;";
  geometry.replace(geometry.find(fine), fine.size(), fine + "\nTransfinite Curve{1, 3, 5, 7} = 9;");
  const Case blocks(geometry);
  const auto overrides = with(hot, {"mesh.order=2"});
  System now(blocks.config("", with(overrides, {refactor_change(0)})));
  System before(blocks.config("", with(overrides, {refactor_change(0.5)})));
  const std::vector<double> y = random_vector(now, 0.3, 1);
  std::vector<double> rate(y.size()), same(y.size());
  now.rate.rate(1.0, y, rate);
  before.rate.rate(1.0, y, same);
  EXPECT_LT(relative_difference(rate, same), 1e-8);
  for (std::size_t b = 0; b < 2; ++b)
    EXPECT_LT(
        relative_difference(now.equilibrium().bodies[b].displacement, before.equilibrium().bodies[b].displacement),
        1e-8);
}

/// If all moduli change by one factor, one elastic solve is enough, whatever the factor.
TEST(ChangingStiffnessOfAll, NeedsNoIteration) {
  const Case blocks;
  System system(blocks.config("", {"materials.soft.young_modulus='100-0.08*T'", "temperature.value='1000*t'",
                                   "materials.hard.young_modulus='200-0.16*T'"}));
  const std::vector<double> y = random_vector(system, 0.3, 1);
  std::vector<double> rate(y.size());
  const auto before = system.solver.counters();
  system.rate.rate(0.9, y, rate);
  EXPECT_EQ(system.solver.counters().elastic_solves, before.elastic_solves + 1);
  EXPECT_EQ(system.solver.counters().factorizations, 2);
  double force = 0;
  for (const double multiplier : system.equilibrium().contact.multiplier) force = std::max(force, multiplier);
  EXPECT_LT(force, 1);
  EXPECT_GT(force, 0.1) << "28 % of the stiffness press with 28 % of the pressure";
}

TEST(ChangingStiffnessResumed, EndsAsTheUninterruptedRunToTheLastBit) {
  const Case blocks;
  const config::Config config = blocks.config(
      pressure_probe, with(hot, {"time.integrator=arkode_dirk", "time.tolerance=1e-6", "time.output=[0.5, 1, 1.6, 3]",
                                 "temperature.value='100*sin(t)*(1+0.3*x+0.2*z)'", refactor_change(0.03)}));
  const std::filesystem::path whole = blocks / "whole", parts = blocks / "parts";
  ASSERT_EQ(run(config, {.output = whole.string()}).exit_status, 0);
  InterruptAtOutput interrupt(3);
  ASSERT_EQ(run(config, {.output = parts.string(), .observers = {&interrupt}}).exit_status, 130);
  ASSERT_EQ(run(config, {.output = parts.string(), .resume = true}).exit_status, 0);
  EXPECT_EQ(read_text(parts / "history.csv"), read_text(whole / "history.csv"));
  EXPECT_EQ(read_text(parts / "steps.csv"), read_text(whole / "steps.csv"));
  EXPECT_GT(SummaryFile(whole / "summary.json").number("factorizations"), 4) << "the stiffness is factorised again";
}

}  // namespace
}  // namespace changing_stiffness_tests
}  // namespace creepcontact::run::test
