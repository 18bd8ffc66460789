#include "whole_state.hpp"

namespace creepcontact::run {

WholeState::WholeState(const creep::Distribution& distribution, creep::CreepSystem& system)
    : distribution_(distribution), system_(system) {
  if (distribution.team().size() > 1) laws_.emplace(distribution.whole(), system.laws().min_strain());
}

std::vector<double> WholeState::look(double t, std::span<const double> y,
                                     const std::function<std::vector<double>(results::Snapshot&)>& f) {
  return look_at(t, system_.evaluate_output(t, y), f);
}

std::vector<double> WholeState::look_at(double t, const creep::Evaluation& own,
                                        const std::function<std::vector<double>(results::Snapshot&)>& f) {
  const creep::BodyLaws& laws = laws_ ? *laws_ : system_.laws();
  const creep::Evaluation& at = distribution_.gather(own, laws, space_);
  std::vector<double> result;
  together(distribution_.team(), [&] {
    if (!distribution_.is_root()) return;
    results::Snapshot snapshot(laws, system_.solver().interface(), t, at);
    result = f(snapshot);
  });
  broadcast(distribution_.team(), result, 0);
  return result;
}

}  // namespace creepcontact::run
