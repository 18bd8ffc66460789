#pragma once
/// The cycles of a run: cycles.csv, the end when they repeat, jumps over them.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "../run_context.hpp"
#include "closed_cycles.hpp"
#include "creepcontact/base/memory.hpp"
#include "creepcontact/io/tables/csv_file.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/load_cycles.hpp"
#include "creepcontact/run/observer.hpp"
#include "cycle_jumps.hpp"
#include "cycle_watch.hpp"

namespace creepcontact::run {

/// Follows a run through its cycles. Between two of them the run may jump over some (CycleJumps); the cycle after a
/// jump is tentative.
class Cycles final : public Observer {
 public:
  /// @param context  of a model with cycles; must outlive the object
  /// @throws ConfigError if cycles.csv cannot be written
  explicit Cycles(const RunContext& context);

  Reaction begin(StepView& view) override;
  Reaction step(StepView& view) override;
  Reaction segment(StepView& view) override;
  void jump(StepView& view) override;
  void state(StepView& view) override;
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
  /// A cycle ends at this state, as seen from its begin.
  Reaction close(std::int64_t cycle, StepView& view);
  /// Before this cycle.
  void go_to(std::int64_t cycle);
  void write(std::int64_t cycle, std::int64_t jumped, const CycleRecord& record, const RunCounters& work);
  std::string end_message() const;

  const RunContext& context_;
  const model::LoadCycles& loads_;
  CycleWatch watch_;
  ClosedCycles closed_;
  std::optional<CycleJumps> jumps_;
  std::unique_ptr<io::CsvFile> file_;  // in the process that writes
  Stage stage_ = Stage::between;
  std::optional<RunState> changed_;  // where the run goes on after a reaction
  std::int64_t cycle_ = 0;           // that is computed, or computed next
  io::Summary::Cycles summary_;
  RunCounters work_;  // up to the end of the last cycle
  static constexpr auto saved_members = std::tuple{Member{"work", &Cycles::work_}};
};

}  // namespace creepcontact::run
