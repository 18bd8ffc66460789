/// Events: the first times at which conditions on probes hold, and the end of a run by one of them.
#include "creepcontact/results/event_watch.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class EventObserver final : public Observer {
 public:
  explicit EventObserver(const RunContext& context) : watch_(context.config, context.observed.probes()) {}

  /// An event must not lie in a jump over cycles.
  Reaction step(StepView& view) override {
    return view.is_tentative && !conditions(view).empty() ? Reaction::go_back : Reaction::advance;
  }

  std::vector<std::size_t> conditions(StepView& view) const override {
    if (!watch_.is_waiting()) return {};
    const std::vector<double> found = view.with_snapshot([&](results::Snapshot& snapshot) {
      const std::vector<std::size_t> numbers = watch_.holding(snapshot);
      return std::vector<double>(numbers.begin(), numbers.end());
    });
    std::vector<std::size_t> numbers;
    for (const double number : found) numbers.push_back(static_cast<std::size_t>(number));
    return numbers;
  }
  bool holds(std::size_t number, StepView& view) const override {
    return !view.with_snapshot([&](results::Snapshot& snapshot) {
                  return std::vector<double>(watch_.holds(number, snapshot) ? 1 : 0);
                })
                .empty();
  }
  void happened(std::size_t number, StepView& view) override { watch_.happened(number, view.time()); }
  bool stops(std::size_t number) const override { return watch_.stops(number); }

  void save(creep::Memory& memory) const override { watch_.save(memory); }
  void restore(const creep::Memory& memory) override { watch_.restore(memory); }
  void finish(Summary& summary) const override { watch_.fill(summary.results); }

 private:
  results::EventWatch watch_;
};

}  // namespace

std::unique_ptr<Observer> observe_events(const RunContext& context) {
  if (context.config.events.empty()) return nullptr;
  return std::make_unique<EventObserver>(context);
}

}  // namespace creepcontact::run
