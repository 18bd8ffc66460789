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

// What a law and its caller hand to each other: views of numbers that the caller owns, cut to what belongs to the law.
// Tensors are six numbers in Mandel order (base/tensor.hpp). Units are those of the user: stress, time, temperature.

/// What a law sees at one integration point.
struct PointState {
  tensor::ConstMap stress = tensor::zero();
  tensor::ConstMap creep_strain = tensor::zero();  ///< of the whole material, not of this law alone
  std::span<const double> internal = {};           ///< n_internal() variables of this law
  std::span<const double> parameters = {};         ///< n_parameters() values at this point's temperature
  double time = 0;
  double temperature = 0;
  /// Hardening strain below this counts as this: small against what the accuracy of the strain is, but not so small
  /// that Newton's corrections there, which are a share of it, pass for nothing.
  double least_strain = 1e-10;
};

/// Changes of what a law sees: the direction of a derivative.
struct PointChange {
  tensor::ConstMap stress = tensor::zero();
  tensor::ConstMap creep_strain = tensor::zero();
  std::span<const double> internal = {};  ///< n_internal()
};

/// Where a law puts its rates, or the changes of its rates.
struct PointRate {
  tensor::Map creep_strain;         ///< all mechanisms add to it
  std::span<double> internal = {};  ///< n_internal(); overwritten
};

/// Where a law adds what grows in some time.
struct PointIncrement {
  tensor::Map creep_strain;
  std::span<double> internal = {};  ///< n_internal()
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
  /// All values one after the other, those of a list in its order: PointState::parameters has the same order.
  const std::vector<Function>& parameters() const { return parameters_; }

  /// Creep strain rate and rates of the internal variables.
  virtual void rate(const PointState& at, PointRate into) const = 0;
  /// The exact directional derivative of rate().
  virtual void derivative(const PointState& at, const PointChange& change, PointRate into) const = 0;
  /// d(strain rate)/d(stress) alone, internal variables held.
  virtual StressTangent stress_tangent(const PointState& at) const = 0;

  /// True if rate() is no rate but the creep strain itself, a function of the stress and the time of the moment
  /// (ageing theory).
  virtual bool is_isochronous() const { return false; }

  /// True if a rate depends on principal stresses or otherwise on the mean stress, but for a volumetric creep strain.
  virtual bool uses_mean_stress() const { return false; }

  /// Where loading that begins, or jumps, at at.time makes the rate infinite, strain grows from there as
  /// (t - at.time)^exponent; 1 where the rate is finite. In (0, 1].
  virtual double start_exponent(const PointState& /*at*/) const { return 1; }
  /// What grows from at.time on, the stress being constant: the closed form of a law with a singular start. Here:
  /// duration times the rate.
  virtual void increment(const PointState& at, double duration, PointIncrement into) const;

  /// @returns nothing if the law knows no such measure
  virtual std::optional<double> measure(Measure /*of*/, const PointState& /*at*/) const { return std::nullopt; }

 protected:
  explicit CreepLaw(std::vector<Function> parameters) : parameters_(std::move(parameters)) {}

 private:
  std::vector<Function> parameters_;
};

}  // namespace creepcontact::material
