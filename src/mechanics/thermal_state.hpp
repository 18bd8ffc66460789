#pragma once
/// Temperature of a body at its integration points, and what the material makes of it.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/material/material.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::mechanics {

class ThermalState {
 public:
  /// @param temperature  nullopt: the reference temperature of every material, no thermal strain
  ThermalState(std::optional<TemperatureField> temperature, const Discretization& discretization);

  /// One value a point; empty without a temperature. Cost: none if t is that of the last call or the field is steady.
  std::span<const double> temperature(double t);
  /// alpha(T) (T - reference), one value a point; empty if the material does not expand or there is no temperature.
  std::span<const double> strain(const material::Material& material, double t);
  /// Elastic constants: one entry if they are the same everywhere. @throws ModelError if they are not admissible
  std::span<const Moduli> moduli(const material::Material& material, double t);

  bool changes_in_time() const { return field_ && field_->depends_on_time(); }
  bool moduli_change_in_time(const material::Material& material) const;

 private:
  std::optional<TemperatureField> field_;
  std::size_t n_points_;
  std::unique_ptr<TemperatureAtPlaces> at_points_;
  std::vector<double> temperature_, strain_;
  std::vector<Moduli> moduli_;
  std::optional<double> temperature_time_, strain_time_, moduli_time_;  // of the values kept
};

}  // namespace creepcontact::mechanics
