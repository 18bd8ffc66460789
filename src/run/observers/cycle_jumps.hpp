#pragma once
/// Jumps over cycles: where to, and whether the cycle computed after a jump confirms it.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../run_context.hpp"
#include "creepcontact/base/memory.hpp"
#include "creepcontact/model/load_cycles.hpp"
#include "creepcontact/ode/cycle_extrapolation.hpp"
#include "creepcontact/run/step_view.hpp"

namespace creepcontact::run {

/// Between two cycles the run may jump over some; the cycle after a jump is computed, and the jump is accepted if that
/// cycle is the extrapolated one within the tolerance. What has flowed (CreepSystem::flow) is extrapolated with the
/// state, and set in the system. Cycles are numbered from 0. Calls are collective.
class CycleJumps {
 public:
  /// @param context  of a model with cycles whose settings ask for jumps; must outlive the object
  /// @throws ConfigError if something may yield and there are several processes
  explicit CycleJumps(const RunContext& context);

  /// True from a jump to the end of the cycle after it.
  bool is_checking() const { return extrapolation_.is_checking(); }
  /// Number of cycles of the jump that is checked.
  std::int64_t jumped() const { return extrapolation_.jumped(); }

  /// Jumps from the begin of a cycle, if the cycles before it allow a jump. @param t  present time
  /// @param cycle  set to the one that is computed next @param y  set to the state at its begin
  /// @returns true if there is a jump
  bool jump(double t, std::int64_t& cycle, std::span<double> y);
  /// The cycle is computed from this state at its begin.
  void begin(std::span<const double> y);
  /// A step in it.
  void step(const StepView& view);
  /// Ends a cycle without a jump before it. @param before, after  its states
  void add(std::int64_t cycle, std::span<const double> before, std::span<const double> after);
  /// Ends the cycle after a jump. @param change  of the state in it @param y  state at its end; corrected if the jump
  /// is accepted, otherwise set to the state before the jump
  /// @returns true if it is accepted
  bool check(std::span<const double> change, std::span<double> y);
  /// Gives up the jump that is checked, because of something that no jump may pass over. @param cycle  of the check; no
  /// later jump reaches it @param y  set to the state before the jump
  void give_up(std::int64_t cycle, std::span<double> y);
  /// No jump from the begin of the next cycle.
  void skip_next() { skips_next_ = true; }
  /// Other loads begin with this cycle.
  void forget(std::int64_t next_cycle) { extrapolation_.begin(next_cycle); }

  /// Nothing is saved of the cycles before a jump while it is checked.
  void save(Memory& memory) const;
  void restore(const Memory& memory);

 private:
  std::int64_t longest(double t, std::int64_t cycle) const;
  ode::CycleExtrapolation::Damping damping(std::span<const double> change);
  /// A state, and what follows it here: its flow.
  static std::vector<double> joined(std::span<const double> y, std::span<const double> flow);
  std::vector<double> with_flow(std::span<const double> y) const { return joined(y, context_.system().flow()); }
  /// Sets the state, and the flow in the system.
  void take(std::span<const double> with_flow, std::span<double> y);

  const RunContext& context_;
  const model::LoadCycles& loads_;
  ode::CycleExtrapolation extrapolation_;
  bool skips_next_ = false;
  std::int64_t bound_ = -1;  // cycle that no jump may reach

  /// Where in a cycle the state changes most.
  struct Activity {
    double change = 0, time = 0;
    std::vector<double> state;
  };
  Activity activity_;
  std::vector<double> last_step_;   // the state at its end
  std::vector<double> first_flow_;  // at the begin of the cycle
  static constexpr auto saved_members = std::tuple{Member{"bound", &CycleJumps::bound_}};
};

}  // namespace creepcontact::run
