#pragma once
/// Creep with damage: f = A (q/(1-w))^n, dw/dt = B S^r/(1-w)^phi, with the stress that damages
/// S = alpha max(sigma_1, 0) + (1-alpha) q. At constant stress damage w reaches 1, rupture, at t_r = 1/((phi+1) B S^r).
/// The internal variable is D = 1 - (1-w)^(phi+1), whose rate (phi+1) B S^r stays bounded up to rupture; where phi
/// depends on the temperature it is w itself. 1-D counts as 1e-14 below that.
/// Sources: L. M. Kachanov (1958); Y. N. Rabotnov, Creep Problems in Structural Members (1969); S: D. R. Hayhurst,
/// J. Mech. Phys. Solids 20 (1972).

#include "creepcontact/material/creep_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class KachanovRabotnov final : public CreepLaw {
 public:
  enum Constant {
    A,              ///< [1/(time stress^n)], >= 0
    n,              ///< [-], >= 1
    B,              ///< [1/(time stress^r)], >= 0
    r,              ///< [-], > 0
    phi,            ///< [-], >= 0
    alpha,          ///< [-], in [0, 1]
    damage_energy,  ///< activation energy of B; not evaluated at points
    n_constants
  };
  explicit KachanovRabotnov(const ParameterValues& values);
  std::string name() const override { return "kachanov_rabotnov"; }
  int n_internal() const override { return 1; }
  InternalKind internal_kind(int) const override { return InternalKind::life; }
  bool uses_mean_stress() const override;

  void rate(const PointState& at, PointRate into) const override;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override;
  StressTangent stress_tangent(const PointState& at) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  struct Integrity {
    double value = 1;  ///< 1 - w
    double slope = 0;  ///< d value/d D; 0 beyond rupture
  };
  Integrity integrity(const PointState& at) const;

  double power_;  // phi + 1, or 1 if phi depends on the temperature
};

LawInfo kachanov_rabotnov_info();

}  // namespace creepcontact::material
