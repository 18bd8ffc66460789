/// The course of the probes over the run: start, end and extremes.
#include "creepcontact/results/probe_record.hpp"
#include "creepcontact/run/summary.hpp"
#include "held.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class ProbeObserver final : public Observer {
 public:
  explicit ProbeObserver(const RunContext& context) : context_(context), record_(context.config.probes.size()) {}

  void state(StepView& view) override { add(view); }
  void jump(StepView& view) override { add(view); }
  Reaction segment(StepView& view) override {
    settle(view);
    return Reaction::advance;
  }
  void output(StepView& view) override { record_.output(view.time(), view.probe_values()); }
  void undo() override { held_.drop(); }
  void save(creep::Memory& memory) const override { record_.save(memory); }
  void restore(const creep::Memory& memory) override { record_.restore(memory); }
  void finish(Summary& summary) const override { record_.fill(context_.config, summary.results); }

 private:
  struct Values {
    double time;
    std::vector<double> probes;
  };
  void add(StepView& view) {
    held_.add({view.time(), view.probe_values()});
    settle(view);
  }
  void settle(const StepView& view) {
    held_.settle(view.is_tentative, [&](const Values& values) {
      record_.observe(values.time, values.probes, context_.config.time.tolerance);
    });
  }

  const RunContext& context_;
  results::ProbeRecord record_;
  Held<Values> held_;
};

}  // namespace

std::unique_ptr<Observer> observe_probes(const RunContext& context) {
  if (context.config.probes.empty()) return nullptr;
  return std::make_unique<ProbeObserver>(context);
}

}  // namespace creepcontact::run
