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
  void output(StepView& view) override { record_.output(view.time(), view.probe_values()); }
  void keep() override { held_.keep(); }
  void undo() override { held_.undo(); }
  void save(creep::Memory& memory) const override { record_.save(memory); }
  void restore(const creep::Memory& memory) override { record_.restore(memory); }
  void finish(Summary& summary) const override { record_.fill(context_.config, summary.results); }

 private:
  struct Values {
    double time;
    std::vector<double> probes;
  };
  void add(StepView& view) { held_.add({view.time(), view.probe_values()}, view.is_tentative); }

  const RunContext& context_;
  results::ProbeRecord record_;
  Held<Values> held_{
      [this](const Values& values) { record_.observe(values.time, values.probes, context_.config.time.tolerance); }};
};

}  // namespace

std::unique_ptr<Observer> observe_probes(const RunContext& context) {
  if (context.config.probes.empty()) return nullptr;
  return std::make_unique<ProbeObserver>(context);
}

}  // namespace creepcontact::run
