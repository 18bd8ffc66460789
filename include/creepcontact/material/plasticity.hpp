#pragma once
/// Rate-independent plasticity: von Mises yielding with isotropic hardening and any number of back stresses.
///
///   J(s - X) <= sy(p, T),  J(a) = sqrt(3/2 a:a),  d eps_p = 3/2 N dp,  N = (s - X)/J(s - X),
///   dX_i = 2/3 C_i d eps_p - gamma_i X_i dp
/// (R. Hill, The Mathematical Theory of Plasticity, 1950; W. Prager; P. J. Armstrong, C. O. Frederick, CEGB RD/B/N731,
/// 1966). What is stored are the strains alpha_i with X_i = 2/3 C_i(T) alpha_i, so that a change of temperature changes
/// X_i as it changes C_i.

#include <span>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/tensor.hpp"

namespace creepcontact::material {

/// Yield stress over the accumulated plastic strain at one temperature: linear between the points, constant after the
/// last one.
struct YieldCurve {
  double temperature = 0;
  std::vector<double> plastic_strain;  ///< ascending from 0
  std::vector<double> stress;          ///< > 0, not falling
};

/// One back stress; functions of T. gamma = 0: linear (Prager).
struct BackStress {
  Function C, gamma;
};

/// What a point has from its accepted past.
struct PlasticPoint {
  Tensor6 stress_deviator = Tensor6::Zero();  ///< at the end of the last accepted step
  double accumulated = 0;                     ///< p
  std::span<const double> back;               ///< alpha_i, n_back x 6; empty: zero
};

/// The flow within one step.
struct PlasticFlowStep {
  Tensor6 strain = Tensor6::Zero();  ///< change of the plastic strain
  double accumulated = 0;            ///< change of p; zero: the point does not yield
};

/// Immutable.
class Plasticity {
 public:
  /// @param yield_stress, hardening_modulus  functions of T
  Plasticity(Function yield_stress, Function hardening_modulus, std::vector<BackStress> back_stresses);
  /// @param curves  with ascending temperatures; linear between them, constant outside
  Plasticity(std::vector<YieldCurve> curves, std::vector<BackStress> back_stresses);

  std::size_t n_back() const { return back_stresses_.size(); }
  bool depends_on_temperature() const;
  /// Number of constants of a point.
  std::size_t n_constants() const { return 2 + 2 * n_back(); }
  /// The constants at a temperature. @param into  n_constants()
  /// @throws std::invalid_argument for a yield stress that is not positive, a negative modulus, C or gamma, or values
  /// that are not finite
  void evaluate(double T, std::span<double> into) const;

  struct YieldStress {
    double stress = 0, slope = 0;  ///< sy and d sy/dp
  };
  /// @param constants  of evaluate()
  YieldStress yield_stress(double accumulated, double T, std::span<const double> constants) const;
  /// X = sum of X_i. @param back  alpha_i, n_back x 6; empty: none
  Tensor6 back_stress(std::span<const double> back, std::span<const double> constants) const;

  /// H with H dp = 3/2 N : d(stress) while the point flows in the direction N: d sy/dp + sum C_i - 3/2 N : sum gamma_i
  /// X_i. @param direction  3/2 N @param back  alpha_i, n_back x 6
  double hardening(double accumulated, const Tensor6& direction, double T, std::span<const double> constants,
                   std::span<const double> back) const;

  /// Trapezoidal return (M. Ortiz, E. P. Popov, Int. J. Numer. Meth. Eng. 21 (1985) 1561) with the direction N_c of the
  /// first yield in the step: exact on straight paths, of second order on others.
  /// @param trial  deviator of the stress with the plastic strain held since `from`, at the end of the step
  /// @param shear_modulus  at the end of the step @param back  n_back x 6: alpha_i at the end
  /// Cost: a scalar Newton iteration where the point yields
  PlasticFlowStep flow(const PlasticPoint& from, const Tensor6& trial, double shear_modulus, double T,
                       std::span<const double> constants, std::span<double> back) const;

 private:
  Function initial_, modulus_;
  std::vector<YieldCurve> curves_;  // empty: initial_ and modulus_ count
  std::vector<BackStress> back_stresses_;
};

}  // namespace creepcontact::material
