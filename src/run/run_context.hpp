#pragma once
/// What the parts of a run work on.

#include <filesystem>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/step_view.hpp"

namespace creepcontact::run {

class SensitiveIntegrator;

/// Everything in it outlives the loop and its observers.
struct RunContext {
  const config::Config& config;
  const model::Model& model;
  ObservedSystem& observed;
  Stopwatch& watch;
  std::filesystem::path directory;           ///< of the results; empty: no files are written
  bool integrates = false;                   ///< something creeps, in some process
  const creep::Memory* resumed = nullptr;    ///< of the checkpoint from which the run is resumed; null: a new run
  double begin = 0;                          ///< time at which this part of the run begins
  SensitiveIntegrator* sensitive = nullptr;  ///< of the run; null: no derivatives are wanted

  creep::CreepSystem& system() const { return observed.system(); }
  const Team& team() const { return observed.team(); }
  const creep::Assembly& assembly() const { return model.assembly; }
};

}  // namespace creepcontact::run
