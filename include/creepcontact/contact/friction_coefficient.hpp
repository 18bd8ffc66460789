#pragma once
/// Coefficient of friction of a contact pair: a function of position, time and temperature.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::contact {

/// Value semantics; copies share what is immutable.
class FrictionCoefficient {
 public:
  /// No friction.
  FrictionCoefficient() = default;
  /// @param coefficient  of x, y, z, t, T @param temperature  used only if the coefficient depends on T
  FrictionCoefficient(Function coefficient, const std::optional<mechanics::TemperatureField>& temperature,
                      std::vector<Vector3> positions);

  /// One value per position. @throws ModelError if one is negative or not finite
  /// Cost: nothing to evaluate if the coefficient is constant.
  Eigen::VectorXd at(double t) const;

 private:
  Function coefficient_;
  std::vector<Vector3> positions_;
  std::shared_ptr<const mechanics::TemperatureAtPositions> temperature_;  // null: not needed
};

}  // namespace creepcontact::contact
