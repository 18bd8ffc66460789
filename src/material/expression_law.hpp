#pragma once
/// A law that the user writes: f = rate(q, T, t, eps), the equivalent creep rate as an expression in the von Mises
/// stress, the temperature, the time and the equivalent creep strain that this mechanism has accumulated.
/// There is an internal variable only if eps occurs. Derivatives are central differences; a rate that is negative or no
/// number makes the integrator take a smaller step. A rate that code evaluates (Function::batched) is evaluated at all
/// points at once, and may know its derivatives. Rates that are infinite at t = 0 (as t^-0.5) or at eps = 0 (as
/// eps^-2) start with the closed form of the power law that they tend to there, found numerically.

#include "hardening_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class ExpressionLaw final : public HardeningLaw {
 public:
  enum Constant {
    rate_expression,  ///< of q, T, t, eps [1/time]
    n_constants
  };
  explicit ExpressionLaw(const ParameterValues& values);
  std::string name() const override { return "expression"; }
  double equivalent_rate(double q, double eps, const PointState& at) const override;
  HardeningRate linearized_rate(double q, double eps, const PointState& at) const override;
  double accumulated(double q, double eps, const PointState& at, double duration) const override;
  double start_exponent(const PointState& at) const override;
  std::size_t n_prepared() const override { return rate_.batch() != nullptr ? 4 : 0; }
  std::vector<double> prepare(std::span<const PointState> at, bool with_derivatives) const override;

 private:
  /// Exponents of t (at t = 0) and eps (at eps = 0) that the rate tends to there; 0 where it is finite.
  struct Singularity {
    double time = 0, strain = 0;
    double exponent() const { return (1 + time) / (1 - strain); }
  };
  Singularity singularity(double q, const PointState& at) const;
  double value(double q, double eps, double t, double T) const;

  Function rate_;
};

LawInfo expression_info();

}  // namespace creepcontact::material
