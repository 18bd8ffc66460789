/// A state that several processes hold in parts is integrated as a whole: the same steps, the same solution.

#include <cmath>

#include "../base/thread_team.hpp"
#include "every_integrator.hpp"

namespace creepcontact::ode {
namespace {

/// ParallelBars dealt out among the members of a team: the mean strain couples them.
class DealtBars final : public TestSystem {
 public:
  static constexpr double E = 2e5, n = 5, mean_stress = 100;
  static constexpr std::size_t bars = 7;

  /// @param first, count  the bars of this member
  DealtBars(const Team& team, std::size_t first, std::size_t count) : TestSystem(count, mean_stress / E), team_(team) {
    for (std::size_t i = first; i < first + count; ++i)
      A_.push_back(1e-14 * std::pow(30.0, static_cast<double>(i) / static_cast<double>(bars - 1)));
  }
  const Team& team() const override { return team_; }
  NewtonSolver* newton_solver() override { return nullptr; }
  double stable_step(double t, std::span<const double> y) override {
    return team_.min(y.empty() ? (local(t, y, {}), std::numeric_limits<double>::infinity())
                               : TestSystem::stable_step(t, y));
  }

 protected:
  void f(double, std::span<const double> y, std::span<double> rate) const override {
    const Values s = stress(y);
    for (std::size_t i = 0; i < y.size(); ++i) rate[i] = A_[i] * std::pow(std::abs(s[i]), n - 1) * s[i];
  }
  void df(double t, std::span<const double> y, std::span<const double> v, std::span<double> product) const override {
    local(t, y, product);
    const double mean = mean_of_all(v);
    for (std::size_t i = 0; i < v.size(); ++i) product[i] *= v[i] - mean;
  }
  void local(double, std::span<const double> y, std::span<double> diagonal) const override {
    const Values s = stress(y);
    for (std::size_t i = 0; i < y.size(); ++i) diagonal[i] = -E * n * A_[i] * std::pow(std::abs(s[i]), n - 1);
  }

 private:
  double mean_of_all(std::span<const double> y) const {
    double sum = 0;
    for (const double value : y) sum += value;
    return team_.sum(sum) / bars;
  }
  Values stress(std::span<const double> y) const {
    const double mean = mean_of_all(y);
    Values s;
    for (const double e : y) s.push_back(mean_stress + E * (mean - e));
    return s;
  }

  const Team& team_;
  Values A_;
};

struct Course {
  Values steps, errors, outputs;
};

Course integrate_part(const std::string& variant, const Team& team, std::size_t first, std::size_t count) {
  DealtBars system(team, first, count);
  const auto integrator = make_variant(variant, system, accurate_options(variant, 1e-2));
  integrator->initialize(0, Values(count, 0.0));
  Course course;
  Values y(count);
  for (const double t : {1.0, 3.0, 10.0}) {
    while (integrator->time() < t) {
      const StepReport report = integrator->step(10);
      course.steps.push_back(report.step);
      course.errors.push_back(report.error_estimate);
    }
    integrator->interpolate(t, y);
    course.outputs.insert(course.outputs.end(), y.begin(), y.end());
  }
  return course;
}

void expect_alike(const Values& a, const Values& b, double relative) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], relative * std::abs(b[i]) + 1e-14) << i;
}

class TeamOfIntegrators : public EveryIntegrator {};

TEST_P(TeamOfIntegrators, TakesTheStepsOfASingleProcess) {
  const Course alone = integrate_part(GetParam(), serial_team(), 0, DealtBars::bars);
  // The last deal leaves a member without any bar.
  for (const std::vector<std::size_t>& counts : {std::vector<std::size_t>{4, 3}, {3, 0, 2, 2}}) {
    const int n = static_cast<int>(counts.size());
    std::vector<Course> parts(n);
    on_team(n, [&](const Team& team) {
      std::size_t first = 0;
      for (int r = 0; r < team.rank(); ++r) first += counts[r];
      parts[team.rank()] = integrate_part(GetParam(), team, first, counts[team.rank()]);
    });
    Values outputs;
    for (std::size_t time = 0; time < 3; ++time)
      for (int r = 0; r < n; ++r)
        outputs.insert(outputs.end(), parts[r].outputs.begin() + time * counts[r],
                       parts[r].outputs.begin() + (time + 1) * counts[r]);
    for (const Course& part : parts) {
      EXPECT_EQ(part.steps, parts[0].steps) << "all members make the same steps, to the last bit";
      EXPECT_EQ(part.errors, parts[0].errors);
    }
    expect_alike(parts[0].steps, alone.steps, 1e-6);
    expect_alike(outputs, alone.outputs, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(All, TeamOfIntegrators, testing::ValuesIn(all_names()), test_name);

}  // namespace
}  // namespace creepcontact::ode
