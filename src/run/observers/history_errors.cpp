/// Estimated errors of what steps leave in the history: plastic flow, and the largest closures of gaskets.
#include <algorithm>

#include "creepcontact/base/log.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

constexpr double noticed_flow = 0.05;     // of the yield stress
constexpr double noticed_closure = 0.01;  // of the largest closure

class HistoryErrors final : public Observer {
 public:
  explicit HistoryErrors(const RunContext& context) : context_(context) {}

  static bool has_unloading(const RunContext& context) {
    return std::ranges::any_of(context.system().assembly().pairs(), unloads);
  }

  void end(End /*how*/) override {
    if (flow() > noticed_flow)
      log::warning(
          "plastic flow: the estimated errors of its steps add up to {:.2g} of the yield stress. Plastic strains that "
          "go on growing may be off by as much elastic strain; more time.breakpoints where something flows, or a "
          "smaller time.tolerance, reduce it",
          flow());
    if (closure() > noticed_closure)
      log::warning(
          "gaskets: a closure was largest within a step, and is known to {:.2g} of itself only. The pressure after "
          "unloading depends on it; time.breakpoints where the gasket is pressed most, or a smaller time.tolerance, "
          "make it exact",
          closure());
  }
  void finish(Summary& summary) const override {
    if (context_.system().has_yielding()) summary.results.plastic_error = flow();
    if (has_unloading(context_)) summary.results.gasket_error = closure();
  }

 private:
  double flow() const { return context_.system().history().plastic.error; }

  static bool unloads(const contact::Pair& pair) { return pair.gasket && pair.gasket->kind().law.has_history(); }

  /// The largest error of a node, relative to the largest closure of its gasket.
  double closure() const {
    const contact::GasketHistory& history = context_.system().history().gaskets;
    double result = 0;
    if (history.error.size() == 0) return result;
    for (const contact::Pair& pair : context_.system().assembly().pairs()) {
      if (!unloads(pair)) continue;
      const auto n = std::ssize(pair.coupling.nodes);
      const double largest = history.largest.segment(pair.first_node, n).maxCoeff();
      if (largest > 0) result = std::max(result, history.error.segment(pair.first_node, n).maxCoeff() / largest);
    }
    return result;
  }

  const RunContext& context_;
};

}  // namespace

std::unique_ptr<Observer> observe_history_errors(const RunContext& context) {
  if (!context.system().has_yielding() && !HistoryErrors::has_unloading(context)) return nullptr;
  return std::make_unique<HistoryErrors>(context);
}

}  // namespace creepcontact::run
