#pragma once
/// Creep laws: creep strain rate as a function of stress, state, time and temperature at one material point.

#include <memory>
#include <optional>
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
  /// Hardening strain below this counts as this: small against what the accuracy of the strain is, but not so small
  /// that Newton's corrections there, which are a share of it, pass for nothing.
  double least_strain = 1e-10;
};

/// d(rate)/d(stress) of an isotropic law, in the frame of the current stress deviator s:
///   deviatoric * P + radial * m m^T + volumetric * (1/3) I I^T,   m = s/|s|, P the deviatoric projector.
struct StressTangent {
  double deviatoric = 0, radial = 0, volumetric = 0;
};

/// What an internal variable is, for the accuracy that is asked of it.
enum class InternalKind {
  strain,   ///< as accurate as the creep strain
  fraction  ///< of 1: damage, life
};

/// What a law may tell of a point beside strain, between 0 and 1.
enum class Measure { damage, life_fraction };

/// One mechanism of creep. Immutable after construction, safe for any number of threads.
/// Rates of several mechanisms of a material add.
class CreepLaw {
 public:
  virtual ~CreepLaw() = default;
  virtual std::string name() const = 0;
  /// Own state variables a point (hardening, damage, Kelvin strains); 0 for a law of secondary creep.
  virtual int n_internal() const { return 0; }
  virtual InternalKind internal_kind(int /*variable*/) const { return InternalKind::strain; }
  int n_parameters() const { return static_cast<int>(parameters_.size()); }
  /// All values one after the other, those of a list in its order: Point::parameters has the same order.
  const std::vector<Function>& parameters() const { return parameters_; }

  /// Adds the creep strain rate (6, Mandel) and writes the internal rates (n_internal()).
  virtual void rate(const Point& at, double* strain_rate, double* internal_rate) const = 0;
  /// Adds the exact directional derivative of rate(): d strain_rate (6) and writes d internal_rate (n_internal()),
  /// for changes of stress (6), of creep strain (6) and of the internal variables.
  virtual void derivative(const Point& at, const double* d_stress, const double* d_state, const double* d_internal,
                          double* d_strain_rate, double* d_internal_rate) const = 0;
  /// d(strain rate)/d(stress) alone, internal variables held.
  virtual StressTangent stress_tangent(const Point& at) const = 0;

  /// True if rate() is no rate but the creep strain itself, a function of the stress and the time of the moment
  /// (ageing theory).
  virtual bool is_isochronous() const { return false; }

  /// True if a rate depends on principal stresses or otherwise on the mean stress, but for a volumetric creep strain.
  virtual bool uses_mean_stress() const { return false; }

  /// Where loading that begins, or jumps, at at.time makes the rate infinite, strain grows from there as
  /// (t - at.time)^exponent; 1 where the rate is finite. In (0, 1].
  virtual double start_exponent(const Point& /*at*/) const { return 1; }
  /// Adds the changes of creep strain (6) and of the internal variables (n_internal()) from at.time on, the stress
  /// being constant: the closed form of a law with a singular start. Here: duration times the rate.
  virtual void increment(const Point& at, double duration, double* strain, double* internal) const;

  /// @returns nothing if the law knows no such measure
  virtual std::optional<double> measure(Measure /*of*/, const Point& /*at*/) const { return std::nullopt; }

 protected:
  explicit CreepLaw(std::vector<Function> parameters) : parameters_(std::move(parameters)) {}

 private:
  std::vector<Function> parameters_;
};

}  // namespace creepcontact::material
