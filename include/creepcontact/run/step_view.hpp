#pragma once
/// A state of a run as its observers see it.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/creep/distribution.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/results/probes.hpp"
#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::run {

/// The system of a run with its probes. Each process has a part of the state; process 0 gathers it for results.
class ObservedSystem {
 public:
  /// @param distribution, system (of its own part), probes  must outlive the object
  ObservedSystem(const creep::Distribution& distribution, creep::CreepSystem& system,
                 std::span<const std::unique_ptr<results::Probe>> probes);

  creep::CreepSystem& system() { return system_; }
  const Team& team() const { return distribution_.team(); }
  bool is_root() const { return distribution_.is_root(); }
  std::span<const std::unique_ptr<results::Probe>> probes() const { return probes_; }

 private:
  friend class StepView;
  const creep::BodyLaws& laws() const { return laws_ ? *laws_ : system_.laws(); }

  const creep::Distribution& distribution_;
  creep::CreepSystem& system_;
  std::span<const std::unique_ptr<results::Probe>> probes_;
  std::optional<creep::BodyLaws> laws_;  // of the whole model, if the system has only a part of it
  creep::Evaluation gathered_;
};

/// What a step was.
struct StepMade {
  ode::StepReport report;
  RunCounters work;  ///< of this step
  std::int64_t n_active_contacts = 0;
};

/// A time and a state, evaluated at first use. Valid within the call that gets it, and as long as nothing else is
/// evaluated there.
class StepView {
 public:
  /// Which evaluation represents the state.
  enum class Source {
    exact,     ///< at this very state; needs an elastic solve if the last step has not made it
    accepted,  ///< the one that the last step has made, within its tolerance; solved only if there is none
    result     ///< exact, with slip and dissipated energy that never fall from one result to the next
  };
  /// @param observed, y  must outlive the view @param steps  work that the system does not count: see work()
  StepView(ObservedSystem& observed, double time, std::span<const double> y, Source source, const RunCounters& steps)
      : observed_(observed), time_(time), y_(y), source_(source), steps_(steps) {}

  double time() const { return time_; }
  std::span<const double> y() const { return y_; }
  creep::CreepSystem& system() { return observed_.system(); }
  /// Work of the run up to now, with that of the runs that it continues.
  RunCounters work() const { return steps_ + observed_.system().run_counters(); }

  const StepMade* step = nullptr;  ///< the step that ends here; null but in Observer::step()
  bool is_tentative = false;       ///< the run may go back to before this state
  bool is_end = false;             ///< the run ends here

  /// The evaluation of the part of this process. @throws RecoverableError if there is no equilibrium
  const creep::Evaluation& evaluation();
  /// Calls f in process 0, with the state of the whole model. An error there is one in all. Collective.
  /// @returns what f returns, in all processes @throws as evaluation()
  std::vector<double> with_snapshot(const std::function<std::vector<double>(results::Snapshot&)>& f);
  /// Values of all probes, computed at the first call. Collective. @throws as evaluation()
  const std::vector<double>& probe_values();

 private:
  ObservedSystem& observed_;
  double time_;
  std::span<const double> y_;
  Source source_;
  RunCounters steps_;
  const creep::Evaluation* evaluation_ = nullptr;
  const creep::Evaluation* whole_ = nullptr;
  std::optional<results::Snapshot> snapshot_;  // in process 0
  std::optional<std::vector<double>> probe_values_;
};

}  // namespace creepcontact::run
