/// Evaluations are values: what is evaluated in between, for output or by other threads, changes no bit.

#include <random>
#include <thread>

#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

struct Point {
  double t;
  std::vector<double> y;
};

/// States along one path, as an integrator meets them.
std::vector<Point> path(const System& system, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-0.3, 0.3);
  std::vector<Point> points;
  std::vector<double> y(system.rate.size(), 0.0);
  for (int i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < y.size(); ++k) y[k] += number(generator) * system.rate.scale()[k];
    points.push_back({0.5 * i + 0.1 * seed, y});
  }
  return points;
}

std::vector<double> rate_at(System& system, const Point& point) {
  std::vector<double> rate(point.y.size());
  system.rate.rate(point.t, point.y, rate);
  return rate;
}

/// Loads, gap and temperature that change in time; part of the contact is open.
const std::vector<std::string> moving{"contacts.0.gap='0.03*x-0.01*cos(t)'",
                                      "supports.3.displacement.z='-0.01*(1+t/3)'",
                                      "temperature.value='100+10*z*sin(t)'", "materials.soft.creep.0.A='1e-5*T'"};

class Purity : public testing::TestWithParam<const char*> {
 protected:
  config::Config config() const {
    std::vector<std::string> overrides = moving;
    const std::string method = GetParam();
    if (method == "friction" || method == "tresca") {
      overrides.insert(overrides.end(), {"contacts.0.friction='0.1+0.02*t'",
                                         "loads=[{on='upper_bottom',body='upper',traction=['0.02*t',0,0]}]"});
      if (method == "tresca") overrides.emplace_back("contact_solver.friction=tresca");
    } else {
      overrides.push_back("contact_solver.method=" + method);
    }
    return blocks_.config("", overrides);
  }

 private:
  Case blocks_;
};

TEST_P(Purity, InterleavedSequencesHaveTheBitsOfEachAlone) {
  const config::Config of = config();
  System first(of), second(of), both(of);
  // Solvers of their own for the two histories, one for both.
  History one = first.solver.new_history(), other = second.solver.new_history();
  History mixed_one = both.solver.new_history(), mixed_other = both.solver.new_history();
  const std::vector<Point> a = path(first, 1), b = path(first, 2);
  const auto solve = [](System& system, const Point& at, History& history) {
    std::vector<mechanics::CreepStrainView> creep;
    system.rate.layout().views(at.y, creep);
    Equilibrium result;
    system.solver.solve(at.t, creep, history, result);
    system.solver.accept(result, creep, history);
    return result;
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Equilibrium of_a = solve(both, a[i], mixed_one), of_b = solve(both, b[i], mixed_other);
    const Equilibrium alone_a = solve(first, a[i], one), alone_b = solve(second, b[i], other);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(of_a.bodies[k].stress, alone_a.bodies[k].stress) << i;
      EXPECT_EQ(of_a.bodies[k].displacement, alone_a.bodies[k].displacement) << i;
      EXPECT_EQ(of_b.bodies[k].stress, alone_b.bodies[k].stress) << i;
    }
    EXPECT_EQ(of_a.contact.multiplier, alone_a.contact.multiplier) << i;
    EXPECT_EQ(of_b.gaps, alone_b.gaps) << i;
  }
}

TEST_P(Purity, OutputsBetweenEvaluationsChangeNothing) {
  const config::Config of = config();
  System plain(of), watched(of);
  const std::vector<Point> steps = path(plain, 1), outputs = path(plain, 2);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(rate_at(watched, steps[i]), rate_at(plain, steps[i])) << i;
    watched.rate.evaluate_output(outputs[i].t, outputs[i].y);
    for (System* system : {&plain, &watched}) system->rate.accept(steps[i].t, steps[i].y);
    watched.rate.evaluate_output(outputs[i].t, steps[i].y);
  }
  EXPECT_EQ(std::vector<double>(watched.rate.scale().begin(), watched.rate.scale().end()),
            std::vector<double>(plain.rate.scale().begin(), plain.rate.scale().end()));
}

/// From the second evaluation on they are computed with the rate.
TEST_P(Purity, TangentsAreTheSameWithTheRateAndWithoutIt) {
  const config::Config of = config();
  System plain(of), asked(of);
  const std::vector<Point> steps = path(plain, 1);
  const auto preconditioned = [](System& system, const Point& at) {
    system.rate.prepare_preconditioner(at.t, at.y);
    std::vector<double> result(at.y.size());
    system.rate.precondition(0.3, at.y, result);
    std::vector<double> once(at.y.size());
    system.rate.precondition_once(at.t, at.y, 0.3, at.y, once);
    EXPECT_EQ(once, result);
    return result;
  };
  for (const Point& step : steps) {
    EXPECT_EQ(rate_at(asked, step), rate_at(plain, step));
    const double stable = asked.rate.stable_step(step.t, step.y);
    EXPECT_EQ(stable, plain.rate.stable_step(step.t, step.y));
    EXPECT_EQ(preconditioned(asked, step), preconditioned(plain, step));
    plain.rate.forget_evaluations();
    EXPECT_EQ(plain.rate.stable_step(step.t, step.y), stable);
    rate_at(plain, step);
    rate_at(plain, step);  // nothing asked for tangents in between
    for (System* system : {&plain, &asked}) system->rate.accept(step.t, step.y);
  }
}

TEST_P(Purity, ThreadsShareAnAssembly) {
  const config::Config of = config();
  System system(of);
  const std::vector<Point> points[2] = {path(system, 1), path(system, 2)};
  std::vector<std::vector<double>> alone[2], together[2];
  const auto rates = [&](const std::vector<Point>& along, std::vector<std::vector<double>>& into) {
    Stopwatch watch;
    EquilibriumSolver solver(system.model.assembly, system.model.solver, watch);
    CreepSystem own(solver, survey_elastic_stress(solver, of.time.output, system.model.breakpoints), of.time.tolerance,
                    watch);
    for (const Point& at : along) {
      into.emplace_back(at.y.size());
      own.rate(at.t, at.y, into.back());
      own.accept(at.t, at.y);
    }
  };
  for (const int k : {0, 1}) rates(points[k], alone[k]);
  std::thread other([&] { rates(points[1], together[1]); });
  rates(points[0], together[0]);
  other.join();
  for (const int k : {0, 1}) EXPECT_EQ(together[k], alone[k]) << k;
}

INSTANTIATE_TEST_SUITE_P(Methods, Purity, testing::Values("schwarz", "active_set", "friction", "tresca"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace creepcontact::run::test
