#include "preparation.hpp"

#include <fmt/format.h>

#include "checkpoints.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "memory_need.hpp"

namespace creepcontact::run {
namespace {

/// A tangent stiffness must be condensed anew with every factorisation, which neither iterated contact nor contact of
/// several processes is made for.
void require_condensed_contact(const config::Config& config, const contact::CondensedInterface& interface,
                               const Team& team) {
  if (config.time.linear_solver != settings::LinearSolver::tangent) return;
  if (team.size() > 1)
    throw ConfigError(fmt::format(
        "{}: time.linear_solver = \"tangent\" is not yet possible on several processes; use one process, or "
        "\"krylov\"",
        config.file.string()));
  if (interface.is_dense()) return;
  throw ConfigError(
      fmt::format("{}: time.linear_solver = \"tangent\" needs the matrices of the contact zones ({:.0f} MB), and "
                  "contact_solver.dense_limit_mb = {:.6g} does not allow them; raise that limit, or use \"krylov\"",
                  config.file.string(), interface.dense_bytes() / 1e6, config.contact_solver.dense_limit_mb));
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
                                     const creep::Assembly& assembly, int processes_here, Stopwatch& watch) {
  return creep::EquilibriumSolver(assembly, model.solver, watch,
                                  [&](const contact::CondensedInterface& analyzed, double contact_bytes) {
                                    require_memory(config, assembly, contact_bytes, processes_here, [&](std::size_t b) {
                                      const linalg::StiffnessSolver& of_body = analyzed.factored(b).solver();
                                      return static_cast<double>(of_body.factor_bytes() + of_body.work_bytes());
                                    });
                                  });
}

creep::CreepSystem make_system(const config::Config& config, const model::Model& model,
                               creep::EquilibriumSolver& solver, Stopwatch& watch) {
  require_condensed_contact(config, solver.interface(), solver.assembly().team());
  return creep::CreepSystem(solver, creep::survey_elastic_stress(solver, config.time.output, model.breakpoints),
                            config.time.tolerance, watch);
}

std::unique_ptr<ode::Integrator> make_integrator(const config::Time& time, creep::CreepSystem& system) {
  // One of several processes may have nothing that creeps.
  if (!system.team().any(system.size() > 0)) return nullptr;
  ode::IntegratorOptions options = time;
  options.end_time = time.end;
  return ode::make_integrator(time.integrator, system, options);
}

}  // namespace creepcontact::run
