/// Events: the first times at which conditions on probes hold, and the end of a run by one of them.
#include "creepcontact/run/summary.hpp"
#include "event_conditions.hpp"

namespace creepcontact::run {
namespace {

class EventObserver final : public EventConditions {
 public:
  explicit EventObserver(const RunContext& context) : EventConditions(context) {}

  /// An event must not lie in a jump over cycles.
  Reaction step(StepView& view) override {
    return view.is_tentative && !conditions(view).empty() ? Reaction::go_back : Reaction::advance;
  }
  void happened(std::size_t number, StepView& view) override { watch().happened(number, view.time()); }
  bool stops(std::size_t number) const override { return watch().stops(number); }

  void save(creep::Memory& memory) const override { watch().save(memory); }
  void restore(const creep::Memory& memory) override { watch().restore(memory); }
  void finish(Summary& summary) const override { watch().fill(summary.results); }

 private:
  bool is_waiting(std::size_t event) const override { return watch().is_waiting(event); }
};

}  // namespace

std::unique_ptr<Observer> observe_events(const RunContext& context) {
  if (context.config.events.empty()) return nullptr;
  return std::make_unique<EventObserver>(context);
}

}  // namespace creepcontact::run
