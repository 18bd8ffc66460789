/// How well the forces balance at the end.
#include "creepcontact/results/equilibrium_residual.hpp"

#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class EquilibriumResidual final : public Observer {
 public:
  void output(StepView& view) override {
    if (!view.is_end) return;
    view.with_snapshot([&](results::Snapshot& snapshot) {
      residual_ = results::equilibrium_residual(snapshot);
      return std::vector<double>{};
    });
  }
  void finish(Summary& summary) const override { summary.results.accuracy.equilibrium_residual = residual_; }

 private:
  std::optional<double> residual_;  // in process 0
};

}  // namespace

std::unique_ptr<Observer> observe_equilibrium_residual(const RunContext& /*context*/) {
  return std::make_unique<EquilibriumResidual>();
}

}  // namespace creepcontact::run
