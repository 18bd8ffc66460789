#include "preparation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "checkpoints.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/linalg/blas_library.hpp"
#include "creepcontact/ode/restart_share.hpp"
#include "load_path.hpp"
#include "memory_need.hpp"

namespace creepcontact::run {
namespace {

/// A tangent stiffness must be condensed again with every factorisation. Neither iterated contact nor contact of
/// several processes supports this.
void require_condensed_contact(const config::Config& config, const contact::CondensedInterface& interface,
                               const Team& team) {
  if (config.time.linear_solver != settings::LinearSolver::tangent) return;
  if (team.size() > 1)
    throw ConfigError(fmt::format(
        "{}: time.linear_solver = \"tangent\" is not yet possible on several processes; use one process, or "
        "\"krylov\"",
        config.file.string()));
  if (interface.error_bound() > 0)
    throw ConfigError(
        fmt::format("{}: time.linear_solver = \"tangent\" needs factors of the stiffness; use linear_solver.method = "
                    "\"direct\", or "
                    "time.linear_solver = \"krylov\"",
                    config.file.string()));
  if (interface.is_condensed()) return;
  throw ConfigError(
      fmt::format("{}: time.linear_solver = \"tangent\" needs the matrices of the contact zones ({:.0f} MB), and "
                  "contact_solver.dense_limit_mb = {:.6g} does not allow them; raise that limit, or use \"krylov\"",
                  config.file.string(), interface.dense_bytes() / 1e6, config.contact_solver.dense_limit_mb));
}

/// Where contact depends on its path, the elastic response of the bodies is used without an iteration that would
/// correct it. @throws ConfigError where something yields
creep::SolverOptions with_multigrid(const config::Config& config, creep::SolverOptions options,
                                    const creep::Assembly& assembly, const Processes& processes) {
  constexpr double usual_error = 0.1;             // few cycles per solve, few solves per evaluation
  constexpr double part_of_time_tolerance = 0.1;  // tight enough not to add steps or errors
  for (const mechanics::Body& body : assembly.bodies())
    if (body.material().plasticity != nullptr)
      throw ConfigError(
          fmt::format("{}: material '{}' has plasticity, whose strains are iterated with factors only, not with the "
                      "multigrid; use linear_solver.method = \"direct\"",
                      config.file.string(), body.material().name));
  const bool has_path = std::ranges::any_of(assembly.pairs(), [](const contact::Pair& pair) {
    return pair.coupling.has_friction() || pair.preload.has_value() || !pair.acts_always();
  });
  options.stress_tolerance = part_of_time_tolerance * config.time.tolerance;
  options.stiffness_solver = processes.multigrid(has_path ? options.stress_tolerance : usual_error);
  return options;
}

}  // namespace

std::filesystem::path output_directory(const config::Config& config, const std::string& output) {
  return output.empty() ? config.output.directory : std::filesystem::path(output);
}

void require_output(const std::filesystem::path& directory, bool resume) {
  if (path_exists(directory) && !path_is_directory(directory))
    throw ConfigError(
        fmt::format("output directory {}: is a file; choose another directory with --output", directory.string()));
  if (const std::string reason = why_unwritable(directory); !reason.empty())
    throw ConfigError(
        fmt::format("output directory {}: no files can be written there: {}; choose another directory "
                    "with --output",
                    directory.string(), reason));
  if (resume) io::require_checkpoint(directory / checkpoint_name);
}

creep::EquilibriumSolver make_solver(const config::Config& config, const model::Model& model,
                                     const creep::Assembly& assembly, const Processes& processes, Stopwatch& watch) {
  using settings::StiffnessMethod;
  const StiffnessMethod method = config.linear_solver.method;
  if (const std::string warning = linalg::blas_library().warning; !warning.empty()) log::warning("{}", warning);
  bool is_short = false;
  const auto admit = [&](const contact::CondensedInterface& analyzed, double contact_bytes) {
    const MemoryNeed need = memory_need(config, assembly, contact_bytes, [&](std::size_t b) {
      const linalg::StiffnessSolver& of_body = analyzed.factored(b).solver();
      return static_cast<double>(of_body.factor_bytes() + of_body.work_bytes());
    });
    const std::string shortage = memory_shortage(need, processes.on_this_machine);
    if (shortage.empty()) return;
    is_short = true;
    throw ModelError(fmt::format("{}: {}", config.mesh.file.string(), shortage));
  };
  if (method != StiffnessMethod::multigrid) try {
      creep::SolverOptions direct = model.solver;
      if (assembly.team().size() > 1) direct.stiffness_solver = processes.stiffness_solver;
      return creep::EquilibriumSolver(assembly, direct, watch, admit);
    } catch (const ModelError& error) {
      if (method == StiffnessMethod::direct || !processes.multigrid || !assembly.team().any(is_short)) throw;
      log::warning("{}. Instead, the multigrid is used, which needs less", error.what());
    }
  if (!processes.multigrid)
    throw ConfigError(fmt::format(
        "{}: linear_solver.method = \"multigrid\" is for creepcontact-mpi, which also runs as one process, and its "
        "'check --start' only so; start it as one process, or use \"auto\"",
        config.file.string()));
  return creep::EquilibriumSolver(assembly, with_multigrid(config, model.solver, assembly, processes), watch, admit);
}

creep::CreepSystem make_system(const config::Config& config, const model::Model& model,
                               creep::EquilibriumSolver& solver, Stopwatch& watch) {
  require_condensed_contact(config, solver.interface(), solver.assembly().team());
  return creep::CreepSystem(solver,
                            creep::survey_elastic_stress(solver, config.time.output, model.distinct_breakpoints()),
                            config.time.tolerance, watch);
}

std::unique_ptr<ode::Integrator> make_integrator(const config::Config& config, const model::Model& model,
                                                 creep::CreepSystem& system, ode::System& integrated) {
  const config::Time& time = config.time;
  // One of several processes may have nothing that creeps.
  if (time.end == 0 || !system.team().any(system.size() > 0))
    return std::make_unique<LoadPath>(system, time.output, model.breakpoints);
  ode::IntegratorOptions options = time;
  options.end_time = time.end;
  constexpr double steps_per_turn = 6;
  // Jumps over cycles leave errors of their own, in which those of the restarts that they pass over do not matter.
  const auto restarts =
      static_cast<double>(time.jump_cycles ? model.distinct_breakpoints().size() : model.breakpoints.size());
  options.tolerance *= std::min(ode::restart_share(time.integrator, restarts),
                                ode::vibration_share(model.step_limits.n_steps() / steps_per_turn));
  // What chooses by itself would begin with a method that has no iterations.
  const bool chooses = system.assembly().heat() != nullptr && time.integrator == "auto";
  return ode::make_integrator(chooses ? "cvode_bdf" : time.integrator, integrated, options);
}

}  // namespace creepcontact::run
