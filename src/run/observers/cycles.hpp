#pragma once
/// The cycles of a run: cycles.csv, the end when they repeat, jumps over them.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../run_context.hpp"
#include "creepcontact/base/memory.hpp"
#include "creepcontact/io/tables/csv_file.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/load_cycles.hpp"
#include "creepcontact/ode/cycle_extrapolation.hpp"
#include "creepcontact/run/observer.hpp"
#include "cycle_watch.hpp"

namespace creepcontact::run {

/// Follows a run through its cycles. Between two of them it may make the run jump over some; the cycle after a jump is
/// tentative, and what it shows decides whether the jump holds.
class Cycles final : public Observer {
 public:
  /// @param context  of a model with cycles; must outlive the object
  /// @throws ConfigError if cycles.csv cannot be written
  explicit Cycles(const RunContext& context);

  Reaction begin(StepView& view) override;
  Reaction step(StepView& view) override;
  Reaction segment(StepView& view) override;
  void jump(StepView& view) override;
  void output(StepView& view) override;
  void change(RunState& state) override;
  bool may_go_back() const override { return jumps_ && jumps_->is_checking(); }
  bool at_restart_point() const override { return stage_ != Stage::within && !may_go_back(); }
  void save(creep::Memory& memory) const override;
  void restore(const creep::Memory& memory) override;
  void sync() override;
  void finish(Summary& summary) const override;

 private:
  enum class Stage {
    waiting,  // for the end of a cycle that has not been seen from its begin; after the last one for good
    between,
    within
  };
  /// The state after a jump over cycles from the present state; nullopt: the next cycle is computed.
  std::optional<RunState> jumped(const StepView& view);
  /// A cycle ends at this state, as seen from its begin.
  Reaction close(std::int64_t cycle, StepView& view);
  /// Before this cycle.
  void go_to(std::int64_t cycle);
  std::int64_t longest_jump(double t) const;
  ode::CycleExtrapolation::Damping damping(std::span<const double> change);
  /// A life that has been used up stays so, wherever the last rates lead back to. @param jumped  cycles before this one
  void clamp_used_life(CycleRecord& record, std::int64_t cycle, std::int64_t jumped);
  /// See Summary::Cycles::last_change.
  std::optional<double> last_change(const CycleRecord& record, std::int64_t cycle) const;
  void write(std::int64_t cycle, std::int64_t jumped, const CycleRecord& record, const RunCounters& work);
  std::string end_message() const;

  const RunContext& context_;
  const model::LoadCycles& loads_;
  CycleWatch watch_;
  std::optional<ode::CycleExtrapolation> jumps_;
  std::unique_ptr<io::CsvFile> file_;  // in the process that writes
  Stage stage_ = Stage::between;
  bool computes_next_ = false;       // the next cycle begins from the present state, whatever jump is possible
  std::optional<RunState> changed_;  // where the run goes on after a reaction
  std::int64_t cycle_ = 0;           // that is computed, or computed next
  std::int64_t bound_ = -1;          // cycle that no jump may reach
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
  static constexpr auto saved_members =
      std::tuple{Member{"bound", &Cycles::bound_}, Member{"previous", &Cycles::previous_},
                 Member{"previous_range", &Cycles::previous_range_}, Member{"work", &Cycles::work_},
                 Member{"used_up", &Cycles::used_up_}};
};

}  // namespace creepcontact::run
