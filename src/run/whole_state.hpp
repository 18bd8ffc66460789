#pragma once
/// The state of the whole model at an output time, of which each process has a part.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/creep/distribution.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::run {

class WholeState {
 public:
  /// @param distribution, system (of its own part)  must outlive the object
  WholeState(const creep::Distribution& distribution, creep::CreepSystem& system);

  /// Calls f in the process that writes results, with the snapshot at (t, y). An error there is one in all. Collective.
  /// @param y  of this process @returns what f returns, in all processes
  std::vector<double> look(double t, std::span<const double> y,
                           const std::function<std::vector<double>(results::Snapshot&)>& f);
  /// The same with an evaluation that is known. @param own  of the part of this process, at t
  std::vector<double> look_at(double t, const creep::Evaluation& own,
                              const std::function<std::vector<double>(results::Snapshot&)>& f);
  creep::CreepSystem& system() { return system_; }

 private:
  const creep::Distribution& distribution_;
  creep::CreepSystem& system_;
  std::optional<creep::BodyLaws> laws_;  // of the whole model, if the system has only a part of it
  creep::Evaluation space_;
};

}  // namespace creepcontact::run
