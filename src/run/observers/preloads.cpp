/// Preloads by force in bodies that yield. The interference of a preload is found for elastic bodies; where its stress
/// is beyond the yield stress, the force falls within the first steps.

#include <algorithm>
#include <cmath>

#include "creepcontact/base/log.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

constexpr double delay = 1e-3;            // of the rest of the run: creep has done little yet
constexpr double negligible_loss = 0.01;  // of the force

bool yields(const mechanics::Body& body) {
  return std::ranges::any_of(body.material().creep, [](const auto& law) { return law->yields(); });
}

double preload_force(const contact::Pair& pair, const creep::Equilibrium& at) {
  return -pair.interference_gap().dot(at.contact.multiplier.segment(pair.first_row, pair.coupling.n_rows()));
}

/// Examines each preload once, soon after it is applied, and warns if yielding has changed its force.
/// Cost: nothing but at these times, with two solves at most.
class PreloadWatch final : public Observer {
 public:
  explicit PreloadWatch(const RunContext& context) : system_(context.system()) {
    const double end = context.config.time.end;
    const std::vector<double>& breakpoints = context.model.breakpoints;
    const double resumed_at = context.resumed != nullptr ? context.begin : -1;
    const creep::Assembly& assembly = system_.assembly();
    if (std::ranges::none_of(assembly.bodies(), yields)) return;
    for (std::size_t p = 0; p < assembly.pairs().size(); ++p) {
      const auto& preload = assembly.pairs()[p].preload;
      if (!preload || preload->time >= end) continue;
      double time = preload->time + delay * (end - preload->time);
      const auto next = std::ranges::upper_bound(breakpoints, preload->time);
      if (next != breakpoints.end()) time = std::min(time, *next);
      if (time > resumed_at) due_.push_back({p, time});  // else it was examined before
    }
  }
  bool empty() const { return due_.empty(); }

  Reaction step(StepView& view) override {
    const double t = view.time();
    const auto is_due = [t](const Examination& examination) { return examination.time <= t; };
    if (std::ranges::none_of(due_, is_due)) return Reaction::advance;
    const auto forces = [&](std::span<const double> state) {
      const creep::Equilibrium& at = system_.evaluate_output(t, state).equilibrium;
      std::vector<double> result;
      for (const Examination& examination : due_)
        result.push_back(preload_force(system_.assembly().pairs()[examination.pair], at));
      return result;
    };
    const std::vector<double> now = forces(view.y()), elastic = forces(std::vector<double>(view.y().size()));
    for (std::size_t i = 0; i < due_.size(); ++i)
      if (is_due(due_[i])) warn(due_[i].pair, t, now[i], elastic[i]);
    std::erase_if(due_, is_due);
    return Reaction::advance;
  }

 private:
  struct Examination {
    std::size_t pair;
    double time;  // from which on it is due
  };
  void warn(std::size_t p, double t, double force, double elastic) const {
    const contact::Pair& pair = system_.assembly().pairs()[p];
    const double asked = pair.preload.value().force, lost = elastic - force;
    if (!(std::abs(lost) > negligible_loss * asked) || system_.team().rank() != 0) return;
    log::warning(
        "contact '{}': the material yields under its preload: at t = {:.6g} the normal force is {:.6g}, without "
        "inelastic "
        "strain it would be {:.6g}; preload.force asks for {:.6g} at t = {:.6g}, which is met before anything yields. "
        "If "
        "{:.6g} shall be left after tightening, ask for about {:.6g} and compare again",
        pair.name, t, force, elastic, asked, pair.preload->time, asked, asked * elastic / std::max(force, asked / 4));
  }

  creep::CreepSystem& system_;
  std::vector<Examination> due_;
};

}  // namespace

std::unique_ptr<Observer> observe_preloads(const RunContext& context) {
  if (!context.integrates) return nullptr;
  auto watch = std::make_unique<PreloadWatch>(context);
  if (watch->empty()) return nullptr;
  return watch;
}

}  // namespace creepcontact::run
