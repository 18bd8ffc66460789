/// Lengths, orders and errors of the steps.
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class StepStatisticsObserver final : public Observer {
 public:
  Reaction step(StepView& view) override {
    steps_.add(view.step->report);
    return Reaction::advance;
  }
  void finish(Summary& summary) const override {
    summary.steps = steps_;
    summary.results.accuracy.mean_step_error = steps_.mean_error();
    summary.results.accuracy.largest_step_error = steps_.largest_error();
  }

 private:
  StepStatistics steps_;
};

}  // namespace

std::unique_ptr<Observer> observe_step_statistics(const RunContext& context) {
  if (!context.integrates) return nullptr;
  return std::make_unique<StepStatisticsObserver>();
}

}  // namespace creepcontact::run
