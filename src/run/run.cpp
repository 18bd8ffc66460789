#include "creepcontact/run/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
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
#include "creepcontact/config/writer.hpp"
#include "creepcontact/io/checkpoint/checkpoint.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/platform/background.hpp"
#include "creepcontact/platform/directory_lock.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/platform/memory.hpp"
#include "creepcontact/results/contact_width.hpp"
#include "creepcontact/results/probes.hpp"
#include "creepcontact/run/report.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "fingerprint.hpp"
#include "finished_run.hpp"
#include "heat_alone.hpp"
#include "loop.hpp"
#include "observers/observers.hpp"
#include "preparation.hpp"
#include "sensitivity/sensitive_integrator.hpp"
#include "summary_file.hpp"
#include "warning_order.hpp"

namespace creepcontact::run {
namespace {

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
ProcessWork work_of_processes(const Processes& processes, const creep::Distribution& distribution) {
  if (!processes.work) return {};
  double n_elements = 0, n_points = 0;
  for (const mechanics::Body& body : distribution.own().bodies()) {
    n_elements += static_cast<double>(body.discretization().n_elements());
    n_points += static_cast<double>(body.discretization().n_points());
  }
  std::vector<std::pair<std::string, double>> own{
      {"elements", n_elements}, {"integration points", n_points}, {"memory [MB]", platform::peak_memory() / (1 << 20)}};
  for (auto& item : processes.work()) own.push_back(std::move(item));
  ProcessWork result;
  std::vector<double> values;
  for (const auto& [name, value] : own) {
    result.names.push_back(name);
    values.push_back(value);
  }
  const std::vector<double> all = processes.team->gather(values);
  for (auto first = all.begin(); first != all.end(); first += std::ssize(own))
    result.values.emplace_back(first, first + std::ssize(own));
  return result;
}

Diagnosis diagnosis(const creep::CreepSystem& system) {
  Diagnosis result;
  const std::vector<double> times = system.relaxation_times(system.step_evaluation());
  for (std::size_t b = 0; b < times.size(); ++b)
    result.bodies.push_back({system.assembly().bodies()[b].name(), times[b]});
  const creep::Equilibrium& at = system.step_evaluation().equilibrium;
  for (std::size_t p = 0; p < system.assembly().pairs().size(); ++p) {
    const contact::Pair& pair = system.assembly().pairs()[p];
    const std::int64_t changes = system.history().set_changes[p];
    const std::optional<int> width =
        changes > 0 && !pair.ties_nodes() ? results::elements_across(system.assembly(), pair, at) : std::nullopt;
    result.contacts.push_back({pair.name, changes, width && !results::narrow_contact_text(pair, *width, "").empty()});
  }
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

/// Tells of the bodies, the contacts and the motions that nothing holds.
void log_model(const model::Model& model, const creep::EquilibriumSolver& solver) {
  for (const contact::Pair& pair : solver.interface().pairs())
    if (pair.ties_nodes())
      log::info("{}: tied, {} multipliers", pair.name, pair.coupling.nodes.size());
    else
      log::info("contact '{}': slave '{}', {} multipliers", pair.name, pair.slave_surface, pair.coupling.nodes.size());
  if (!solver.interface().is_dense())
    log::info("contact: matrix-free, its matrices would take {:.0f} MB", solver.interface().dense_bytes() / 1e6);
  for (const std::string& motion : model.assembly.rigid_body_modes().describe_unconstrained())
    log::info("not held by supports or contact, must not be loaded: {}", motion);
}

void warn_of_settings_and_meshes(const config::Config& config, const model::Model& model) {
  for (const std::string& warning : settings_warnings(config)) log::warning("{}", warning);
  for (const std::string& warning : model::model_warnings(config, model)) log::warning("{}", warning);
  for (const mechanics::Body& body : model.bodies())
    for (const std::string& warning : model::mesh_warnings(body)) log::warning("{}", warning);
  for (const mechanics::Body& body : model.bodies())
    log::info("body '{}': {} elements, {} unknowns", body.name(), body.discretization().n_elements(),
              body.constraints().n_free());
}

/// The directory of the results, held by this run alone.
class OutputDirectory {
 public:
  /// Changes nothing but the files that tell of an earlier run. Collective.
  /// @throws ConfigError as require_output(), or if another run holds the directory
  OutputDirectory(const config::Config& config, const RunOptions& options)
      : path_(options.writes_files ? output_directory(config, options.output) : ""),
        is_root_(options.processes.team->rank() == 0) {
    if (path_.empty()) return;
    together(*options.processes.team, [&] {
      require_output(path_, options.resume);
      if (!is_root_) return;
      if (path_is_directory(path_)) lock_.emplace(path_);
      if (const auto earlier = io::read_summary(path_ / "summary.json"); earlier && options.resume)
        earlier_warnings_ = earlier->warnings;
      std::error_code ignored;  // there may be none; that of an earlier run would speak for this one
      if (!options.resume)
        for (const char* file : {"summary.json", "model.json", "model_view.json"})
          std::filesystem::remove(path_ / file, ignored);
    });
  }
  /// @throws ConfigError if it cannot be made
  void make() {
    if (!is_root_ || path_.empty()) return;
    std::error_code failure;
    std::filesystem::create_directories(path_, failure);
    if (failure) throw ConfigError(fmt::format("output directory {}: {}", path_.string(), failure.message()));
    if (!lock_) lock_.emplace(path_);
  }
  const std::filesystem::path& path() const { return path_; }
  /// Warnings of the run that is resumed.
  const std::vector<std::string>& earlier_warnings() const { return earlier_warnings_; }

 private:
  std::filesystem::path path_;
  bool is_root_;
  std::optional<platform::DirectoryLock> lock_;
  std::vector<std::string> earlier_warnings_;
};

std::string interruption(const Summary& so_far, bool may_be_resumed) {
  const io::Summary& results = so_far.results;
  return fmt::format(
      "interrupted at t = {:.6g}{}; {}", results.time_reached,
      so_far.has_output ? fmt::format(", after the output of t = {:.6g}", results.last_output.value_or(0)) : "",
      may_be_resumed ? "continue with --resume" : "there is nothing to resume yet");
}

/// Runs the loop and writes the summary of its end.
Summary run_loop(Loop& loop, const ObserverList& observers, SummaryFile& file, const Checkpoints& checkpoints,
                 const RunContext& context, const io::Checkpoint* resumed) {
  using Status = io::Summary::Status;
  const auto write = [&](const Summary& summary) {
    const auto lap = context.watch.lap(Part::output);
    file.write(summary);
  };
  const auto failed = [&](int exit_status, const std::string& cause) {
    observers.end(End::failed);
    Summary summary = file.make(Status::failed, cause);
    try {
      write(summary);
    } catch (const Error& second) {
      log::error("{}", second.what());  // the first cause is what the user must see
    }
    summary.exit_status = exit_status;
    summary.message = cause;
    if (summary.has_output && !context.directory.empty())
      summary.message += fmt::format("; results up to t = {:.6g} are in {}", summary.results.last_output.value_or(0),
                                     context.directory.string());
    return summary;
  };
  try {
    const End end = [&] {
      const auto lap = context.watch.lap(Part::integrate);
      return loop.run(resumed);
    }();
    observers.end(end);
    constexpr auto status_of = [](End how) {
      return how == End::interrupted ? Status::interrupted
             : how == End::ruptured  ? Status::ruptured
                                     : Status::completed;
    };
    Summary summary = file.make(status_of(end), "");
    if (end == End::interrupted) {
      summary.exit_status = platform::interrupted_status;
      summary.message = summary.results.message = interruption(summary, checkpoints.exist());
    }
    write(summary);
    return summary;
  } catch (const Error& error) {
    return failed(error.exit_status(), error.what());
  } catch (const std::bad_alloc&) {
    return failed(SolverError::status, platform::out_of_memory);
  }
}

}  // namespace

Summary run(const config::Config& given, const RunOptions& options) {
  const config::Config config = with_what_is_computed(config::completed(given, vocabulary()));
  Stopwatch watch;
  log::WarningRecord warnings;
  const Team& team = *options.processes.team;
  std::optional<platform::Interrupt> interrupt;  // outlives all that takes time to be freed
  OutputDirectory directory(config, options);

  std::vector<ChangedValue> changed;
  together(team, [&] { changed = changed_values(config); });
  std::optional<Kept> own;  // of the run and its variants
  Kept* const kept = options.kept != nullptr || changed.empty() ? options.kept : &own.emplace();
  linalg::GatheredPasses passes_of_variants;
  std::optional<model::Model> built;
  std::vector<std::unique_ptr<results::Probe>> probes;
  Summary finished;
  together(team, [&] {
    built.emplace(model::build_model(config, kept != nullptr ? &kept->meshes : nullptr));
    probes = results::make_probes(config, *built);  // errors in them show before anything is factored
    if (options.resume) finished.message = nothing_left(config, *built, directory.path());
    if (!finished.message.empty() && team.rank() == 0) renew_report(directory.path(), config);
  });
  model::Model& model = *built;
  if (kept != nullptr)
    model.solver.stiffness_solver = kept->factors.lending(changed.empty() ? &kept->passes : &passes_of_variants);
  if (team.size() > 1 && !changed.empty())
    throw ConfigError(fmt::format(
        "{}: derivatives (sensitivity.keys) are not yet possible on several processes; use one", config.file.string()));
  require_one_model(team, config, model);
  if (team.any(team.rank() == 0 && !finished.message.empty())) return finished;
  if (team.size() > 1 && model.assembly.heat() != nullptr)
    throw ConfigError(
        fmt::format("{}: conductances that depend on contact make the temperature part of the state, which is not yet "
                    "possible on several processes; use one process",
                    config.file.string()));
  const creep::Distribution distribution =
      team.size() == 1 ? creep::Distribution(model.assembly)
                       : creep::Distribution(model.assembly, team, options.processes.partition(model.bodies()));
  platform::Background loading;  // of what the checkpoint at the end needs
  // Where address space is short, it must not vanish between the check of the memory and its use.
  if (std::isfinite(platform::address_space().bytes))
    io::prepare_checkpoints();
  else
    loading.start(io::prepare_checkpoints);
  warn_of_settings_and_meshes(config, model);
  std::optional<ContactLog> contact_log;
  if (!options.log_contact.empty() && team.rank() == 0) contact_log.emplace(options.log_contact, config.output.csv);
  creep::EquilibriumSolver solver = make_solver(config, model, distribution.own(), options.processes, watch);
  if (contact_log) solver.set_recorder(&*contact_log);
  log_model(model, solver);
  creep::CreepSystem system = make_system(config, model, solver, watch);

  interrupt.emplace();  // from here on there is something to save
  solver.set_stop(stop_request(*interrupt));
  together(team, [&] { directory.make(); });
  Checkpoints checkpoints(config, model, distribution, directory.path());
  std::optional<io::Checkpoint> resumed;
  if (options.resume) {
    resumed = checkpoints.read();
    system.restore(resumed->arrays);
  } else if (distribution.is_root()) {
    checkpoints.remove();
  }
  ObservedSystem observed(distribution, system, probes);
  std::unique_ptr<ode::Integrator> integrator;
  SensitiveIntegrator* sensitive = nullptr;
  const auto integrator_of = [&](ode::System& integrated) {
    return make_integrator(config, model, system, integrated);
  };
  if (changed.empty()) {
    integrator = integrator_of(system);
  } else {
    auto made = std::make_unique<SensitiveIntegrator>(
        make_derivatives(changed, model, system, solver, *kept, passes_of_variants, watch), integrator_of);
    sensitive = made.get();
    integrator = std::move(made);
  }
  const RunContext context{.config = config,
                           .model = model,
                           .observed = observed,
                           .watch = watch,
                           .directory = directory.path(),
                           .integrates = team.any(system.size() > 0),
                           .resumed = resumed ? &resumed->arrays : nullptr,
                           .begin = resumed ? resumed->time : 0,
                           .sensitive = sensitive};
  ObserverList observers = make_observers(context, options.observers);
  std::optional<Loop> loop;
  SummaryFile file(context, observers, directory.earlier_warnings(), warnings,
                   [&loop](Summary& summary) { loop->describe(summary); });
  observers.add(file);
  loop.emplace(context, observers, std::move(integrator), checkpoints);

  Summary summary = run_loop(*loop, observers, file, checkpoints, context, resumed ? &*resumed : nullptr);
  if (!summary.has_output || summary.results.status == io::Summary::Status::failed) return summary;
  if (summary.steps.empty()) return summary;
  summary.processes = work_of_processes(options.processes, distribution);
  // A step that was cancelled has left no evaluation to speak of.
  if (summary.exit_status == 0 || system.step_evaluation().valid) {
    summary.diagnosis = diagnosis(system);
    summary.advice = advice(summary);
  }
  for (const std::string& line : summary.advice) summary.add_warning(line);
  summary.results.warnings = by_consequence(std::move(summary.results.warnings));
  if (team.any(!summary.advice.empty())) file.write(summary);
  return summary;
}

}  // namespace creepcontact::run
