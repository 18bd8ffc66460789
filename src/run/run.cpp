#include "creepcontact/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "contact_log.hpp"
#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/io/checkpoint/checkpoint.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/linalg/blas_library.hpp"
#include "creepcontact/platform/background.hpp"
#include "creepcontact/platform/directory_lock.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/platform/memory.hpp"
#include "creepcontact/results/probes.hpp"
#include "creepcontact/run/check.hpp"
#include "fingerprint.hpp"
#include "finished_run.hpp"
#include "model_record.hpp"
#include "preparation.hpp"
#include "run_report.hpp"
#include "time_loop.hpp"

namespace creepcontact::run {
namespace {

io::Summary make_summary(const config::Config& config, const model::Model& model, const TimeLoop& loop,
                         const Stopwatch& watch) {
  io::Summary summary;
  summary.title = config.title;
  summary.units = config.units;
  summary.version = CREEPCONTACT_VERSION;
  const linalg::BlasLibrary blas = linalg::blas_library();
  summary.libraries = {{"blas", blas.blas}, {"lapack", blas.lapack}};
  for (const config::Material& material : config.materials)
    if (!material.sources.empty()) summary.sources[material.name] = material.sources;
  loop.probe_record().fill(config, summary);
  loop.events().fill(summary);
  if (loop.cycles() != nullptr) loop.cycles()->fill(summary);
  summary.integrator = config.time.integrator;
  summary.method = loop.method();
  summary.time_reached = loop.time();
  static_cast<RunCounters&>(summary) = loop.counters();
  loop.life().fill(summary);
  for (const mechanics::Body& body : model.bodies())
    summary.bodies[body.name()] = {body.constraints().n_free(),
                                   static_cast<std::int64_t>(body.discretization().n_elements()),
                                   static_cast<std::int64_t>(body.discretization().n_points()),
                                   {}};
  loop.outcome().fill(summary, config.time.cycle);
  summary.friction_kappa = loop.friction_kappa();
  summary.accuracy = {config.time.tolerance, loop.step_statistics().mean_error(),
                      loop.step_statistics().largest_error(), loop.equilibrium_residual()};
  summary.wall_seconds = {watch.total(),
                          watch.seconds(Part::factorize),
                          watch.seconds(Part::solve),
                          watch.seconds(Part::material),
                          watch.seconds(Part::contact),
                          watch.seconds(Part::output)};
  summary.peak_memory_mb = platform::peak_memory() / (1 << 20);
  return summary;
}

/// Warnings of this run after those of the run that it continues, each once. Those of large strain are those up to now.
std::vector<std::string> joined(std::vector<std::string> earlier, const log::WarningRecord& record,
                                const results::SmallStrainMonitor& strains) {
  std::erase_if(earlier, results::SmallStrainMonitor::is_warning);
  std::vector<std::string> own = record.texts();
  std::ranges::copy(strains.warnings(), std::back_inserter(own));
  for (std::string& warning : own)
    if (std::ranges::find(earlier, warning) == earlier.end()) earlier.push_back(std::move(warning));
  return earlier;
}

/// True at first, then once per second: writing a summary takes longer than many a step.
class SummaryTimer {
 public:
  bool operator()() {
    const auto now = std::chrono::steady_clock::now();
    if (last_ && now - *last_ < std::chrono::seconds(1)) return false;
    last_ = now;
    return true;
  }

