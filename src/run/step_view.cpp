#include "creepcontact/run/step_view.hpp"

namespace creepcontact::run {

ObservedSystem::ObservedSystem(const creep::Distribution& distribution, creep::CreepSystem& system,
                               std::span<const std::unique_ptr<results::Probe>> probes)
    : distribution_(distribution), system_(system), probes_(probes) {
  if (distribution.team().size() > 1) laws_.emplace(distribution.whole(), system.laws().min_strain());
}

const creep::Evaluation& StepView::evaluation() {
  if (evaluation_ != nullptr) return *evaluation_;
  switch (source_) {
    case Source::exact:
      evaluation_ = &system().evaluate_output(time_, y_);
      break;
    case Source::accepted:
      evaluation_ = &system().evaluate_accepted(time_, y_);
      break;
    case Source::result:
      evaluation_ = &system().evaluate_result(time_, y_);
      break;
  }
  return *evaluation_;
}

std::vector<double> StepView::with_snapshot(const std::function<std::vector<double>(results::Snapshot&)>& f) {
  const creep::Evaluation& own = evaluation();
  if (whole_ == nullptr) whole_ = &observed_.distribution_.gather(own, observed_.laws(), observed_.gathered_);
  std::vector<double> result;
  together(observed_.team(), [&] {
    if (!observed_.is_root()) return;
    if (!snapshot_) snapshot_.emplace(observed_.laws(), system().solver().interface(), time_, *whole_);
    result = f(*snapshot_);
  });
  broadcast(observed_.team(), result, 0);
  return result;
}

const std::vector<double>& StepView::probe_values() {
  if (observed_.probes().empty()) return probe_values_ ? *probe_values_ : probe_values_.emplace();
  if (!probe_values_)
    probe_values_ =
        with_snapshot([&](results::Snapshot& snapshot) { return results::probe_values(observed_.probes(), snapshot); });
  return *probe_values_;
}

}  // namespace creepcontact::run
