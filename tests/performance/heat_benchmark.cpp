/// Runs of a block whose temperature is computed. Counters:
///   of_the_rest       what the computation of the temperature adds, over the rest of the run
///   of_a_given_field  the time over that of a run with a field that is similar, but makes other stresses
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/writer.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"
#include "unit/io/temporary_directory.hpp"

namespace creepcontact::test {
namespace {

io::Summary run_once(const config::Config& config) {
  const io::test::TemporaryDirectory directory;
  run::run(config, {.output = directory.path().string()});
  return *io::read_summary(directory.path() / "summary.json");
}

void heated_block(benchmark::State& state) {
  const std::vector<std::string> sizes{fmt::format("mesh.parameters.n={}", state.range(0))};
  const config::Config heated = config::read(CREEPCONTACT_HEATED_BLOCK, run::vocabulary(), sizes);
  config::Config given = heated;
  given.heat.reset();
  given.temperature.emplace().value = Function::expression("20 + min(t/4, 1)*(507 - 13*x)", {"x", "y", "z", "t"});
  config::complete(given, run::vocabulary());
  omp_set_num_threads(static_cast<int>(state.range(1)));
  for ([[maybe_unused]] auto _ : state) {
    const auto prepare = [](const config::Config& config) {
      return min_seconds(1, [&] { benchmark::DoNotOptimize(model::build_model(config)); });
    };
    const double added = prepare(heated) - prepare(given);
    const io::Summary floor = run_once(given), summary = run_once(heated);
    state.counters["unknowns"] = static_cast<double>(summary.bodies.begin()->second.dofs);
    state.counters["of_the_rest"] = added / (summary.wall_seconds.total - added);
    state.counters["of_a_given_field"] = summary.wall_seconds.total / floor.wall_seconds.total;
    state.counters["solves"] = static_cast<double>(summary.elastic_solves);
  }
}
BENCHMARK(heated_block)->ArgsProduct({{8, 14}, {1, 2}})->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace creepcontact::test

int main(int argc, char** argv) {
  creepcontact::test::run_benchmarks(argc, argv);
}
