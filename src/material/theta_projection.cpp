#include "theta_projection.hpp"

#include <algorithm>

#include "hardening_law.hpp"

namespace creepcontact::material {

ThetaProjection::ThetaProjection(const ParameterValues& values)
    : ScalarStateLaw(ParameterValues()),
      theta_1_(values[theta_1].at(0), values[min_stress].at(0)({}), BelowRange::constant),
      theta_2_(values[theta_2].at(0), values[min_stress].at(0)({}), BelowRange::proportional),
      theta_3_(values[theta_3].at(0), values[min_stress].at(0)({}), BelowRange::constant),
      theta_4_(values[theta_4].at(0), values[min_stress].at(0)({}), BelowRange::proportional) {}

void ThetaProjection::increment(const PointState& at, double duration, PointIncrement into) const {
  const Deviator now = deviator(at.stress);
  if (now.q == 0.0) return;
  const double T = at.temperature;
  const double primary =
      -std::expm1(-theta_2_(now.q, T) * duration) * std::max(theta_1_(now.q, T) - at.internal[0], 0.0);
  const double tertiary = std::expm1(theta_4_(now.q, T) * duration) * (theta_3_(now.q, T) + at.internal[1]);
  add_flow(now, primary + tertiary, into.creep_strain);
  into.internal[0] += primary;
  into.internal[1] += tertiary;
}

bool ThetaProjection::evaluate(const StateVariable& variable, const PointState& at, std::span<double> into) const {
  if (&variable != &hardening_strain) return false;
  into[0] = at.internal[0];
  return true;
}

LawInfo theta_projection_info() {
  const auto theta = [](const char* key, const std::string& meaning, const UnitPowers& dimension) {
    return ParameterInfo{
        .key = key, .description = meaning, .dimension = dimension, .strict = false, .variables = {"q", "T"}};
  };
  return {
      "theta_projection",
      "strain at constant stress = theta_1 (1 - exp(-theta_2 t)) + theta_3 (exp(theta_4 t) - 1)",
      "R. W. Evans, B. Wilshire, 1985",
      law_table(Row<ThetaProjection::theta_1>{theta(
                    "theta_1",
                    "limit of the primary creep strain, a function of the von Mises stress q and temperature T [-]",
                    unit::none)},
                Row<ThetaProjection::theta_2>{theta(
                    "theta_2", "rate at which primary creep ends, a function of q and T [1/time]", unit::per_time)},
                Row<ThetaProjection::theta_3>{
                    theta("theta_3", "scale of the tertiary creep strain, a function of q and T [-]", unit::none)},
                Row<ThetaProjection::theta_4>{theta(
                    "theta_4", "rate at which tertiary creep grows, a function of q and T [1/time]", unit::per_time)},
                Row<ThetaProjection::min_stress>{
                    min_stress_key("`theta_2` and `theta_4` are proportional to q, `theta_1` and `theta_3` constant")}),
      construct<ThetaProjection>,
      {&hardening_strain}};
}

}  // namespace creepcontact::material
