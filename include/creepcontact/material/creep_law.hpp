#pragma once
/// Creep laws: creep strain rate as a function of stress, state, time and temperature at one material point.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/tensor.hpp"
#include "creepcontact/material/state_variable.hpp"

namespace creepcontact::material {

/// The constants of a law, indexed by the enumeration of the law; one function each, or several for a list.
using ParameterValues = std::vector<std::vector<Function>>;

/// What a law sees at one integration point. Views of numbers that the caller owns; tensors are six numbers in Mandel
/// order (base/tensor.hpp). Units of stress, time and temperature are those of the user.
struct PointState {
  tensor::ConstMap stress = tensor::zero();
  tensor::ConstMap creep_strain = tensor::zero();  ///< total of the material, not of this law alone
  std::span<const double> internal = {};           ///< n_internal() variables of this law
  std::span<const double> parameters = {};         ///< n_parameters() values at the temperature of this point
  double time = 0;
  double temperature = 0;
  /// Lower bound on the strain in hardening laws: smaller strains count as this. It is small compared with the accuracy
  /// of the strain, but large enough that Newton corrections relative to it are not negligible.
  double min_strain = 1e-10;
  /// What CreepLaw::prepare() has found for this point; empty: nothing.
  std::span<const double> prepared = {};
};

/// A direction of change of the state that a law sees, for derivatives.
struct PointChange {
  tensor::ConstMap stress = tensor::zero();
  tensor::ConstMap creep_strain = tensor::zero();
  std::span<const double> internal = {};  ///< n_internal()
};

/// Output of a law: its rates, or the changes of its rates.
struct PointRate {
  tensor::Map creep_strain;         ///< each law adds its own to it
  std::span<double> internal = {};  ///< n_internal(), overwritten
};

/// Output of CreepLaw::increment(), added to.
struct PointIncrement {
  tensor::Map creep_strain;
  std::span<double> internal = {};  ///< n_internal()
};

/// d(rate)/d(stress) of an isotropic law:
///   deviatoric * P + radial * m m^T + volumetric * (1/3) I I^T,   P the deviatoric projector,
/// with m the direction of the strain rate. For a coaxial law this is the direction of the stress deviator s, s/|s|.
struct StressTangent {
  double deviatoric = 0, radial = 0, volumetric = 0;
};

/// Kind of an internal variable; it determines its error scale.
enum class InternalKind {
  strain,    ///< as accurate as the creep strain
  fraction,  ///< of 1
  life       ///< likewise, and it grows over the whole run: damage, used life
};

/// What a point has gone through in one cycle of the loads.
struct CycleRange {
  double strain_range = 0;  ///< equivalent range of the total strain, see material/creep_fatigue.hpp
  double temperature = 0;   ///< the highest
};

/// One creep mechanism of a material; the rates of all mechanisms add up. Immutable, safe for any number of threads.
class CreepLaw {
 public:
  virtual ~CreepLaw() = default;
  virtual std::string name() const = 0;
  /// Number of its own state variables per point (hardening, damage, Kelvin strains); 0 for secondary creep.
  virtual int n_internal() const { return 0; }
  virtual InternalKind internal_kind(int /*variable*/) const { return InternalKind::strain; }
  int n_parameters() const { return static_cast<int>(parameters_.size()); }
  /// The constants that are evaluated at points, lists expanded; PointState::parameters has the same order.
  const std::vector<Function>& parameters() const { return parameters_; }

  /// Adds the creep strain rate to into.creep_strain, and sets the rates of the internal variables.
  virtual void rate(const PointState& at, PointRate into) const = 0;
  /// Exact directional derivative of rate(); the creep strain part is added.
  virtual void derivative(const PointState& at, const PointChange& change, PointRate into) const = 0;
  /// d(strain rate)/d(stress) with the internal variables held constant.
  virtual StressTangent stress_tangent(const PointState& at) const = 0;

  /// False if the direction of the strain rate is not that of the stress deviator. It then follows from derivative().
  virtual bool is_coaxial() const { return true; }

  /// True if the rates are linear in stress, creep strain and internal variables, all of them tensors in Mandel order,
  /// and isotropic: deviators and mean parts do not mix. derivative() then depends on the parameters alone.
  virtual bool is_linear() const { return false; }

  /// rate() and stress_tangent() at once, which costs less for some laws.
  virtual StressTangent rate_and_tangent(const PointState& at, PointRate into) const {
    rate(at, std::move(into));
    return stress_tangent(at);
  }

  /// False for a mechanism without strain, which sees the stress itself also where creep is anisotropic.
  virtual bool strains() const { return true; }

  /// True if the law limits the stress as plasticity does: the stress without creep may then be far above what the
  /// material ever carries.
  virtual bool yields() const { return false; }

  /// True if rate() gives the creep strain itself instead of a rate, as a function of the current stress and time
  /// (ageing theory).
  virtual bool is_isochronous() const { return false; }

  /// True if a rate depends on principal stresses or the mean stress other than through a volumetric creep strain.
  virtual bool uses_mean_stress() const { return false; }

  /// Exponent of the growth of the strain, (t - at.time)^exponent, if loads that begin or jump at at.time make the rate
  /// infinite. In (0, 1]; 1: the rate is finite.
  virtual double start_exponent(const PointState& /*at*/) const { return 1; }
  /// Adds the growth over `duration` from at.time on, at constant stress: the closed form of a law with a singular
  /// start. By default: duration times the rate.
  virtual void increment(const PointState& at, double duration, PointIncrement into) const;

  /// Numbers per point that prepare() finds; 0: the law is evaluated point by point alone.
  virtual std::size_t n_prepared() const { return 0; }
  /// Evaluates what rate(), derivative() and stress_tangent() need, at all points at once: a law whose evaluation costs
  /// more than a point is worth. They are right without it too.
  /// @param with_derivatives  false: only rate() follows @returns n_prepared() numbers per point
  virtual std::vector<double> prepare(std::span<const PointState> /*at*/, bool /*with_derivatives*/) const {
    return {};
  }

  /// True if whole cycles change its internal variables, beyond the integral of the rates.
  virtual bool counts_cycles() const { return false; }
  /// Adds what one cycle does to them. @param internal  n_internal()
  virtual void add_cycle(const CycleRange& /*cycle*/, std::span<double> /*internal*/) const {}

  /// @param into  variable.width() numbers, set if the law has the variable
  /// @returns true if it has; the same at all states
  virtual bool evaluate(const StateVariable& /*variable*/, const PointState& /*at*/, std::span<double> /*into*/) const {
    return false;
  }

 protected:
  /// @param constants  those that are evaluated at points. PointState::parameters has the value of a constant at the
  /// place that its enumerator gives, unless a list comes before it.
  explicit CreepLaw(const ParameterValues& constants);

  /// The values at a point of a constant that is a list, or comes after one.
  std::span<const double> list(std::size_t constant, const PointState& at) const {
    const std::size_t* const first = first_.data() + constant;
    return {at.parameters.data() + first[0], first[1] - first[0]};
  }

 private:
  std::vector<Function> parameters_;
  std::vector<std::size_t> first_{0};  // number of the first function of every constant, and that of all
};

}  // namespace creepcontact::material
