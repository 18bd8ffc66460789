#include "step_extremes.hpp"

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

namespace creepcontact::run {

StepExtremes::StepExtremes(WholeState& whole, std::span<const std::unique_ptr<results::Probe>> probes,
                           results::Outcome& outcome, results::ProbeRecord& record,
                           results::SmallStrainMonitor& strains, double tolerance)
    : whole_(whole), probes_(probes), outcome_(outcome), record_(record), strains_(strains), tolerance_(tolerance) {}

void StepExtremes::see(double t, const creep::Evaluation& at) {
  const creep::CreepSystem& system = whole_.system();
  results::StepValues& values =
      seen_.emplace_back(results::Outcome::values(system.assembly(), t, at.equilibrium, system.team()));
  outcome_.see_contacts(t, at.equilibrium);
  strains_.see(t, at);
  if (probes_.empty()) return;
  values.probes =
      whole_.look_at(t, at, [&](results::Snapshot& snapshot) { return results::probe_values(probes_, snapshot); });
}

void StepExtremes::see_between(double t, std::span<const double> y) {
  try {
    see(t, whole_.system().evaluate_accepted(t, y));
  } catch (const Error& error) {
    log::warning("at t = {:.10g}, between output times, no equilibrium is found: {}", t, error.what());
  }
}

void StepExtremes::keep() {
  for (const results::StepValues& values : seen_) {
    outcome_.see(values);
    record_.see(values.time, values.probes, tolerance_);
  }
  seen_.clear();
}

}  // namespace creepcontact::run
