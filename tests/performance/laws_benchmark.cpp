/// What laws add to one rate of the shrink fit as an axisymmetric section, over the rate without them, in turn in the
/// same run: plasticity where nothing yields, and a gasket between the surfaces.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <memory>
#include <string>
#include <vector>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"

namespace creepcontact::test {
namespace {

/// A model ready for rates at t = 0.
class Fit {
 public:
  Fit(int n, const std::vector<std::string>& more)
      : config_(config::read(CREEPCONTACT_RING_FIT, run::vocabulary(), settings(n, more))),
        model_(model::build_model(config_)),
        solver_(model_.assembly, model_.solver, watch_),
        system_(solver_, creep::survey_elastic_stress(solver_, config_.time.output, model_.breakpoints),
                config_.time.tolerance, watch_),
        y_(system_.size()),
        rate_(system_.size()) {
    system_.rate(0, y_, rate_);
    system_.accept(0, y_);
  }
  double seconds() {
    y_[0] += 1e-12;  // another point: the last one is kept
    return min_seconds(1, [&] { system_.rate(0, y_, rate_); });
  }
  double unknowns() const { return static_cast<double>(system_.size()); }

 private:
  static std::vector<std::string> settings(int n, std::vector<std::string> more) {
    more.push_back(fmt::format("mesh.parameters={{n={}}}", n));
    return more;
  }
  Stopwatch watch_;
  config::Config config_;
  model::Model model_;
  creep::EquilibriumSolver solver_;
  creep::CreepSystem system_;
  std::vector<double> y_, rate_;
};

void compare(benchmark::State& state, const std::vector<std::string>& more) {
  omp_set_num_threads(1);
  const auto n = static_cast<int>(state.range(0));
  Fit without(n, {}), with(n, more);
  double least_with = 1e300, least_without = 1e300;
  for ([[maybe_unused]] auto _ : state) {
    least_without = std::min(least_without, without.seconds());
    least_with = std::min(least_with, with.seconds());
  }
  state.counters["states"] = without.unknowns();
  state.counters["of_without"] = least_with / least_without;
}

void elastic_range(benchmark::State& state) {
  compare(state, {"materials.rotor.plasticity={yield_stress=1e6}",
                  "materials.wheel.plasticity={yield_stress=1e6,kinematic=[{C=1e4,gamma=100}]}"});
}
BENCHMARK(elastic_range)->Arg(1)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

void gasket(benchmark::State& state) {
  compare(state, {"gaskets.foil={thickness=0.1,loading={closure=[0,0.02,0.1],pressure=[0,100,2000]},"
                  "unloading={from=[50,500],modulus=[2e4,1e5]}}",
                  "contacts[0].gasket=foil"});
}
BENCHMARK(gasket)->Arg(1)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace creepcontact::test

BENCHMARK_MAIN();
