#pragma once
/// A temperature of place and time: a function of the user's, or values at scattered points at one or several times.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

/// Temperatures known at points. Linear between the times, constant before the first and after the last.
struct ScatteredTemperatures {
  std::vector<Vector3> points;              ///< no two the same
  std::vector<double> times;                ///< increasing; one: steady
  std::vector<std::vector<double>> values;  ///< one list a time, a value a point
};

/// Temperatures interpolated to places at the two given times around the last evaluation. Owned by whoever evaluates;
/// it changes the cost of an evaluation, not its value.
struct TemperatureMemo {
  struct AtTime {
    std::optional<std::size_t> time;  ///< index of the given time
    std::vector<double> values;       ///< one per place
  };
  AtTime before, after;
};

/// Temperatures at places that were chosen once, so that what depends on the places alone is done once. Immutable.
class TemperatureAtPlaces {
 public:
  virtual ~TemperatureAtPlaces() = default;
  /// @param values  one per place
  virtual void evaluate(double t, std::span<double> values, TemperatureMemo& memo) const = 0;
};

/// Value semantics; copies share the immutable definition.
class TemperatureField {
 public:
  /// Of x, y, z, t. Evaluation is as safe for threads as that of the function.
  TemperatureField(Function value);  // NOLINT(google-explicit-constructor): a function is a field
  /// Interpolated between the points (ScatteredInterpolation).
  explicit TemperatureField(ScatteredTemperatures given);

  double operator()(const Arguments& at) const;
  std::unique_ptr<const TemperatureAtPlaces> at(std::span<const Vector3> places) const;

  bool depends_on_place() const;
  bool depends_on_time() const;
  /// Times up to `end` at which it is known to have kinks or jumps, increasing.
  std::vector<double> breakpoints(double end) const;
  /// Distance to the nearest point if the place is so far outside the points that this one alone counts there, else 0.
  double distance_outside(const Vector3& place) const;
  /// Two fields of the same text are the same.
  const std::string& text() const;

  struct Definition;

 private:
  std::shared_ptr<const Definition> definition_;
};

}  // namespace creepcontact::mechanics
