#include "creepcontact/contact/friction_coefficient.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {

FrictionCoefficient::FrictionCoefficient(Function coefficient,
                                         const std::optional<mechanics::TemperatureField>& temperature,
                                         std::vector<Vector3> positions)
    : coefficient_(std::move(coefficient)), positions_(std::move(positions)) {
  if (temperature && coefficient_.depends_on_temperature()) temperature_ = temperature->at(positions_);
}

Eigen::VectorXd FrictionCoefficient::at(double t) const {
  const Index n = std::ssize(positions_);
  if (coefficient_.is_constant()) return Eigen::VectorXd::Constant(n, coefficient_({}));
  std::vector<double> temperature(positions_.size(), 0.0);
  mechanics::TemperatureMemo memo;
  if (temperature_) temperature_->evaluate(t, temperature, memo);
  Eigen::VectorXd values(n);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const Vector3& x = positions_[i];
    const double value = coefficient_({.x = x.x(), .y = x.y(), .z = x.z(), .t = t, .T = temperature[i]});
    if (!(value >= 0) || !std::isfinite(value))
      throw ModelError(
          fmt::format("the coefficient of friction is {:.6g} at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}; it "
                      "must be a number of at least 0",
                      value, x.x(), x.y(), x.z(), t));
    values[static_cast<Index>(i)] = value;
  }
  return values;
}

}  // namespace creepcontact::contact
