#pragma once
/// Creep with two hardening variables, ageing and damage, as code_aster's law HAYHURST:
///   f = rate0 sinh(q (1 - H)/(K (1 - phi) (1 - D))),   H = H1 + H2,
///   dHi/dt = (hi/q) (Hi_limit - delta_i Hi) f,   dphi/dt = (kc/3) (1 - phi)^4,   dD/dt = A sinh(S/sigma0),
/// with S = alpha max(X, 0) + (1 - alpha) q, X the largest principal stress or the trace. H1 saturates at
/// H1_limit/delta1 (primary creep), H2 falls without a limit if h2 < 0 (softening), phi is ageing, D cavitation.
/// Sources: code_aster, R5.03.13 and rkdhay.F90; flow and ageing: Z. L. Kowalewski, D. R. Hayhurst,
/// B. F. Dyson, J. Strain Anal. 29 (1994), 309-316.
/// code_aster's elasticity degrades with D, this one does not. There is no remaining life: with softening the strain
/// grows without bound while D is still small.

#include "creepcontact/material/creep_law.hpp"
#include "law_table.hpp"
#include "stress_measure.hpp"

namespace creepcontact::material {

class Hayhurst final : public CreepLaw {
 public:
  enum Constant {
    rate0,          ///< [1/time], > 0
    K,              ///< [stress], > 0
    h1,             ///< [stress], >= 0
    H1_limit,       ///< [-], in [0, 1]
    sigma0,         ///< [stress], > 0; empty: there is no A
    delta1,         ///< [-], >= 0
    h2,             ///< [stress], negative: softening
    H2_limit,       ///< [-]
    delta2,         ///< [-], >= 0
    kc,             ///< [1/time], >= 0
    A,              ///< [1/time], >= 0
    alpha,          ///< [-], in [0, 1]
    damage_stress,  ///< number of the word for X; not evaluated at points
    n_constants
  };
  /// @throws ParameterError if there is A but not sigma0
  explicit Hayhurst(const ParameterValues& values);
  std::string name() const override { return "hayhurst"; }
  int n_internal() const override { return n_variables; }
  InternalKind internal_kind(int variable) const override {
    return variable == damage_variable ? InternalKind::life : InternalKind::fraction;
  }
  bool uses_mean_stress() const override;

  void rate(const PointState& at, PointRate into) const override;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override;
  StressTangent stress_tangent(const PointState& at) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  enum Variable { hardening, softening, ageing, damage_variable, n_variables };  // H1, H2, phi, D
  /// f and its derivatives with respect to q and to the variables.
  struct Flow {
    double f, by_q;
    double by[n_variables];
  };
  static Flow flow(double q, const PointState& at);

  DamagingTension tension_;
};

LawInfo hayhurst_info();

}  // namespace creepcontact::material
