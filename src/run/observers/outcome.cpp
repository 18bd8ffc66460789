/// Contact forces and stresses at the start, at their largest and at the end; contacts that open or never carry.
#include "creepcontact/results/outcome.hpp"

#include "creepcontact/base/log.hpp"
#include "creepcontact/run/summary.hpp"
#include "held.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class OutcomeObserver final : public Observer {
 public:
  explicit OutcomeObserver(const RunContext& context) : context_(context), outcome_(context.assembly()) {}

  void state(StepView& view) override { add(view); }
  void jump(StepView& view) override { add(view); }
  void output(StepView& view) override {
    view.with_snapshot([&](results::Snapshot& snapshot) {
      outcome_.output(view.time(), snapshot.equilibrium());
      return std::vector<double>{};
    });
  }
  void keep() override { held_.keep(); }
  void undo() override { held_.undo(); }
  void save(creep::Memory& memory) const override { outcome_.save(memory); }
  void restore(const creep::Memory& memory) override { outcome_.restore(memory); }
  void end(End how) override {
    if (how != End::completed || !context_.observed.is_root()) return;
    outcome_.warn_of_open_contacts();
    for (const std::string& warning : outcome_.narrow_contacts()) log::warning("{}", warning);
  }
  void finish(Summary& summary) const override { outcome_.fill(summary.results, context_.config.time.cycle); }

 private:
  void add(StepView& view) {
    const creep::Evaluation& at = view.evaluation();
    held_.add(results::Outcome::values(view.system().assembly(), view.time(), at.equilibrium, context_.team()),
              view.is_tentative);
    outcome_.observe_contacts(view.time(), at.equilibrium);
  }

  const RunContext& context_;
  results::Outcome outcome_;
  Held<results::StepValues> held_{[this](const results::StepValues& values) { outcome_.observe(values); }};
};

}  // namespace

std::unique_ptr<Observer> observe_outcome(const RunContext& context) {
  return std::make_unique<OutcomeObserver>(context);
}

}  // namespace creepcontact::run
