#pragma once
/// Strain hardening in the form f = (q/(K eps^(1/m)))^n, with the accumulated strain eps of this mechanism; LEMAITRE in
/// code_aster. Creep at constant stress: eps^((n+m)/m) = (n+m)/m (q/K)^n t.
/// Source: J. Lemaitre, J.-L. Chaboche, Mechanics of Solid Materials (1990).

#include "hardening_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class Lemaitre final : public HardeningLaw {
 public:
  enum Constant {
    K,  ///< [stress time^(1/n)], > 0
    n,  ///< [-], >= 1
    m,  ///< [-], > 0
    n_constants
  };
  explicit Lemaitre(const ParameterValues& values) : HardeningLaw(first(values, n_constants), true) {}
  std::string name() const override { return "lemaitre"; }
  double equivalent_rate(double q, double eps, const PointState& at) const override;
  HardeningRate linearized_rate(double q, double eps, const PointState& at) const override;
  double accumulated(double q, double eps, const PointState& at, double duration) const override;
  /// m/(m+n): wherever a load begins or jumps, some point may be virgin.
  double start_exponent(const PointState& at) const override {
    return at.parameters[m] / (at.parameters[m] + at.parameters[n]);
  }
};

LawInfo lemaitre_info();

}  // namespace creepcontact::material
