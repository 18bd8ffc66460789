/// Criteria: what the run is judged by.
#include "creepcontact/results/criteria.hpp"

#include <cmath>
#include <limits>

#include "creepcontact/run/summary.hpp"
#include "held.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class CriteriaObserver final : public Observer {
 public:
  explicit CriteriaObserver(const RunContext& context)
      : watch_(context.config, context.model, context.observed.probes()) {}

  void state(StepView& view) override { add(view); }
  void jump(StepView& view) override { add(view); }
  void output(StepView& view) override { add(view); }
  void keep() override { held_.keep(); }
  void undo() override { held_.undo(); }

  /// A time that counts must not lie in a jump over cycles.
  Reaction step(StepView& view) override {
    return view.is_tentative && !watch_.due(view.time()).empty() ? Reaction::go_back : Reaction::advance;
  }
  std::vector<std::size_t> conditions(StepView& view) const override { return watch_.due(view.time()); }
  bool holds(std::size_t number, StepView& view) const override { return watch_.is_due(number, view.time()); }
  void happened(std::size_t number, StepView& view) override {
    const std::size_t criterion = watch_.criterion_of(number);
    const std::vector<double> found =
        view.with_snapshot([&](results::Snapshot& snapshot) { return watch_.findings_of(criterion, snapshot); });
    std::vector<double> all(results::Finding::n_numbers * watch_.n_criteria(),
                            std::numeric_limits<double>::quiet_NaN());
    std::ranges::copy(found, all.begin() + static_cast<std::ptrdiff_t>(results::Finding::n_numbers * criterion));
    watch_.judge(view.time(), all);
    watch_.pass(number);
  }

  void save(creep::Memory& memory) const override { watch_.save(memory); }
  void restore(const creep::Memory& memory) override { watch_.restore(memory); }
  void finish(Summary& summary) const override { watch_.fill(summary.results); }

 private:
  struct Findings {
    double time;
    std::vector<double> numbers;
  };
  void add(StepView& view) {
    std::vector<double> numbers =
        view.with_snapshot([this](results::Snapshot& snapshot) { return watch_.findings(snapshot); });
    held_.add({view.time(), std::move(numbers)}, view.is_tentative);
  }

  results::CriteriaWatch watch_;
  Held<Findings> held_{[this](const Findings& found) { watch_.judge(found.time, found.numbers); }};
};

}  // namespace

std::unique_ptr<Observer> observe_criteria(const RunContext& context) {
  if (context.config.criteria.empty()) return nullptr;
  return std::make_unique<CriteriaObserver>(context);
}

}  // namespace creepcontact::run
