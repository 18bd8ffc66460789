#pragma once
/// Strain hardening in the form f = (q/(K eps^(1/m)))^n, with the accumulated strain eps of this mechanism; LEMAITRE in
/// code_aster. Creep at constant stress: eps^((n+m)/m) = (n+m)/m (q/K)^n t.
/// Source: J. Lemaitre, J.-L. Chaboche, Mechanics of Solid Materials (1990).

#include "creepcontact/material/registry.hpp"
#include "hardening_law.hpp"

namespace creepcontact::material {

class Lemaitre final : public HardeningLaw {
 public:
  /// @param K  [stress time^(1/n)], > 0
  /// @param n  [-], >= 1
  /// @param m  [-], > 0
  Lemaitre(Function K, Function n, Function m) : HardeningLaw({std::move(K), std::move(n), std::move(m)}, true) {}
  std::string name() const override { return "lemaitre"; }
  double equivalent_rate(double q, double eps, const PointState& at) const override;
  HardeningRate linearized_rate(double q, double eps, const PointState& at) const override;
  double accumulated(double q, double eps, const PointState& at, double duration) const override;
  /// m/(m+n): wherever a load begins or jumps, some point may be virgin.
  double start_exponent(const PointState& at) const override {
    return at.parameters[2] / (at.parameters[2] + at.parameters[1]);
  }
};

LawInfo lemaitre_info();

}  // namespace creepcontact::material
