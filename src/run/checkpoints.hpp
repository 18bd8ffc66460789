#pragma once
/// The checkpoints of a run: what is in them, when the next one is due, whether one may be resumed.

#include <chrono>
#include <filesystem>
#include <optional>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/creep/distribution.hpp"
#include "creepcontact/io/checkpoint/checkpoint.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/run/run_state.hpp"

namespace creepcontact::run {

/// Name of the part of a memory whose arrays are vectors like the state: each process has its part of them.
inline const std::string vectors_like_state = "like_state";
inline constexpr const char* checkpoint_name = "checkpoint.h5";  // in the directory of the run

class Checkpoints {
 public:
  /// @param directory  empty: none are written
  Checkpoints(const config::Config& config, const model::Model& model, const creep::Distribution& distribution,
              const std::filesystem::path& directory);

  /// The last one on disk; of several processes each gets its part, however many had written it. Collective.
  /// @throws ConfigError if there is none, or it is of another model: what differs
  io::Checkpoint read() const;
  bool exist() const;
  /// Removes the checkpoints of an earlier run in the same directory.
  void remove() const {
    if (!path_.empty()) io::remove_checkpoints(path_);
  }

  /// The run as it is now, without what its observers hold. @param work  of the run so far
  /// @param integrator  at a restart point
  io::Checkpoint take(const RunState& state, const RunCounters& work, const ode::Integrator& integrator,
                      const creep::CreepSystem& system) const;
  /// The loop as it was. @param checkpoint  from read()
  static RunState run_state(const io::Checkpoint& checkpoint);
  /// Takes the integration up where the checkpoint was taken, or, if that was by another method, begins with this one.
  void restore(const io::Checkpoint& checkpoint, ode::Integrator& integrator) const;
  const Team& team() const { return distribution_.team(); }
  /// Collective.
  bool due() const;
  /// Results up to its time must be on disk. Does nothing if it has been written already. One file for all processes.
  /// Collective.
  void write(const io::Checkpoint& checkpoint);

 private:
  io::Checkpoint whole() const;

  const config::Config& config_;
  const creep::Distribution& distribution_;
  std::filesystem::path path_;
  std::string fingerprint_;
  std::optional<double> written_;  // time of the last one
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace creepcontact::run
