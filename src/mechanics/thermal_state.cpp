#include "thermal_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"

namespace creepcontact::mechanics {

namespace {

Moduli moduli_at(const material::Material& material, double temperature) {
  const double young_modulus = material.young_modulus({.T = temperature});
  const double poisson_ratio = material.poisson_ratio({.T = temperature});
  if (!(young_modulus > 0) || !(poisson_ratio > -1 && poisson_ratio < 0.5)) {
    throw ModelError(
        fmt::format("material '{}' at the temperature {:g}: young_modulus {:g} must be positive and poisson_ratio {:g} "
                    "between -1 and 0.5 (excluded); mend the functions of T",
                    material.name, temperature, young_modulus, poisson_ratio));
  }
  return material::lame(young_modulus, poisson_ratio);
}

}  // namespace

ThermalState::ThermalState(std::optional<TemperatureField> temperature, const Discretization& discretization)
    : field_(std::move(temperature)), n_points_(discretization.n_points()) {
  if (field_) at_points_ = field_->at(discretization.point_coordinates());
}

std::span<const double> ThermalState::temperature(double t) {
  if (!field_) return {};
  const bool current = temperature_time_ && (*temperature_time_ == t || !changes_in_time());
  if (!current) {
    temperature_.resize(n_points_);
    at_points_->evaluate(t, temperature_);
    temperature_time_ = t;
  }
  return temperature_;
}

std::span<const double> ThermalState::strain(const material::Material& material, double t) {
  if (!field_ || material.thermal_expansion.is_zero()) return {};
  const bool current = strain_time_ && (*strain_time_ == t || !changes_in_time());
  if (!current) {
    const auto at_points = temperature(t);
    strain_.resize(at_points.size());
    for (std::size_t p = 0; p < strain_.size(); ++p)
      strain_[p] = material.thermal_expansion({.T = at_points[p]}) * (at_points[p] - material.reference_temperature);
    strain_time_ = t;
  }
  return strain_;
}

bool ThermalState::moduli_change_in_time(const material::Material& material) const {
  return changes_in_time() &&
         (material.young_modulus.depends_on_temperature() || material.poisson_ratio.depends_on_temperature());
}

std::span<const Moduli> ThermalState::moduli(const material::Material& material, double t) {
  if (moduli_time_ && (*moduli_time_ == t || !moduli_change_in_time(material))) return moduli_;
  moduli_time_.reset();  // stays unset if something below throws
  moduli_.clear();
  const bool varies =
      material.young_modulus.depends_on_temperature() || material.poisson_ratio.depends_on_temperature();
  if (!varies || !field_)
    moduli_.push_back(moduli_at(material, material.reference_temperature));
  else if (!field_->depends_on_place())
    moduli_.push_back(moduli_at(material, (*field_)({.t = t})));
  else
    for (const double at_point : temperature(t)) moduli_.push_back(moduli_at(material, at_point));
  moduli_time_ = t;
  return moduli_;
}

}  // namespace creepcontact::mechanics
