#include "creepcontact/material/anisotropy.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::material {

bool Orthotropy::depends_on_temperature() const {
  const auto depends = [](const std::array<Function, 3>& of) {
    return std::ranges::any_of(of, [](const Function& f) { return f.depends_on_temperature(); });
  };
  return depends(young_moduli) || depends(poisson_ratios) || depends(shear_moduli);
}

Matrix6 Orthotropy::stiffness(double T) const {
  const auto at = [T](const std::array<Function, 3>& of) {
    return std::array<double, 3>{of[0]({.T = T}), of[1]({.T = T}), of[2]({.T = T})};
  };
  const auto E = at(young_moduli), nu = at(poisson_ratios), G = at(shear_moduli);
  for (std::size_t i = 0; i < 3; ++i)
    if (!(E[i] > 0) || !(G[i] > 0))
      throw ModelError(
          fmt::format("at the temperature {:g} the young_moduli are {:g}, {:g}, {:g} and the shear_moduli {:g}, {:g}, "
                      "{:g}: all must "
                      "be positive",
                      T, E[0], E[1], E[2], G[0], G[1], G[2]));
  Matrix6 compliance = Matrix6::Zero();
  for (Index i = 0; i < 3; ++i) compliance(i, i) = 1 / E[i];
  compliance(0, 1) = compliance(1, 0) = -nu[0] / E[0];
  compliance(1, 2) = compliance(2, 1) = -nu[1] / E[1];
  compliance(0, 2) = compliance(2, 0) = -nu[2] / E[0];
  // Shear components are sqrt(2) times the tensor's: 1/(2 G).
  for (Index i = 0; i < 3; ++i) compliance(3 + i, 3 + i) = 1 / (2 * G[i]);
  const Eigen::LLT<Matrix3> normal(compliance.topLeftCorner<3, 3>());
  if (normal.info() != Eigen::Success)
    throw ModelError(fmt::format(
        "at the temperature {:g} the orthotropic constants are not those of a stable material: with young_moduli {:g}, "
        "{:g}, {:g} the poisson_ratios nu12 = {:g}, nu23 = {:g}, nu13 = {:g} are too large; nu12 is the strain along "
        "axis 2 under stress along axis 1, below sqrt(E1/E2) in magnitude",
        T, E[0], E[1], E[2], nu[0], nu[1], nu[2]));
  return compliance.inverse();
}

namespace {

struct Average {
  double bulk = 0, shear = 0;
};

Average isotropic_average(const Matrix6& stiffness) {
  const Matrix6 compliance = stiffness.inverse();
  // Traces of the volumetric and the deviatoric part, of dimensions 1 and 5.
  const auto volumetric = [](const Matrix6& of) { return of.topLeftCorner<3, 3>().sum() / 3; };
  const auto deviatoric = [&](const Matrix6& of) { return (of.trace() - volumetric(of)) / 5; };
  return {(volumetric(stiffness) / 3 + 1 / (3 * volumetric(compliance))) / 2,
          (deviatoric(stiffness) / 2 + 1 / (2 * deviatoric(compliance))) / 2};
}

/// A function of T made from the average.
template <typename Of>
Function averaged(const Orthotropy& orthotropy, const char* name, const Of& of) {
  if (!orthotropy.depends_on_temperature()) return of(isotropic_average(orthotropy.stiffness(0)));
  std::vector<Function> constants;
  for (const auto* three : {&orthotropy.young_moduli, &orthotropy.poisson_ratios, &orthotropy.shear_moduli})
    constants.insert(constants.end(), three->begin(), three->end());
  constants.push_back(Function::expression("T", {"T"}));
  return Function::composed(name, std::move(constants), [of](const std::vector<double>& v) {
    const Orthotropy at{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
    return of(isotropic_average(at.stiffness(v[9])));
  });
}

}  // namespace

Function Orthotropy::average_young_modulus() const {
  return averaged(*this, "isotropic average of E",
                  [](const Average& a) { return 9 * a.bulk * a.shear / (3 * a.bulk + a.shear); });
}
Function Orthotropy::average_poisson_ratio() const {
  return averaged(*this, "isotropic average of nu",
                  [](const Average& a) { return (3 * a.bulk - 2 * a.shear) / (2 * (3 * a.bulk + a.shear)); });
}

bool ThermalExpansion::is_zero() const {
  return std::ranges::all_of(along, [](const Function& alpha) { return alpha.is_zero(); });
}

Vector3 ThermalExpansion::strains(double T, double reference) const {
  if (!has_axes) return Vector3::Constant(along[0]({.T = T}) * (T - reference));
  return Vector3(along[0]({.T = T}), along[1]({.T = T}), along[2]({.T = T})) * (T - reference);
}

Matrix6 hill_transformation(const HillRatios& ratios) {
  const auto square = [&](std::size_t i) { return 1 / (ratios.values[i] * ratios.values[i]); };
  const double F = (square(1) + square(2) - square(0)) / 2, G = (square(2) + square(0) - square(1)) / 2,
               H = (square(0) + square(1) - square(2)) / 2;
  Matrix6 form = Matrix6::Zero();  // q^2 = stress . form stress
  form.topLeftCorner<3, 3>() << G + H, -H, -G, -H, F + H, -F, -G, -F, F + G;
  for (Index i = 0; i < 3; ++i) form(3 + i, 3 + i) = 1.5 * square(3 + static_cast<std::size_t>(i));
  const Eigen::SelfAdjointEigenSolver<Matrix6> spectrum(2.0 / 3.0 * form);
  const Tensor6 values = spectrum.eigenvalues();
  constexpr double rounding = 1e-12;
  if (!(values.minCoeff() > -rounding * values.maxCoeff()))
    throw ModelError(fmt::format(
        "Hill's equivalent stress is not real for every stress with the ratios R11 = {:g}, R22 = {:g}, R33 = "
        "{:g}: 1/R11, 1/R22 and 1/R33 must form a triangle (each less than the sum of the others)",
        ratios.values[0], ratios.values[1], ratios.values[2]));
  // The mean stress is among those that are zero but for rounding, of which roots would remain.
  const Tensor6 roots = (values.array() > rounding * values.maxCoeff()).select(values.cwiseMax(0.0).cwiseSqrt(), 0.0);
  const Matrix6& directions = spectrum.eigenvectors();
  return directions * roots.asDiagonal() * directions.transpose();
}

Matrix6 rotation(const Matrix3& axes) {
  Matrix6 turn;
  for (Index j = 0; j < 6; ++j)
    turn.col(j) = tensor::from_matrix(axes * tensor::to_matrix(Tensor6(Tensor6::Unit(j))) * axes.transpose());
  return turn;
}

}  // namespace creepcontact::material
