/// Whole runs of a ball on a block at four sizes: mesh, factors, time integration and results. Counters:
///   of_the_floor   the time of the run over that of the factorisation and of one thread that reads the factors twice
///                  per elastic solve
///   passes, points, contact, results, rest   shares of the run without the factorisation; rest: vectors of the
///                  integrator, mesh and model
///   memory         the largest resident memory over the bytes of the factors and 14 state vectors; of the sizes so far
///   of_one_thread  the time over that of the run on one thread
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <map>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::test {
namespace {

/// @param size  of the small elements, in thousandths
config::Config ball_on_block(std::int64_t size) {
  return config::read(CREEPCONTACT_CONFIGS "/ball_on_block.toml", run::vocabulary(),
                      {fmt::format("mesh.parameters.h={}", static_cast<double>(size) / 1000), "time.tolerance=1e-3"});
}

io::Summary run_once(std::int64_t size) {
  const io::test::TemporaryDirectory directory;
  run::run(ball_on_block(size), {.output = directory.path().string()});
  return *io::read_summary(directory.path() / "summary.json");
}

/// Bytes of all factors.
double factor_bytes(std::int64_t size) {
  const model::Model model = model::build_model(ball_on_block(size));
  double bytes = 0;
  for (const mechanics::Body& body : model.bodies())
    bytes += static_cast<double>(mechanics::FactoredBody(body, body.at(0), {}).solver().factor_bytes());
  return bytes;
}

void ball_on_block(benchmark::State& state) {
  static std::map<std::int64_t, double> of_one_thread;
  const std::int64_t size = state.range(0), threads = state.range(1);
  const double factors = factor_bytes(size), reading = 2 * factors / bandwidth();
  omp_set_num_threads(static_cast<int>(threads));
  for ([[maybe_unused]] auto _ : state) {
    const io::Summary summary = run_once(size);
    const io::Summary::WallSeconds& seconds = summary.wall_seconds;
    const auto of = [&](Part part) { return seconds.parts[static_cast<std::size_t>(part)]; };
    if (threads == 1) of_one_thread[size] = seconds.total;
    const auto solves = static_cast<double>(summary.elastic_solves);
    const double integration = seconds.total - of(Part::factorize);
    double unknowns = 0, state_bytes = 0;
    for (const auto& [name, body] : summary.bodies) {
      unknowns += static_cast<double>(body.dofs);
      state_bytes += 6.0 * 8 * static_cast<double>(body.integration_points);
    }
    state.counters["unknowns"] = unknowns;
    state.counters["solves"] = solves;
    state.counters["of_the_floor"] = seconds.total / (of(Part::factorize) + solves * reading);
    state.counters["passes"] = of(Part::solve) / integration;
    state.counters["points"] = of(Part::material) / integration;
    state.counters["contact"] = of(Part::contact) / integration;
    state.counters["results"] = of(Part::output) / integration;
    state.counters["rest"] =
        1 - (of(Part::solve) + of(Part::material) + of(Part::contact) + of(Part::output)) / integration;
    state.counters["memory"] = summary.peak_memory_mb * (1 << 20) / (factors + 14 * state_bytes);
    if (of_one_thread.contains(size)) state.counters["of_one_thread"] = seconds.total / of_one_thread[size];
  }
}
BENCHMARK(ball_on_block)
    ->ArgsProduct({{300, 160, 120, 95}, {1, 2}})  // 13, 44, 79 and 140 thousand unknowns; threads
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace
}  // namespace creepcontact::test

int main(int argc, char** argv) {
  creepcontact::test::run_benchmarks(argc, argv);
}
