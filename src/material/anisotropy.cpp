#include "creepcontact/material/anisotropy.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::material {

bool Orthotropy::depends_on_temperature() const {
  const auto depends = [](const std::array<Function, 3>& of) {
    return std::ranges::any_of(of, [](const Function& f) { return f.depends_on_temperature(); });
  };
  return depends(young_moduli) || depends(poisson_ratios) || depends(shear_moduli);
}

namespace {

/// E, nu and G as in Orthotropy, at a temperature.
struct OrthotropicConstants {
  std::array<double, 3> E{}, nu{}, G{};

  /// Strain along the axes = compliance stress. @param T  for messages; nullopt: it does not matter @throws ModelError
  /// if it is not positive definite
  Matrix3 normal_compliance(std::optional<double> T) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(E[i] > 0) || !(G[i] > 0))
        throw ModelError(
            place(T) +
            fmt::format("the young_moduli are {:g}, {:g}, {:g} and the shear_moduli {:g}, {:g}, {:g}: all must "
                        "be positive",
                        E[0], E[1], E[2], G[0], G[1], G[2]));
    Matrix3 compliance;
    compliance << 1 / E[0], -nu[0] / E[0], -nu[2] / E[0], -nu[0] / E[0], 1 / E[1], -nu[1] / E[1], -nu[2] / E[0],
        -nu[1] / E[1], 1 / E[2];
    if (Eigen::LLT<Matrix3>(compliance).info() != Eigen::Success) throw ModelError(unstable(T));
    return compliance;
  }
  /// Shear components are sqrt(2) times those of tensors: stress = 2 G strain.
  Matrix6 stiffness(const Matrix3& normal_compliance) const {
    Matrix6 result = Matrix6::Zero();
    result.topLeftCorner<3, 3>() = normal_compliance.inverse();
    for (Index i = 0; i < 3; ++i) result(3 + i, 3 + i) = 2 * G[static_cast<std::size_t>(i)];
    return result;
  }

 private:
  static std::string place(std::optional<double> T) {
    return "orthotropic: " + (T ? fmt::format("at the temperature {:g} ", *T) : "");
  }
  std::string unstable(std::optional<double> T) const {
    const std::string given = place(T) + "the constants are not those of a stable material: ";
    constexpr std::array<std::array<std::size_t, 2>, 3> axes{{{0, 1}, {1, 2}, {0, 2}}};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = axes[k];
      const double most = std::sqrt(E[a] / E[b]);
      if (std::abs(nu[k]) < most) continue;
      return given +
             fmt::format(
                 "nu{0}{1} = {2:g} must be below sqrt(E{0}/E{1}) = {3:.4g} in magnitude (it is the strain along "
                 "axis {1} under stress along axis {0}; nu{1}{0} = nu{0}{1} E{1}/E{0})",
                 a + 1, b + 1, nu[k], most);
    }
    return given + fmt::format(
                       "with young_moduli {:g}, {:g}, {:g} the poisson_ratios nu12 = {:g}, nu23 = {:g} and nu13 = {:g} "
                       "are together too large: some stress would gain energy",
                       E[0], E[1], E[2], nu[0], nu[1], nu[2]);
  }
};

struct Average {
  double bulk = 0, shear = 0;
};

Average isotropic_average(const OrthotropicConstants& of, std::optional<double> T) {
  const Matrix3 normal_compliance = of.normal_compliance(T);
  const Matrix6 stiffness = of.stiffness(normal_compliance);
  Matrix6 compliance = Matrix6::Zero();
  compliance.topLeftCorner<3, 3>() = normal_compliance;
  for (Index i = 3; i < 6; ++i) compliance(i, i) = 1 / stiffness(i, i);
  // Traces of the volumetric and the deviatoric part, of dimensions 1 and 5.
  const auto volumetric = [](const Matrix6& map) { return map.topLeftCorner<3, 3>().sum() / 3; };
  const auto deviatoric = [&](const Matrix6& map) { return (map.trace() - volumetric(map)) / 5; };
  return {(volumetric(stiffness) / 3 + 1 / (3 * volumetric(compliance))) / 2,
          (deviatoric(stiffness) / 2 + 1 / (2 * deviatoric(compliance))) / 2};
}

OrthotropicConstants constants_at(const Orthotropy& of, double T) {
  const auto at = [T](const std::array<Function, 3>& three) {
    return std::array<double, 3>{three[0]({.T = T}), three[1]({.T = T}), three[2]({.T = T})};
  };
  return {at(of.young_moduli), at(of.poisson_ratios), at(of.shear_moduli)};
}

/// A function of T made from the average.
template <typename Of>
Function averaged(const Orthotropy& orthotropy, const char* name, const Of& of) {
  if (!orthotropy.depends_on_temperature()) return of(isotropic_average(constants_at(orthotropy, 0), {}));
  std::vector<Function> constants;
  for (const auto* three : {&orthotropy.young_moduli, &orthotropy.poisson_ratios, &orthotropy.shear_moduli})
    constants.insert(constants.end(), three->begin(), three->end());
  constants.push_back(Function::expression("T", {"T"}));
  return Function::composed(name, std::move(constants), [of](const std::vector<double>& v) {
    return of(isotropic_average({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}}, v[9]));
  });
}

}  // namespace

Matrix6 Orthotropy::stiffness(double T) const {
  const OrthotropicConstants constants = constants_at(*this, T);
  return constants.stiffness(constants.normal_compliance(depends_on_temperature() ? std::optional(T) : std::nullopt));
}

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
  form *= 2.0 / 3.0;
  const tensor::Principal normal(form.topLeftCorner<3, 3>());
  Tensor6 values;
  values << normal.values, form.diagonal().tail<3>();
  constexpr double rounding = 1e-12;
  if (!(values.minCoeff() > -rounding * values.maxCoeff()))
    throw ModelError(fmt::format(
        "hill: the equivalent stress is not real for every stress with the ratios R11 = {:g}, R22 = {:g}, R33 = "
        "{:g}: 1/R11, 1/R22 and 1/R33 must form a triangle (each less than the sum of the others)",
        ratios.values[0], ratios.values[1], ratios.values[2]));
  // The mean stress is among those that are zero but for rounding, of which roots would remain.
  const Tensor6 roots = (values.array() > rounding * values.maxCoeff()).select(values.cwiseMax(0.0).cwiseSqrt(), 0.0);
  Matrix6 result = roots.asDiagonal();
  result.topLeftCorner<3, 3>() = normal.directions * roots.head<3>().asDiagonal() * normal.directions.transpose();
  result.topLeftCorner<3, 3>().array() += 1.0 / 3.0;  // the mean stress stays
  return result;
}

Matrix6 rotation(const Matrix3& axes) {
  Matrix6 turn;
  for (Index j = 0; j < 6; ++j)
    turn.col(j) = tensor::from_matrix(axes * tensor::to_matrix(Tensor6(Tensor6::Unit(j))) * axes.transpose());
  return turn;
}

}  // namespace creepcontact::material
