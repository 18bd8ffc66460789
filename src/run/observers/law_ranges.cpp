/// Stresses and temperatures outside the range in which tables and creep laws hold.
#include "creepcontact/model/range_monitor.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class LawRanges final : public Observer {
 public:
  explicit LawRanges(const RunContext& context) : context_(context), monitor_(context.config) {}

  void state(StepView& view) override { observe(view); }
  void jump(StepView& view) override { observe(view); }
  void output(StepView& view) override { observe(view); }
  void end(End how) override {
    if (how == End::completed || how == End::ruptured) monitor_.finish();
  }

 private:
  void observe(StepView& view) {
    const creep::Evaluation& at = view.evaluation();
    const creep::Assembly& assembly = context_.system().assembly();
    monitor_.observe(at.time, assembly.bodies(), at.equilibrium, context_.team());
    monitor_.observe(assembly.pairs(), at.equilibrium);
  }

  const RunContext& context_;
  model::RangeMonitor monitor_;
};

}  // namespace

std::unique_ptr<Observer> observe_law_ranges(const RunContext& context) {
  return std::make_unique<LawRanges>(context);
}

}  // namespace creepcontact::run
