/// Samples of creep constants as an ensemble, whose passes through the factors are gathered, against single runs.
/// Processor time of the whole process. Counters:
///   of_single_runs   the time of all samples over as many times that of a run on its own (the mean of some of them)
///   vectors          for which a pass is made, in the mean: at most the samples at a time
///   of_the_floor     the time over that of one thread that reads the factors once per gathered pass
///   difference       the largest of the last values of the probes of those runs, relative to the value
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "creepcontact/base/log.hpp"
#include "creepcontact/base/thread_count.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/results_in_memory.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"

namespace creepcontact::test {
namespace {

double processor_seconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Case {
  const char* file;
  std::vector<std::string> settings;
  std::vector<std::pair<std::string, double>> constants;  // with their medians
};

std::vector<Case> cases() {
  return {{CREEPCONTACT_CONFIGS "/bolted_flange.toml",
           {},
           {{"materials.bolt_steel.creep[0].A", 9.1e-26}, {"materials.flange_steel.creep[0].A", 8.2e-21}}},
          {CREEPCONTACT_CONFIGS "/ball_on_block.toml",
           {"mesh.parameters.h=0.16", "time.tolerance=1e-3"},
           {{"materials.solder.creep[0].A", 1e-14}, {"materials.copper.creep[0].A", 1e-17}}}};
}

/// Sample i of n: a factor of two for one standard deviation, at the quantiles (i + 1/2)/n of a logistic distribution.
double factor_of(std::size_t i, std::size_t n) {
  const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
  return std::pow(2.0, std::log(p / (1 - p)) / 1.8);
}

config::Config sample(const Case& of, std::size_t i, std::size_t n) {
  std::vector<std::string> settings = of.settings;
  settings.emplace_back("output.fields=false");
  for (const auto& [key, median] : of.constants)
    settings.push_back(fmt::format("{}={}", key, median * factor_of(i, n)));
  return config::read(of.file, run::vocabulary(), settings);
}

std::vector<double> last_probes(const config::Config& config, run::Kept* kept) {
  run::ResultsInMemory results(config);
  const run::Summary summary =
      run::run(config, {.output = {}, .writes_files = false, .kept = kept, .observers = {&results}});
  if (summary.exit_status != 0) throw std::runtime_error(summary.message);
  const std::vector<double>& values = results.probe_values();
  return {values.end() - static_cast<std::ptrdiff_t>(config.probes.size()), values.end()};
}

void ensemble(benchmark::State& state) {
  const Case of = cases()[static_cast<std::size_t>(state.range(0))];
  const auto n = static_cast<std::size_t>(state.range(1)), at_once = static_cast<std::size_t>(state.range(2));
  const std::size_t n_single = 4;
  const ThreadCount one(1);
  log::set_level(log::Level::error);
  std::vector<std::vector<double>> single;
  const double before_single = processor_seconds();
  for (std::size_t k = 0; k < n_single; ++k)
    single.push_back(last_probes(sample(of, k * n / n_single + n / (2 * n_single), n), nullptr));
  const double of_single = (processor_seconds() - before_single) / static_cast<double>(n_single);
  for ([[maybe_unused]] auto _ : state) {
    run::Kept kept;
    std::vector<std::vector<double>> values(n);
    std::vector<std::function<void()>> jobs;
    for (std::size_t i = 0; i < n; ++i) jobs.emplace_back([&, i] { values[i] = last_probes(sample(of, i, n), &kept); });
    const double before = processor_seconds();
    kept.passes.run(jobs, at_once);
    const double seconds = processor_seconds() - before;
    const auto counters = kept.passes.counters();
    double difference = 0;
    for (std::size_t k = 0; k < n_single; ++k)
      for (std::size_t p = 0; p < single[k].size(); ++p)
        difference =
            std::max(difference, std::abs(values[k * n / n_single + n / (2 * n_single)][p] / single[k][p] - 1));
    state.counters["single_seconds"] = of_single;
    state.counters["of_single_runs"] = seconds / (of_single * static_cast<double>(n));
    state.counters["vectors"] = static_cast<double>(counters.vectors) / static_cast<double>(counters.passes);
    state.counters["difference"] = difference;
  }
}
BENCHMARK(ensemble)->Args({0, 64, 16})->Args({0, 64, 1})->Args({1, 16, 16})->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace creepcontact::test

int main(int argc, char** argv) {
  creepcontact::test::run_benchmarks(argc, argv);
}
