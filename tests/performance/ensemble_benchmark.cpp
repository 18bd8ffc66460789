/// Samples of creep constants as an ensemble, whose passes through the factors are gathered, against runs of the
/// program, each in a process of its own. Both write their files. Processor time of all processes, meshers included.
/// Counters:
///   single_seconds   of a run of the program, the mean of some of the samples
///   sample_seconds   of a sample of the ensemble, the mean of all
///   of_single_runs   the second over the first
///   vectors          for which a pass is made, in the mean: at most the samples at a time
///   of_the_floor     the time of the ensemble over that of its passes alone
///   difference       the largest of the last values of the probes of those runs, relative to the value
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "creepcontact/base/log.hpp"
#include "creepcontact/base/thread_count.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"

namespace creepcontact::test {
namespace {

namespace fs = std::filesystem;

/// Of this process and those that it has waited for.
double processor_seconds() {
  double sum = 0;
  for (const auto of : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(of, &used);
    for (const timeval& part : {used.ru_utime, used.ru_stime})
      sum += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
  }
  return sum;
}

struct Case {
  const char* file;
  std::vector<std::string> settings;
  std::vector<std::pair<std::string, double>> constants;  // with their medians
};

std::vector<Case> cases() {
  const Case flange{CREEPCONTACT_CONFIGS "/bolted_flange.toml",
                    {},
                    {{"materials.bolt_steel.creep[0].A", 9.1e-26}, {"materials.flange_steel.creep[0].A", 8.2e-21}}};
  Case large = flange;  // 96 000 unknowns
  for (const char* const elements : {"around=6", "hole=9", "face=9", "seat=7", "bearing=5", "thickness=11", "shank=18"})
    large.settings.push_back(fmt::format("mesh.parameters.n_{}", elements));
  return {flange,
          {CREEPCONTACT_CONFIGS "/ball_on_block.toml",
           {"mesh.parameters.h=0.16", "time.tolerance=1e-3"},
           {{"materials.solder.creep[0].A", 1e-14}, {"materials.copper.creep[0].A", 1e-17}}},
          large};
}

/// Sample i of n: a factor of two for one standard deviation, at the quantiles (i + 1/2)/n of a logistic distribution.
double factor_of(std::size_t i, std::size_t n) {
  const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
  return std::pow(2.0, std::log(p / (1 - p)) / 1.8);
}

std::vector<std::string> settings_of(const Case& of, std::size_t i, std::size_t n) {
  std::vector<std::string> settings = of.settings;
  settings.emplace_back("output.fields=false");
  for (const auto& [key, median] : of.constants)
    settings.push_back(fmt::format("{}={}", key, median * factor_of(i, n)));
  return settings;
}

std::vector<double> last_probes(const fs::path& output) {
  std::ifstream history(output / "history.csv");
  std::string line, last;
  while (std::getline(history, line)) last = line;
  std::vector<double> values;
  std::istringstream numbers(last);
  for (std::string number; std::getline(numbers, number, ',');) values.push_back(std::stod(number));
  return values;
}

void run_the_program(const Case& of, const std::vector<std::string>& settings, const fs::path& output) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "creepcontact";
  std::string command =
      fmt::format("OMP_NUM_THREADS=1 '{}' run '{}' --output '{}'", program.string(), of.file, output.string());
  for (const std::string& setting : settings) command += fmt::format(" --set '{}'", setting);
  if (std::system((command + " > /dev/null 2>&1").c_str()) != 0) throw std::runtime_error(command);
}

void ensemble(benchmark::State& state) {
  const Case of = cases()[static_cast<std::size_t>(state.range(0))];
  const auto n = static_cast<std::size_t>(state.range(1)), at_once = static_cast<std::size_t>(state.range(2));
  constexpr std::size_t n_single = 4;
  const ThreadCount one(1);
  log::set_level(log::Level::error);
  const fs::path directory = fs::temp_directory_path() / fmt::format("creepcontact_ensemble_{}", ::getpid());
  const auto single = [&](std::size_t k) { return directory / fmt::format("single_{}", k); };
  const auto together = [&](std::size_t i) { return directory / fmt::format("together_{}", i); };
  const auto number_of = [n](std::size_t k) { return k * n / n_single + n / (2 * n_single); };
  fs::create_directories(directory);

  const double before_single = processor_seconds();
  for (std::size_t k = 0; k < n_single; ++k) run_the_program(of, settings_of(of, number_of(k), n), single(k));
  const double of_single = (processor_seconds() - before_single) / static_cast<double>(n_single);
  for ([[maybe_unused]] auto _ : state) {
    run::Kept kept;
    std::vector<std::function<void()>> jobs;
    for (std::size_t i = 0; i < n; ++i)
      jobs.emplace_back([&, i] {
        const run::Summary summary = run::run(config::read(of.file, run::vocabulary(), settings_of(of, i, n)),
                                              {.output = together(i).string(), .kept = &kept});
        if (summary.exit_status != 0) throw std::runtime_error(summary.message);
      });
    const double before = processor_seconds();
    kept.passes.run(jobs, at_once);
    const double seconds = processor_seconds() - before, of_sample = seconds / static_cast<double>(n);
    double difference = 0;
    for (std::size_t k = 0; k < n_single; ++k) {
      const std::vector<double> alone = last_probes(single(k)), among_others = last_probes(together(number_of(k)));
      for (std::size_t p = 0; p < alone.size(); ++p)
        difference = std::max(difference, std::abs(among_others.at(p) / alone[p] - 1));
    }
    const auto counters = kept.passes.counters();
    state.counters["single_seconds"] = of_single;
    state.counters["sample_seconds"] = of_sample;
    state.counters["of_single_runs"] = of_sample / of_single;
    state.counters["vectors"] = static_cast<double>(counters.vectors) / static_cast<double>(counters.passes);
    state.counters["of_the_floor"] = seconds / counters.seconds;
    state.counters["difference"] = difference;
  }
  fs::remove_all(directory);
}
BENCHMARK(ensemble)
    ->Args({0, 64, 16})
    ->Args({0, 64, 1})
    ->Args({1, 64, 16})  // of 16 samples few would soon be left
    ->Args({2, 64, 16})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace
}  // namespace creepcontact::test

int main(int argc, char** argv) {
  creepcontact::test::run_benchmarks(argc, argv);
}
