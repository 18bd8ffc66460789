/// Whether friction may allow several states under the same loads, at the start and at the end.
#include "creepcontact/contact/solver/friction_uniqueness.hpp"

#include "creepcontact/base/log.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class FrictionUniqueness final : public Observer {
 public:
  void output(StepView& view) override {
    if (view.time() != 0 && !view.is_end) return;
    view.with_snapshot([&](results::Snapshot& snapshot) {
      observe(view, snapshot.equilibrium());
      return std::vector<double>{};
    });
  }
  void finish(Summary& summary) const override { summary.results.friction_kappa = largest_; }

 private:
  void observe(StepView& view, const creep::Equilibrium& at) {
    const contact::CondensedInterface& interface = view.system().solver().interface();
    const auto kappa = contact::friction_kappa(interface.problem(), interface.rows().friction(at.time), at.contact);
    if (!kappa) return;
    if (*kappa > 1 && !(largest_.value_or(0) > 1))
      log::warning(
          "friction: kappa = {:.3g} at t = {:.6g}. Above 1 the bodies may lock, and several states of stick and slip "
          "may be possible under the same loads; the run follows the one that the loading from the unloaded state "
          "leads to (docs/friction.md)",
          *kappa, at.time);
    largest_ = std::max(largest_.value_or(0), *kappa);
  }

  std::optional<double> largest_;  // contact::friction_kappa()
};

}  // namespace

std::unique_ptr<Observer> observe_friction_uniqueness(const RunContext& context) {
  if (!context.system().has_friction()) return nullptr;
  return std::make_unique<FrictionUniqueness>();
}

}  // namespace creepcontact::run
