#pragma once
/// Hot working of metals and creep of solders with one resistance s to inelastic flow:
///   f = A sinh(xi q/s)^(1/m),  ds/dt = h0 |1 - s/s*|^a sign(1 - s/s*) f,  s* = s_hat (f/A)^n,  s(0) = s0,
/// where A includes thermal activation. There is no elastic range. Internal variable: s/s0 - 1.
/// Sources: L. Anand, Int. J. Plasticity 1 (1985); S. B. Brown, K. H. Kim, L. Anand, Int. J. Plasticity 5 (1989).

#include "creepcontact/material/creep_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class Anand final : public CreepLaw {
 public:
  enum Constant {
    A,      ///< [1/time], > 0
    xi,     ///< [-], > 0
    m,      ///< [-], in (0, 1]
    s_hat,  ///< [stress], > 0
    n,      ///< [-], >= 0
    h0,     ///< [stress], >= 0
    a,      ///< [-], >= 1
    s0,     ///< [stress], > 0, the same at all temperatures
    n_constants
  };
  /// @throws ParameterError if s0 is not a number
  explicit Anand(const ParameterValues& values);
  std::string name() const override { return "anand"; }
  int n_internal() const override { return 1; }
  InternalKind internal_kind(int) const override { return InternalKind::fraction; }

  bool yields() const override { return true; }

  void rate(const PointState& at, PointRate into) const override;
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override;
  StressTangent stress_tangent(const PointState& at) const override;
  bool evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const override;

 private:
  /// f and df/dq = -(s/q) df/ds, and the same of the rate of s/s0.
  struct Rates {
    double flow = 0, flow_by_q = 0, flow_by_s = 0;
    double growth = 0, growth_by_q = 0, growth_by_s = 0;
  };
  static Rates rates(double q, const PointState& at);
};

LawInfo anand_info();

}  // namespace creepcontact::material
