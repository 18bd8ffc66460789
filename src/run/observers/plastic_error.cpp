/// The estimated error of plastic flow.
#include "creepcontact/base/log.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

constexpr double noticed_error = 0.05;  // of the yield stress

class PlasticError final : public Observer {
 public:
  explicit PlasticError(const RunContext& context) : context_(context) {}

  void end(End /*how*/) override {
    if (error() > noticed_error)
      log::warning(
          "plastic flow: the estimated errors of its steps add up to {:.2g} of the yield stress: plastic strains that "
          "go on growing may be off by as much elastic strain; more time.breakpoints where something flows, or a "
          "smaller time.tolerance, reduce it",
          error());
  }
  void finish(Summary& summary) const override { summary.results.plastic_error = error(); }

 private:
  double error() const { return context_.system().history().plastic.error; }

  const RunContext& context_;
};

}  // namespace

std::unique_ptr<Observer> observe_plastic_error(const RunContext& context) {
  if (!context.system().has_yielding()) return nullptr;
  return std::make_unique<PlasticError>(context);
}

}  // namespace creepcontact::run
