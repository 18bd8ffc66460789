#pragma once
/// Secondary creep by the normalised activation energy of Kocks and Mecking, g = k T_abs ln(rate0/f)/(mu b^3), which is
/// linear in the logarithm of the stress, g = A ln(q/mu) + B:
///   f = rate0 exp(B F) (q/mu)^(A F),   F = -mu b^3/(k T_abs),   T_abs = T - absolute_zero,
/// with mu the shear modulus, b the Burgers vector and k Boltzmann's constant. F and A are negative, so the stress
/// exponent A F is positive; it falls as the temperature rises.
/// Source: U. F. Kocks, H. Mecking, Progress in Materials Science 48 (2003), 171-273; for creep: M. C. Messner and
/// others, NEML.

#include "flow_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class KocksMecking final : public FlowLaw {
 public:
  enum Constant {
    rate0,          ///< [1/time], > 0
    A,              ///< [-], < 0
    B,              ///< [-]
    burgers,        ///< [length], a number
    boltzmann,      ///< [stress length^3/degree], a number
    shear_modulus,  ///< [stress], > 0
    absolute_zero,
    n_constants
  };
  /// @throws ParameterError if A is 0, or if mu b^3/k cannot be a temperature: values in different systems of units
  explicit KocksMecking(const ParameterValues& values);
  std::string name() const override { return "kocks_mecking"; }
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;

 private:
  /// Evaluated at points, in logarithms: exp(B F) and (q/mu)^(A F) differ from f by tens of decades.
  enum PointConstant { log_factor, exponent, modulus };  // ln rate0 + B F, A F, mu
};

LawInfo kocks_mecking_info();

}  // namespace creepcontact::material
