#pragma once
/// The cycles of a run: cycles.csv, the end when they repeat, jumps over them.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "checkpoints.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/io/tables/csv_file.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/load_cycles.hpp"
#include "creepcontact/ode/cycle_extrapolation.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "cycle_watch.hpp"

namespace creepcontact::run {

/// Sees a run go through its cycles, and says where it goes on. Between two cycles the run asks for a jump(), then
/// tells of begin(), of every step and breakpoint, and of the end by close(). Calls are collective.
class Cycles {
 public:
  /// @param loads, system, whole, probes  must outlive the object
  /// @param memory  of the checkpoint that the run is resumed from, at `time`; null: a new run
  /// @throws ConfigError if cycles.csv cannot be written
  Cycles(const config::Config& config, const model::LoadCycles& loads, creep::CreepSystem& system, WholeState& whole,
         std::span<const std::unique_ptr<results::Probe>> probes, const std::filesystem::path& directory, double time,
         const creep::Memory* memory);

  /// True between two cycles: the next one has not begun.
  bool is_between() const { return stage_ == Stage::between; }
  /// True where nothing that has been seen of a cycle under way would be lost.
  bool may_be_resumed() const { return stage_ != Stage::within; }
  /// True within the cycle after a jump. Nothing of it is a result before it is closed.
  bool is_checking() const { return jumps_ && jumps_->is_checking(); }

  /// Between two cycles at time t: the time to which to jump, with the state there; nullopt: the next cycle is
  /// computed.
  /// @param next_output  no output time lies in the cycles passed over, nor within the one after them
  std::optional<double> jump(double t, double next_output, std::span<double> y);
  void begin(double t, std::span<const double> y);

  void step(const ode::StepReport& report, std::span<const double> y);
  /// A breakpoint, before the loads change there.
  void see(double t, std::span<const double> y);
  /// The same after they have changed; an evaluation if they jump there.
  void see_after_jump(double t, std::span<const double> y);
  /// Values of the probes at an output time.
  void see_probes(std::span<const double> values) {
    if (stage_ == Stage::within) watch_.see_probes(values);
  }

  /// What becomes of the run at the end of a cycle.
  struct Closed {
    double time = 0;             ///< at which it goes on: earlier, if a jump has been rejected
    bool state_changed = false;  ///< the integrator must start anew
    bool is_steady = false;      ///< the run is to end
    bool is_rejected = false;
  };
  /// At time t, if a cycle ends there, after see(). @param work  of the run so far @param y  the state, changed if
  /// `state_changed`
  Closed close(double t, const RunCounters& work, std::span<double> y);
  /// Takes the run back to before the last jump, because something must not be passed over: an event, rupture, a step
  /// that fails. @returns the time there; y is the state
  double go_back(std::span<double> y);

  /// If the run has ended because its cycles repeat, what to say of it.
  std::string end_message() const;
  void fill(io::Summary& summary) const;
  void save(creep::Memory& memory) const;
  /// Waits until all rows are on the disk itself. @throws Error if it cannot take them
  void sync() const;

 private:
  enum class Stage {
    waiting,  // for the end of a cycle that has not been seen from its begin; after the last one for good
    between,
    within
  };
  void restore(const creep::Memory& memory);
  /// Before this cycle.
  void go_to(std::int64_t cycle);
  std::int64_t longest_jump(std::int64_t cycle, double next_output) const;
  ode::CycleExtrapolation::Damping damping(std::span<const double> change);
  /// A life that has been used up stays so, wherever the last rates lead back to. @param jumped  cycles before this one
  void keep_limits(CycleRecord& record, std::int64_t cycle, std::int64_t jumped);
  /// See Summary::Cycles::last_change.
  std::optional<double> last_change(const CycleRecord& record, std::int64_t cycle) const;
  void write(std::int64_t cycle, std::int64_t jumped, const CycleRecord& record, const RunCounters& work);

  const config::Config& config_;
  const model::LoadCycles& loads_;
  creep::CreepSystem& system_;
  CycleWatch watch_;
  std::optional<ode::CycleExtrapolation> jumps_;
  std::unique_ptr<io::CsvFile> file_;  // in the process that writes
  Stage stage_ = Stage::between;
  std::int64_t cycle_ = 0;   // that is computed, or computed next
  std::int64_t bound_ = -1;  // cycle that no jump may reach
  io::Summary::Cycles summary_;
  std::vector<double> first_;           // the state at the begin of the cycle
  std::vector<double> previous_range_;  // of the probes in the last cycle closed
  std::int64_t previous_ = -1;          // its number
  RunCounters work_;                    // up to there
  std::vector<double> used_up_;         // after how many cycles the life of a body was; infinity: it is not

  /// Where in a cycle the state changes most.
  struct Activity {
    double change = 0, time = 0;
    std::vector<double> state;
  };
  Activity activity_;
  std::vector<double> last_step_;
};

}  // namespace creepcontact::run
