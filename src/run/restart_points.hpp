#pragma once
/// The newest state of a run from which it can be resumed: all its results are in files that are complete.

#include <chrono>
#include <optional>

#include "checkpoints.hpp"
#include "observer_list.hpp"

namespace creepcontact::run {

/// Keeps that state in memory, and writes it to disk. Field files are written while the run goes on: a state after them
/// becomes the newest one when they are complete. All calls are collective.
class RestartPoints {
 public:
  /// @param observers, checkpoints  must outlive the object
  RestartPoints(const ObserverList& observers, Checkpoints& checkpoints) : observers_(observers), files_(checkpoints) {}

  /// Whether to keep a state while the run goes on. Copies of a long one at every step would cost a twentieth of a run;
  /// what a failure loses without them is computed again in a second.
  /// @param size  of the state, in numbers
  bool is_worth_keeping(std::size_t size) const;
  /// The run may be resumed from this state. @throws Error if a file written before could not be completed
  void keep(io::Checkpoint here);
  /// Waits until the files under way are complete. @throws Error if they cannot be; the newest state is then before
  /// them
  void complete_files();
  /// Waits for them only if a state does: an output follows, whose files that state does not need.
  void complete_files_before_output() {
    if (after_files_) complete_files();
  }
  /// Writes the newest state to disk, if there is one; the files of its results before it. @throws as complete_files()
  void write();
  /// Time of the newest state; nullopt: there is none yet.
  std::optional<double> newest_time() const { return newest_ ? std::optional(newest_->time) : std::nullopt; }
  /// Time since the last checkpoint has become long.
  bool is_due() const { return files_.due(); }

 private:
  const ObserverList& observers_;
  Checkpoints& files_;
  std::optional<io::Checkpoint> newest_, after_files_;  // the latter for when the files under way are complete
  std::chrono::steady_clock::time_point kept_;          // when keep() was called last
};

}  // namespace creepcontact::run
