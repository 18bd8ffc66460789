/// A creep rate and a Jacobian product of two blocks in contact against the passes through the factors that they
/// contain. Counters are ratios measured in one run: `of_a_pass` to a forward and a backward pass through all factors
/// on one thread, `of_the_floor` to the time in which one thread reads the factors twice.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <map>
#include <string>
#include <vector>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/model/step_guard.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"

namespace creepcontact::test {
namespace {

/// Pressed blocks with so many elements along the sides of the upper block.
config::Config pressed_blocks(int n, std::vector<std::string> overrides = {}) {
  overrides.push_back(fmt::format("mesh.parameters={{n_lower={},n_upper={}}}", n * 5 / 4, n));
  return config::read(CREEPCONTACT_CONFIGS "/pressed_blocks.toml", run::vocabulary(), overrides);
}

class Scene {
 public:
  explicit Scene(int n)
      : config_(pressed_blocks(n)),
        model_(model::build_model(config_)),
        solver_(model_.assembly, model_.solver, watch_),
        system_(solver_, creep::survey_elastic_stress(solver_, config_.time.output, model_.breakpoints),
                config_.time.tolerance, watch_),
        state_(system_.size()),
        rate_(system_.size()) {
    for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
      vectors_.emplace_back(model_.bodies()[b].constraints().n_free(), 1.0);
      factors_.push_back(solver_.interface().factored(b).solver().same_pattern());
      const mechanics::BodyConditions at = model_.bodies()[b].at(0);
      factors_.back()->factorize(solver_.interface().factored(b).stiffness(at));
      bytes_ += static_cast<double>(factors_.back()->factor_bytes());
      unknowns_ += static_cast<double>(vectors_.back().size());
    }
    system_.rate(0, state_, rate_);  // contact from scratch
    system_.accept(0, state_);
    floor_ = 2 * bytes_ / bandwidth();
    pass_ = min_seconds(7, [&] { pass(); });
  }

  void pass() {
    for (std::size_t b = 0; b < vectors_.size(); ++b) {
      factors_[b]->forward(vectors_[b], vectors_[b]);
      factors_[b]->backward(vectors_[b], vectors_[b]);
    }
  }
  void rate() {
    state_[0] += 1e-12;  // another point: the last one is kept
    system_.rate(0, state_, rate_);
  }
  void product() { system_.jacobian_times(0, state_, state_, rate_); }

  void count(benchmark::State& state, double seconds) const {
    state.counters["unknowns"] = unknowns_;
    state.counters["of_a_pass"] = seconds / pass_;
    state.counters["of_the_floor"] = seconds / floor_;
    state.counters["factor_MB"] = bytes_ / 1e6;
  }

 private:
  config::Config config_;
  Stopwatch watch_;
  model::Model model_;
  creep::EquilibriumSolver solver_;
  creep::CreepSystem system_;
  std::vector<std::unique_ptr<linalg::StiffnessSolver>> factors_;
  std::vector<double> state_, rate_;
  std::vector<std::vector<double>> vectors_;
  double bytes_ = 0, unknowns_ = 0, pass_ = 0, floor_ = 0;
};

Scene& scene(int n) {
  static std::map<int, Scene> scenes;
  return scenes.try_emplace(n, n).first->second;
}

template <typename Work>
void measure(benchmark::State& state, Work work) {
  omp_set_num_threads(static_cast<int>(state.range(1)));
  Scene& s = scene(static_cast<int>(state.range(0)));
  double least = 1e300;
  for ([[maybe_unused]] auto _ : state) least = std::min(least, min_seconds(1, [&] { work(s); }));
  s.count(state, least);
}
void pass(benchmark::State& state) {
  measure(state, [](Scene& s) { s.pass(); });
}
void rate(benchmark::State& state) {
  measure(state, [](Scene& s) { s.rate(); });
}
void product(benchmark::State& state) {
  measure(state, [](Scene& s) { s.product(); });
}
/// What model::StepGuard takes before a step, for four functions of time; counter `of_a_rate`: the least that a step
/// costs.
void guard(benchmark::State& state) {
  omp_set_num_threads(1);
  const int n = static_cast<int>(state.range(0));
  const double rate = min_seconds(5, [&] { scene(n).rate(); });
  const config::Config config = pressed_blocks(
      n, {"supports[1].displacement.z=\"-0.02*(1 + 0.01*sin(t/3e3))\"", "contacts[0].gap=\"1e-5*x*exp(-t/2e3)\"",
          "materials.steel.creep[0].A=\"1e-14*(1 + 0.1*exp(-(T - 20)/300))\"",
          "temperature={value=\"500 + 0.3*x + 20*exp(-t/4e3)\"}"});
  const model::Model model = model::build_model(config);
  const model::StepGuard of_model(model::courses_in_time(config, model), config.time.end, config.time.tolerance);
  double t = 0, least = 1e300;
  for ([[maybe_unused]] auto _ : state)
    least = std::min(least, min_seconds(1, [&] {
                       t += 1;
                       for (std::size_t i = 0; i < of_model.courses().size(); ++i)
                         benchmark::DoNotOptimize(of_model.examine(i, t, t + 300, {0, config.time.end}));
                     }));
  state.counters["functions"] = static_cast<double>(of_model.courses().size());
  state.counters["of_a_rate"] = least / rate;
}
const std::vector<std::vector<std::int64_t>> cases{{10, 15}, {1, 2}};  // 50,000 and 150,000 unknowns; threads
BENCHMARK(pass)->ArgsProduct({{10, 15}, {1}})->Unit(benchmark::kMillisecond);
BENCHMARK(rate)->ArgsProduct(cases)->Unit(benchmark::kMillisecond);
BENCHMARK(guard)->Arg(2)->Arg(4)->Arg(10)->Unit(benchmark::kMicrosecond);
BENCHMARK(product)->ArgsProduct(cases)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace creepcontact::test

BENCHMARK_MAIN();
