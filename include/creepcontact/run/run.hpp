#pragma once
/// A whole run: model, time loop, results.

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/base/team.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/distribution.hpp"
#include "creepcontact/linalg/factor_store.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/model/mesh_store.hpp"
#include "creepcontact/run/observer.hpp"
#include "creepcontact/run/summary.hpp"

namespace creepcontact::run {

/// The processes that share a run; by default there is one.
struct Processes {
  const Team* team = &serial_team();  ///< must outlive the run
  int on_this_machine = 1;            ///< of them: they share its memory
  /// Makes the solvers of the bodies if there are several processes, which call it together.
  linalg::StiffnessSolverFactory stiffness_solver = linalg::default_stiffness_solver;
  /// Makes multigrids with this error bound, for any number of processes; null where there are none.
  std::function<linalg::StiffnessSolverFactory(double error)> multigrid = {};
  /// Partitions the elements of the bodies, in the same way on all processes. Not called for one process.
  std::function<creep::RankOfElement(const std::vector<mechanics::Body>& bodies)> partition = {};
  /// What this process has done, by name with unit, the same names in all; for the table of the work of each.
  std::function<std::vector<std::pair<std::string, double>>()> work = {};
};

/// What runs share with other runs, later ones and those at the same time, of models that differ in other things:
/// meshes, factors, and passes through the factors. It must outlive them.
struct Kept {
  model::MeshStore meshes;
  linalg::FactorStore factors;    ///< of one process, by the direct method
  linalg::GatheredPasses passes;  ///< jobs of it that are runs make their passes together
};

/// Options that are not part of the configuration.
struct RunOptions {
  std::string output;                     ///< directory; empty: that of the configuration
  bool writes_files = true;               ///< false: no files and no directory; observers take the results
  Kept* kept = nullptr;                   ///< null: everything is read and factored
  bool resume = false;                    ///< continue from checkpoint.h5 in the directory
  std::vector<Observer*> observers = {};  ///< told of every step, output and breakpoint; must outlive the run
  /// CSV file with one row per contact iteration (time,contact_solve,set_change,iteration,method,residual,active);
  /// empty: none.
  std::string log_contact = {};
  Processes processes = {};
};

/// Runs a configuration, completed if it has been made in code (config::complete()), and writes the results
/// (history.csv, steps.csv, summary.json, fields, checkpoint.h5). Prints nothing: warnings go to the log. Uses as many
/// threads as OpenMP is set to.
///
/// SIGINT, SIGTERM and SIGHUP end the run after the current step, with a checkpoint (exit status 130). If a solver
/// fails, the exit status is 4, and results computed before are kept.
/// If there are several processes, all must call it, with the same configuration; process 0 writes, and its summary is
/// the one to print. Errors are the same in all.
/// @throws Error for errors found before the time loop (configuration 2, mesh or model 3)
Summary run(const config::Config& given, const RunOptions& options);

}  // namespace creepcontact::run
