#pragma once
/// The times that steps of the heat must not pass.

#include <functional>
#include <optional>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/heat/history.hpp"
#include "creepcontact/model/step_guard.hpp"
#include "creepcontact/model/step_limits.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

/// A few nodes, at which functions of place and time represent all others.
std::vector<Vector3> some_places(const mesh::Mesh& mesh);
/// Those of all bodies.
std::vector<Vector3> some_places(const BodyMeshes& meshes);

/// Found in the functions of the configuration that act by the temperature alone. Immutable.
class HeatStops {
 public:
  /// @param places  at which functions are looked at @param T  likewise @param end  of the run; 0: there are none
  /// Cost: about 40 000 evaluations of each function per place
  HeatStops(const config::Config& config, const std::vector<Vector3>& places, double T, double end);

  /// With jumps, ascending, within the run: the integration starts again there.
  const std::vector<double>& kinks() const { return kinks_; }
  std::vector<double> kinks_and_turns() const;
  /// heat::HistoryOptions::end_of_step: at turns, and before what the guard of steps finds. The stops must outlive it.
  std::function<double(double, double, double, double)> end_of_step() const;
  /// Whether all functions repeat, and from when on; nullopt: some do not, or not often enough.
  const std::optional<heat::Repeats>& repeats() const { return repeats_; }

 private:
  double end_;
  std::vector<double> kinks_, turns_;
  StepLimits limits_;  // where functions vibrate
  StepGuard guard_;
  std::optional<heat::Repeats> repeats_;
};

}  // namespace creepcontact::model
