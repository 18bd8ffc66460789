/// Axisymmetric sections. `evaluation`: one rate of the shrink fit against its floor, a pass through the factors and
/// the two element loops, measured in the same run. `fit`: the processor time from the assembly to 1e6 h, without
/// meshing and output, over that of the solid (configs/shrink_fit.toml).
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <ctime>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"

namespace creepcontact::test {
namespace {

config::Config ring_fit(int n) {
  return config::read(CREEPCONTACT_RING_FIT, run::vocabulary(), {fmt::format("mesh.parameters={{n={}}}", n)});
}

double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void evaluation(benchmark::State& state) {
  omp_set_num_threads(1);
  const config::Config config = ring_fit(static_cast<int>(state.range(0)));
  Stopwatch watch;
  const model::Model model = model::build_model(config);
  creep::EquilibriumSolver solver(model.assembly, model.solver, watch);
  creep::CreepSystem system(solver, creep::survey_elastic_stress(solver, config.time.output, model.breakpoints),
                            config.time.tolerance, watch);
  std::vector<double> y(system.size()), rate(system.size());
  system.rate(0, y, rate);
  system.accept(0, y);
  double least = 1e300, floor = 1e300, unknowns = 0;
  std::vector<std::vector<double>> vectors, stresses;
  std::vector<mechanics::CreepStrainView> creep;
  std::vector<std::unique_ptr<linalg::StiffnessSolver>> factors;
  std::vector<mechanics::BodyConditions> conditions;
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const mechanics::Body& body = model.bodies()[b];
    conditions.push_back(body.at(0));
    vectors.emplace_back(body.constraints().n_free());
    stresses.emplace_back(6 * body.discretization().n_points());
    unknowns += static_cast<double>(vectors.back().size());
    factors.push_back(solver.interface().factored(b).solver().same_pattern());
    factors.back()->factorize(solver.interface().factored(b).stiffness(conditions.back()));
  }
  const auto work = [&] {
    system.layout().views(y, creep);
    for (std::size_t b = 0; b < model.bodies().size(); ++b) {
      const mechanics::Body& body = model.bodies()[b];
      body.right_hand_side(conditions[b], creep[b], vectors[b]);
      factors[b]->forward(vectors[b], vectors[b]);
      factors[b]->backward(vectors[b], vectors[b]);
      std::vector<double> u(3 * body.mesh().nodes.size());
      body.constraints().expand(vectors[b], conditions[b].prescribed, u);
      body.discretization().stress(u, conditions[b].elastic(), creep[b], stresses[b]);
    }
  };
  for ([[maybe_unused]] auto _ : state) {
    floor = std::min(floor, min_seconds(1, work));
    y[0] += 1e-12;  // another point: the last one is kept
    least = std::min(least, min_seconds(1, [&] { system.rate(0, y, rate); }));
  }
  state.counters["unknowns"] = unknowns;
  state.counters["of_the_floor"] = least / floor;
}
BENCHMARK(evaluation)->Arg(1)->Arg(8)->Arg(32)->Unit(benchmark::kMillisecond);

/// Processor time of the time integration and all that it needs.
double integrate(const config::Config& config, const model::Model& model) {
  const double start = processor_seconds();
  Stopwatch watch;
  creep::EquilibriumSolver solver(model.assembly, model.solver, watch);
  creep::CreepSystem system(solver, creep::survey_elastic_stress(solver, config.time.output, model.breakpoints),
                            config.time.tolerance, watch);
  const auto integrator = ode::make_integrator(config.time.integrator, system,
                                               {.tolerance = config.time.tolerance, .end_time = config.time.end});
  integrator->initialize(0, std::vector<double>(system.size()));
  while (integrator->time() < config.time.end) integrator->step(config.time.end);
  return processor_seconds() - start;
}

void fit(benchmark::State& state) {
  omp_set_num_threads(1);
  const config::Config ring = ring_fit(1);
  const config::Config solid = config::read(CREEPCONTACT_CONFIGS "/shrink_fit.toml", run::vocabulary(), {});
  const model::Model ring_model = model::build_model(ring), solid_model = model::build_model(solid);
  double of_ring = 1e300, of_solid = 1e300;
  for ([[maybe_unused]] auto _ : state) {
    of_ring = std::min(of_ring, integrate(ring, ring_model));
    of_solid = std::min(of_solid, integrate(solid, solid_model));
  }
  state.counters["ring_seconds"] = of_ring;
  state.counters["of_the_solid"] = of_ring / of_solid;
}
BENCHMARK(fit)->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace
}  // namespace creepcontact::test

BENCHMARK_MAIN();
