/// Strains and rotations that are no longer small.
#include <algorithm>

#include "creepcontact/base/log.hpp"
#include "creepcontact/results/small_strain_monitor.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class SmallStrains final : public Observer {
 public:
  explicit SmallStrains(const RunContext& context) : monitor_(context.system()) {}

  void state(StepView& view) override { observe(view); }
  void jump(StepView& view) override { observe(view); }
  void output(StepView& view) override { observe(view); }
  void save(creep::Memory& memory) const override { monitor_.save(memory); }
  void restore(const creep::Memory& memory) override { monitor_.restore(memory); }
  void end(End /*how*/) override {
    for (const std::string& warning : monitor_.warnings()) log::warning("{}", warning);
  }
  /// Those of the run that this one continues, with smaller values, are replaced.
  void finish(Summary& summary) const override {
    const std::vector<std::string> own = monitor_.warnings();
    std::erase_if(summary.results.warnings, [&](const std::string& text) {
      return results::SmallStrainMonitor::is_warning(text) && std::ranges::find(own, text) == own.end();
    });
    for (const std::string& text : own) summary.add_warning(text);
  }

 private:
  void observe(StepView& view) { monitor_.observe(view.time(), view.evaluation()); }

  results::SmallStrainMonitor monitor_;
};

}  // namespace

std::unique_ptr<Observer> observe_small_strains(const RunContext& context) {
  return std::make_unique<SmallStrains>(context);
}

}  // namespace creepcontact::run