 private:
  std::optional<std::chrono::steady_clock::time_point> last_;
};

/// The processes read the files each for itself. @throws ConfigError if they do not have the same
void require_one_model(const Team& team, const config::Config& config, const model::Model& model) {
  if (team.size() == 1) return;
  const std::string text = fmt::format("{}\n{}", CREEPCONTACT_VERSION, fingerprint(config, model));
  const FileBytes file = read_file(config.file);
  Checksum sum;
  sum.add(text.data(), text.size());
  sum.add(file.bytes.data(), file.bytes.size());
  // In two halves: numbers that a double holds.
  const double high = static_cast<double>(sum.value() >> 32U), low = static_cast<double>(sum.value() & 0xffffffffU);
  std::vector<double> of_root{high, low};
  team.broadcast(of_root, 0);
  together(team, [&] {
    if (of_root != std::vector<double>{high, low})
      throw ConfigError(
          fmt::format("process {} reads another configuration or mesh than process 0, or is another version of the "
                      "program: all need the same files and the same program, as on a file system that they share",
                      team.rank()));
  });
}

/// Collective; empty for one process.
std::string table_of_processes(const Processes& processes, const creep::Distribution& distribution) {
  if (!processes.work) return {};
  double n_elements = 0, n_points = 0;
  for (const mechanics::Body& body : distribution.own().bodies()) {
    n_elements += static_cast<double>(body.discretization().n_elements());
    n_points += static_cast<double>(body.discretization().n_points());
  }
  std::vector<std::pair<std::string, double>> own{
      {"elements", n_elements}, {"integration points", n_points}, {"memory [MB]", platform::peak_memory() / (1 << 20)}};
  for (auto& item : processes.work()) own.push_back(std::move(item));
  std::vector<double> values;
  values.reserve(own.size());
  for (const auto& [name, value] : own) values.push_back(value);
  const std::vector<double> all = processes.team->gather(values);
  std::string text = "  processes:\n";
  for (std::size_t i = 0; i < own.size(); ++i) {
    text += fmt::format("    {:<30}", own[i].first);
    for (std::size_t first = 0; first < all.size(); first += own.size())
      text += fmt::format("{:>12.5g}", all[first + i]);
    text += '\n';
  }
  return text;
}

Diagnosis diagnosis(const creep::CreepSystem& system) {
  Diagnosis result;
  const std::vector<double> times = system.relaxation_times(system.step_evaluation());
  for (std::size_t b = 0; b < times.size(); ++b)
    result.bodies.push_back({system.assembly().bodies()[b].name(), times[b]});
  for (std::size_t p = 0; p < system.assembly().pairs().size(); ++p)
    result.contacts.push_back({system.assembly().pairs()[p].name, system.history().set_changes[p]});
  return result;
}

/// What contact iterations heed. A step that is about to end may end, so that nothing of it is lost.
StopRequest stop_request(const platform::Interrupt& interrupt) {
  using Clock = std::chrono::steady_clock;
  static constexpr auto patience = std::chrono::milliseconds(300);
  return StopRequest([&interrupt, since = std::make_shared<std::optional<Clock::time_point>>()] {
    if (!interrupt.requested()) return false;
    const Clock::time_point now = Clock::now();
    if (!since->has_value()) *since = now;
    return now - **since >= patience;
  });
}

}  // namespace

RunResult run(const config::Config& config, const RunOptions& options) {
  Stopwatch watch;
  log::WarningRecord warnings;
  const std::filesystem::path directory = output_directory(config, options.output);
  const Team& team = *options.processes.team;
  const bool writes = team.rank() == 0;

  std::optional<platform::Interrupt> interrupt;  // outlives all that takes time to be freed
  std::optional<platform::DirectoryLock> lock;
  std::vector<std::string> earlier_warnings;
  together(team, [&] {
    require_output(directory, options.resume);
    if (!writes) return;
    if (path_is_directory(directory)) lock.emplace(directory);
    if (const auto earlier = io::read_summary(directory / "summary.json"); earlier && options.resume)
      earlier_warnings = earlier->warnings;
    std::error_code ignored;  // there may be none; that of an earlier run would speak for this one
    if (!options.resume)
      for (const char* file : {"summary.json", "model.json"}) std::filesystem::remove(directory / file, ignored);
  });
  std::optional<model::Model> built;
  std::vector<std::unique_ptr<results::Probe>> probes;
  std::string reason_to_end;
  together(team, [&] {
    built.emplace(model::build_model(config));
    probes = results::make_probes(config, *built);  // errors in them show before anything is factored
    if (options.resume) reason_to_end = nothing_left(config, *built, directory);
  });
  model::Model& model = *built;
  require_one_model(team, config, model);
  if (team.any(writes && !reason_to_end.empty())) return {0, std::move(reason_to_end)};
  const creep::Distribution distribution =
      team.size() == 1 ? creep::Distribution(model.assembly)
                       : creep::Distribution(model.assembly, team, options.processes.deal(model.bodies()));
  platform::Background loading;  // of what the checkpoint at the end needs
  // Where address space is short, it must not vanish between the check of the memory and its use.
  if (std::isfinite(platform::address_space().bytes))
    io::prepare_checkpoints();
  else
    loading.start(io::prepare_checkpoints);
  for (const std::string& warning : settings_warnings(config)) log::warning("{}", warning);
  for (const std::string& warning : model::model_warnings(config, model)) log::warning("{}", warning);
  for (const mechanics::Body& body : model.bodies())
    for (const std::string& warning : model::mesh_warnings(body)) log::warning("{}", warning);
  for (const mechanics::Body& body : model.bodies())
    log::info("body '{}': {} elements, {} unknowns", body.name(), body.discretization().n_elements(),
              body.constraints().n_free());
  std::optional<ContactLog> contact_log;
  if (!options.log_contact.empty() && writes) contact_log.emplace(options.log_contact, config.output.csv);
  creep::EquilibriumSolver solver = make_solver(config, model, distribution.own(), options.processes, watch);
  if (contact_log) solver.set_recorder(&*contact_log);
  for (const contact::Pair& pair : solver.interface().pairs())
    if (pair.ties_nodes())
      log::info("{}: tied, {} multipliers", pair.name, pair.coupling.nodes.size());
    else
      log::info("contact '{}': slave '{}', {} multipliers", pair.name, pair.slave_surface, pair.coupling.nodes.size());
  if (!solver.interface().is_dense())
    log::info("contact: matrix-free, its matrices would take {:.0f} MB", solver.interface().dense_bytes() / 1e6);
  for (const std::string& motion : model.assembly.rigid_body_modes().describe_unconstrained())
    log::info("not held by supports or contact, must not be loaded: {}", motion);
  creep::CreepSystem system = make_system(config, model, solver, watch);

  interrupt.emplace();  // from here on there is something to save
  solver.set_stop(stop_request(*interrupt));
  together(team, [&] {
    if (!writes) return;
    std::error_code failure;
    std::filesystem::create_directories(directory, failure);
    if (failure) throw ConfigError(fmt::format("output directory {}: {}", directory.string(), failure.message()));
    if (!lock) lock.emplace(directory);
  });
  TimeLoop loop(config, model, distribution, system, std::move(probes), watch, directory, options.resume,
                options.observer);

  const auto write_summary = [&](io::Summary::Status status, const std::string& message) {
    const auto lap = watch.lap(Part::output);
    io::Summary summary = make_summary(config, model, loop, watch);
    summary.status = status;
    summary.message = message;
    summary.warnings = joined(earlier_warnings, warnings, loop.small_strains());
    together(team, [&] {
      if (writes) io::write_summary(directory / "summary.json", summary);
    });
    return summary;
  };
  // Should the run be killed, its last summary says how far it came.
  SummaryTimer summary_due;
  bool described = options.resume && path_exists(directory / "model.json");
  loop.after_output = [&] {
    together(team, [&] {
      if (!std::exchange(described, true) && writes)
        io::write_model_record(directory / "model.json",
                               model_record(config, model, make_summary(config, model, loop, watch)));
    });
    if (team.any(summary_due())) write_summary(io::Summary::Status::interrupted, "killed after this time was reached");
  };

  const auto warn_of_strains = [&] {
    for (const std::string& warning : loop.small_strains().warnings()) log::warning("{}", warning);
  };
  const auto failed = [&](int status, const std::string& cause) {
    warn_of_strains();
    try {
      write_summary(io::Summary::Status::failed, cause);
    } catch (const Error& second) {
      log::error("{}", second.what());  // the first cause is what the user must see
    }
    return RunResult{status, !loop.has_output() ? cause
                                                : fmt::format("{}; results up to t = {:.6g} are in {}", cause,
                                                              loop.outcome().last_output(), directory.string())};
  };

  RunResult result;
  io::Summary summary;
  try {
    const TimeLoop::End end = loop.run();
    warn_of_strains();
    if (end == TimeLoop::End::completed) {
      for (const std::string& warning : loop.narrow_contacts()) log::warning("{}", warning);
      summary = write_summary(io::Summary::Status::completed, loop.end_message());
    } else if (end == TimeLoop::End::ruptured) {
      summary = write_summary(io::Summary::Status::ruptured, "");
    } else {
      result = {
          platform::interrupted_status,
          fmt::format(
              "interrupted at t = {:.6g}{}; {}", loop.time(),
              loop.has_output() ? fmt::format(", after the output of t = {:.6g}", loop.outcome().last_output()) : "",
              loop.may_be_resumed() ? "continue with --resume" : "there is nothing to resume yet")};
      summary = write_summary(io::Summary::Status::interrupted, result.message);
    }
  } catch (const Error& error) {
    return failed(error.exit_status(), error.what());
  } catch (const std::bad_alloc&) {
    return failed(SolverError::status, platform::out_of_memory);
  }
  if (!loop.has_output()) return result;
  const char* const end = result.exit_status != 0 ? "interrupted" : summary.rupture ? "ruptured" : "done";
  result.report = fmt::format("{}: t = {:.6g}; results in {}\n", end, loop.time(), directory.string()) +
                  outcome_table(summary) +
                  work_line(summary, loop.step_statistics(), config.time.tolerance, loop.method());
  if (loop.step_statistics().empty()) return result;
  result.details = work_table(summary, loop.step_statistics(), config.time.tolerance, loop.method());
  if (loop.resumed())
    result.details += "  (lengths, orders and errors of the steps and the time are counted since the resume)\n";
  result.details += table_of_processes(options.processes, distribution);
  // A step that was cancelled has left no evaluation to speak of.
  if (result.exit_status == 0 || system.step_evaluation().valid)
    result.advice = advice(summary, loop.step_statistics(), diagnosis(system));
  for (const std::string& line : result.advice) warnings.add(line);
  if (team.any(!result.advice.empty())) write_summary(summary.status, summary.message);
  return result;
}

}  // namespace creepcontact::run
