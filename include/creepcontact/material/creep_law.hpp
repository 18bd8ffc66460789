#pragma once
/// Creep laws: creep strain rate as a function of stress, state, time and temperature at one material point.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/tensor.hpp"

namespace creepcontact::material {

/// What a law sees at one integration point. Pointers are not owned.
struct Point {
  const double* stress = nullptr;      ///< 6, Mandel order
  const double* state = nullptr;       ///< creep strain (6, Mandel), of the whole material
  const double* internal = nullptr;    ///< n_internal() variables of this law
  const double* parameters = nullptr;  ///< n_parameters() values at this point's temperature
  double time = 0;
  double temperature = 0;
};

/// d(rate)/d(stress) of an isotropic law, in the frame of the current stress deviator s:
///   deviatoric * P + radial * m m^T + volumetric * (1/3) I I^T,   m = s/|s|, P the deviatoric projector.
struct StressTangent {
  double deviatoric = 0, radial = 0, volumetric = 0;
};

/// One mechanism of creep. Immutable after construction, safe for any number of threads.
/// Rates of several mechanisms of a material add.
class CreepLaw {
 public:
  virtual ~CreepLaw() = default;
  virtual std::string name() const = 0;
  /// Own state variables a point (hardening, damage, Kelvin strains); 0 for a law of secondary creep.
  virtual int n_internal() const { return 0; }
  int n_parameters() const { return static_cast<int>(parameters_.size()); }
  const std::vector<Function>& parameters() const { return parameters_; }

  /// Adds the creep strain rate (6, Mandel) and writes the internal rates (n_internal()).
  virtual void rate(const Point& at, double* strain_rate, double* internal_rate) const = 0;
  /// Adds the exact directional derivative of rate(): d strain_rate (6) and writes d internal_rate (n_internal()),
  /// for changes of stress (6), of creep strain (6) and of the internal variables.
  virtual void derivative(const Point& at, const double* d_stress, const double* d_state, const double* d_internal,
                          double* d_strain_rate, double* d_internal_rate) const = 0;
  /// d(strain rate)/d(stress) alone, internal variables held.
  virtual StressTangent stress_tangent(const Point& at) const = 0;

 protected:
  explicit CreepLaw(std::vector<Function> parameters) : parameters_(std::move(parameters)) {}

 private:
  std::vector<Function> parameters_;  // in the order of the law's keys
};

}  // namespace creepcontact::material
