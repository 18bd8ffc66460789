#pragma once
/// What a run does before its time loop. `check --start` does the same, so both refuse the same configurations with the
/// same messages.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/run/run.hpp"

namespace creepcontact::run {

/// Warnings about settings that are allowed but unsuitable in combination.
std::vector<std::string> settings_warnings(const config::Config& config);

/// @param output  what the command line gives; empty: the directory of the configuration
std::filesystem::path output_directory(const config::Config& config, const std::string& output);

/// Before anything is meshed. Makes and changes nothing. @param resume  there must be a checkpoint
/// @throws ConfigError if no results can be written into the directory, or if there is nothing to resume
void require_output(const std::filesystem::path& directory, bool resume);

/// Factors all bodies, or makes their multigrids (linear_solver.method). @param model, watch  must outlive the solver.
/// @param assembly  that of the model, or the own part of it where several processes share the model.
/// @throws ModelError if there is not enough memory, and as EquilibriumSolver; ConfigError if there is no multigrid
creep::EquilibriumSolver make_solver(const config::Config& config, const model::Model& model,
                                     const creep::Assembly& assembly, const Processes& processes, Stopwatch& watch);

/// Surveys the elastic stress and takes up the loads of t = 0. @param solver, watch  must outlive the system
/// @throws as survey_elastic_stress() and EquilibriumSolver::initial_history(); ConfigError if the linear solver of the
/// time integration cannot be used with contact as large as this
creep::CreepSystem make_system(const config::Config& config, const model::Model& model,
                               creep::EquilibriumSolver& solver, Stopwatch& watch);

/// A LoadPath if nothing creeps. @param config, model, system  must outlive the integrator
/// @param integrated  what the integrator is to see of the system, with its state and more
std::unique_ptr<ode::Integrator> make_integrator(const config::Config& config, const model::Model& model,
                                                 creep::CreepSystem& system, ode::System& integrated);

}  // namespace creepcontact::run
