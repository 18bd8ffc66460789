/// Butcher tables by name, each of its order.

#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/ode/sundials/butcher_tables.hpp"
#include "creepcontact/base/error.hpp"
#include "systems.hpp"

namespace creepcontact::ode {
namespace {

TEST(ButcherTables, AreFoundInAnySpelling) {
  for (const char* name : {"dormand_prince_7_4_5", "DORMAND_PRINCE_7_4_5", "ARKODE_DORMAND_PRINCE_7_4_5"})
    EXPECT_EQ(find_table(explicit_tables(), name).order, 5);
}

TEST(ButcherTables, OthersAreRefusedByName) {
  LinearSystem system({-1.0});
  for (const auto& [integrator, table] :
       {std::pair{"arkode_erk", "ark324l2sa_dirk_4_2_3"}, {"arkode_dirk", "dormand_prince_7_4_5"}}) {
    IntegratorOptions options;
    options.table = table;
    try {
      make_integrator(integrator, system, options);
      ADD_FAILURE() << table;
    } catch (const ConfigError& error) {
      for (const char* part : {table, "allowed", "_4_2_3"})
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

struct Case {
  std::string integrator, table;
};

class EveryTable : public testing::TestWithParam<Case> {};

/// The bar relaxes from half its initial stress, where steps of 1/32 h are short against its relaxation: no order is
/// lost to stiffness.
constexpr double begin_stress = RelaxingBar::initial_stress / 2;
constexpr double begin_strain = begin_stress / RelaxingBar::E;

double error_after_one_hour(double strain) {
  constexpr double n = RelaxingBar::n;
  const double exact = std::pow(std::pow(begin_stress, 1 - n) + (n - 1) * RelaxingBar::A * RelaxingBar::E, 1 / (1 - n));
  return std::abs(RelaxingBar::stress(strain) - exact);
}

/// Steps of equal length: each is proposed anew, under a tolerance that accepts it.
double error_of_equal_steps(const Case& method, int steps, int& order) {
  RelaxingBar bar;
  IntegratorOptions options{.tolerance = 1e6};
  options.table = method.table;
  auto integrator = make_integrator(method.integrator, bar, options);
  Values y{begin_strain};
  for (int k = 0; k < steps; ++k) {
    const double next = (k + 1.0) / steps;
    integrator->initialize(static_cast<double>(k) / steps, y, 1.0 / steps);
    order = integrator->step(next).order;
    EXPECT_EQ(integrator->time(), next);
    y.assign(integrator->state().begin(), integrator->state().end());
  }
  return error_after_one_hour(y[0]);
}

/// The tolerance is that of the Newton iteration, too: implicit methods get the order from the number of steps it
/// takes.
double observed_order_of_implicit(const Case& method, int& order) {
  std::vector<double> steps, errors;
  for (double tolerance : {1e-5, 1e-9}) {
    RelaxingBar bar;
    IntegratorOptions options{.tolerance = tolerance};
    options.table = method.table;
    auto integrator = make_integrator(method.integrator, bar, options);
    integrator->initialize(0, Values{begin_strain});
    while (integrator->time() < 1) order = integrator->step(1).order;
    steps.push_back(static_cast<double>(integrator->counters().steps));
    errors.push_back(error_after_one_hour(integrator->state()[0]));
  }
  return std::log(errors[0] / errors[1]) / std::log(steps[1] / steps[0]);
}

TEST_P(EveryTable, HasTheOrderThatItReports) {
  const Case& method = GetParam();
  int order = 0;
  if (method.integrator == "arkode_erk") {
    const int digit = method.table.back() - '0';
    const int steps = digit <= 3 ? 128 : 32;  // errors well above rounding
    const double coarse = error_of_equal_steps(method, steps, order);
    const double fine = error_of_equal_steps(method, 2 * steps, order);
    EXPECT_GT(std::log2(coarse / fine), order - 0.4);
    EXPECT_LT(std::log2(coarse / fine), order + 0.9);
  } else {
    const double observed = observed_order_of_implicit(method, order);
    EXPECT_GT(observed, order - 1.2);
  }
  EXPECT_EQ(order, method.table.back() - '0') << "the name ends with it";
}

TEST_P(EveryTable, MeetsTheTolerance) {
  const Case& method = GetParam();
  for (double tolerance : {1e-3, 1e-5}) {
    RelaxingBar bar;
    IntegratorOptions options{.tolerance = tolerance, .end_time = 10};
    options.table = method.table;
    auto integrator = make_integrator(method.integrator, bar, options);
    const Values times = {0.1, 1, 10};
    integrator->initialize(0, Values{0});
    for (double t : times) {
      while (integrator->time() < t) integrator->step(10);
      Values y(1);
      integrator->interpolate(t, y);
      EXPECT_NEAR(RelaxingBar::stress(y[0]), RelaxingBar::exact_stress(t), 20 * tolerance * RelaxingBar::initial_stress)
          << "t = " << t;
    }
  }
}

std::vector<Case> all_tables() {
  std::vector<Case> cases;
  for (const IntegratorInfo& info : integrators())
    for (const std::string& table : info.tables) cases.push_back({info.name, table});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(All, EveryTable, testing::ValuesIn(all_tables()),
                         [](const auto& method) { return method.param.table; });

}  // namespace
}  // namespace creepcontact::ode
