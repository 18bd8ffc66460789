/// One contact solve against one pass through the factors it is condensed from: two blocks of 75,000 unknowns each with
/// 1521 multipliers between them. The counters are ratios measured in one run: `of_a_pass` to a forward and a backward
/// pass through both factors, `of_the_floor` to the time in which memory hands over both factors twice.
#include <benchmark/benchmark.h>

#include <numeric>

#include "performance/measuring.hpp"
#include "support/contact/boxes.hpp"

namespace creepcontact::test {
namespace {

class Scene {
 public:
  Scene() {
    constexpr int side = 38;
    const BoxSetup block{.divisions = {side, side, 15}, .lengths = {1, 1, 0.4}, .distortion = 0.1};
    // The faces overlap but for one corner.
    assembly_ = std::make_unique<Boxes>(block, block, true, -0.01, contact::ContactType::unilateral,
                                        Function::expression("0.001*(x + y - 1.5)", {"x", "y", "z", "t"}));
    load_ = assembly_->interface().balance().contact_load(
        assembly_->interface().rows().initial_load(0, conditions(assembly_->bodies(), 0)));
    later_ = load_;
    later_.gap.array() *= 1.001;
    for (const mechanics::Body& body : assembly_->bodies()) vectors_.emplace_back(body.constraints().n_free(), 1.0);
    pass_ = min_seconds(5, [&] { pass(); });
    floor_ = 2 * static_cast<double>(factor_bytes()) / bandwidth();
  }

  void pass() {
    for (std::size_t b = 0; b < vectors_.size(); ++b) {
      assembly_->interface().factored(b).solver().forward(vectors_[b], vectors_[b]);
      assembly_->interface().factored(b).solver().backward(vectors_[b], vectors_[b]);
    }
  }
  std::int64_t factor_bytes() const {
    std::int64_t bytes = 0;
    for (std::size_t b = 0; b < vectors_.size(); ++b)
      bytes += assembly_->interface().factored(b).solver().factor_bytes();
    return bytes;
  }
  const contact::ContactProblem& problem() const { return assembly_->interface().problem(); }
  const contact::ContactLoad& load() const { return load_; }
  const contact::ContactLoad& later() const { return later_; }

  void count(benchmark::State& state, double seconds) const {
    state.counters["of_a_pass"] = seconds / pass_;
    state.counters["of_the_floor"] = seconds / floor_;
  }

 private:
  std::unique_ptr<Boxes> assembly_;
  contact::ContactLoad load_, later_;
  std::vector<std::vector<double>> vectors_;
  double pass_ = 0, floor_ = 0;
};

Scene& scene() {
  static Scene scene;
  return scene;
}

template <typename Work>
void measure(benchmark::State& state, const Work& work) {
  double total = 0;
  for ([[maybe_unused]] auto _ : state) {
    const auto start = Clock::now();
    work();
    total += seconds_since(start);
  }
  scene().count(state, total / static_cast<double>(state.iterations()));
}

void pass(benchmark::State& state) {
  Scene& s = scene();
  measure(state, [&] { s.pass(); });
  state.counters["factor_MB"] = static_cast<double>(s.factor_bytes()) / 1e6;
}
BENCHMARK(pass)->Unit(benchmark::kMillisecond);

/// As within a time step: from the last accepted state to one nearby, with the same set.
void warm(benchmark::State& state, std::unique_ptr<contact::ContactSolver> solver) {
  Scene& s = scene();
  const contact::ContactState start = solver->solve(s.load(), {}).state;
  contact::ContactResult result = solver->solve(s.later(), start);
  measure(state, [&] { result = solver->solve(s.later(), start); });
  state.counters["multipliers"] = static_cast<double>(s.problem().n_rows());
  state.counters["active"] = static_cast<double>(result.state.active.size());
  state.counters["iterations"] = result.iterations;
  state.counters["sets"] = result.set_changes;
}
void warm_schwarz(benchmark::State& state) {
  warm(state, contact::schwarz_solver(scene().problem(), {}));
}
BENCHMARK(warm_schwarz)->Unit(benchmark::kMillisecond);
void warm_active_set(benchmark::State& state) {
  warm(state, contact::active_set_solver(scene().problem()));
}
BENCHMARK(warm_active_set)->Unit(benchmark::kMillisecond);

/// Without a warm start, factorisations included.
void cold(benchmark::State& state, std::unique_ptr<contact::ContactSolver> (*make)()) {
  contact::ContactResult result;
  measure(state, [&] { result = make()->solve(scene().load(), {}); });
  state.counters["iterations"] = result.iterations;
  state.counters["sets"] = result.set_changes;
}
void cold_schwarz(benchmark::State& state) {
  cold(state, [] { return contact::schwarz_solver(scene().problem(), {}); });
}
BENCHMARK(cold_schwarz)->Unit(benchmark::kMillisecond);
void cold_active_set(benchmark::State& state) {
  cold(state, [] { return contact::active_set_solver(scene().problem()); });
}
BENCHMARK(cold_active_set)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace creepcontact::test

BENCHMARK_MAIN();
