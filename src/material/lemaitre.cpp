#include "lemaitre.hpp"

#include "power.hpp"

namespace creepcontact::material {

double Lemaitre::equivalent_rate(double q, double eps, const PointState& at) const {
  const double K = at.parameters[Constant::K], n = at.parameters[Constant::n], m = at.parameters[Constant::m];
  return power(q / K * std::pow(eps, -1.0 / m), n);
}

HardeningRate Lemaitre::linearized_rate(double q, double eps, const PointState& at) const {
  const double n = at.parameters[Constant::n], m = at.parameters[Constant::m];
  const double f = equivalent_rate(q, eps, at);
  return {f, f * n / q, -f * n / (m * eps)};
}

double Lemaitre::accumulated(double q, double eps, const PointState& at, double duration) const {
  const double K = at.parameters[Constant::K], n = at.parameters[Constant::n], m = at.parameters[Constant::m];
  const double root = m / (m + n);
  const double virgin = std::pow(power(q / K, n) * duration / root, root);
  // (eps^(1/root) + virgin^(1/root))^root - eps, from the side that loses no digits.
  if (virgin > eps) return virgin * std::pow(1.0 + std::pow(eps / virgin, 1.0 / root), root) - eps;
  if (eps == 0.0) return 0.0;
  return eps * std::expm1(root * std::log1p(std::pow(virgin / eps, 1.0 / root)));
}

LawInfo lemaitre_info() {
  return {"lemaitre",
          "rate = (q/(K eps^(1/m)))^n",
          "J. Lemaitre, J.-L. Chaboche, 1990",
          law_table(
              Row<Lemaitre::K>{{.key = "K",
                                .description = "resistance: 1/UN_SUR_K of code_aster [stress time^(1/n)]",
                                .dimension = unit::stress * unit::pow(unit::time, reciprocal(Lemaitre::n))}},
              Row<Lemaitre::n>{stress_exponent()},
              Row<Lemaitre::m>{{.key = "m",
                                .description = "hardening exponent: 1/UN_SUR_M of code_aster; large: steady creep [-]",
                                .dimension = unit::none}}),
          construct<Lemaitre>,
          {&hardening_strain}};
}

}  // namespace creepcontact::material
