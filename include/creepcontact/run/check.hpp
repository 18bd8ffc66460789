#pragma once
/// The command `creepcontact check`.

#include <iosfwd>
#include <string>

#include "creepcontact/config/config.hpp"
#include "creepcontact/run/run.hpp"

namespace creepcontact::run {

/// Options that are not part of the configuration.
struct CheckOptions {
  std::string output = {};   ///< directory that the run would use; empty: that of the configuration
  bool resume = false;       ///< whether the run would continue from the checkpoint there
  bool start = false;        ///< solve t = 0 and print what comes out
  bool fields = false;       ///< write the model for ParaView, and a picture of it, into the directory
  Processes processes = {};  ///< of one process: what else can solve t = 0 than the factors
};

/// Completes a configuration as run() does, and prints bodies, unknowns, contact pairs with the distances in the mesh,
/// rigid-body modes and estimated memory, and with `start` the state at t = 0. What a run would refuse before its first
/// step is refused with the same message; without `start` only what shows without a solve. Files are written with
/// `fields` only: model.pvd, groups.pvd and plots/model.png.
/// @throws Error as run(); an output directory or a checkpoint before meshing, a body that moves after the report
void check(const config::Config& given, std::ostream& report, const CheckOptions& options = {});

}  // namespace creepcontact::run
