#pragma once
/// Uniform states that relax or creep: closed forms of the NAFEMS tests (R0027, Becker & Hyde), a bolt, blocks in
/// series.

#include <cmath>

#include "verification/reference/norton_point.hpp"
#include "verification/reference/stiff_integrator.hpp"

namespace creepcontact::reference {

/// Solution of s' = -rate s^n: [s0^(1-n) + (n-1) rate t]^(1/(1-n))
inline double power_relaxation(double s0, double rate, double n, double t) {
  return std::pow(std::pow(s0, 1 - n) + (n - 1) * rate * t, 1 / (1 - n));
}

struct NortonMaterial {
  double young_modulus, poisson_ratio, A, n;
  double shear_modulus() const { return young_modulus / (2 * (1 + poisson_ratio)); }
};

/// The material of all NAFEMS tests [N, mm, h]
inline constexpr NortonMaterial nafems{2e5, 0.3, 3.125e-14, 5};

/// 1B, VM132: axial strain held, uniaxial stress.
inline double held_uniaxial(const NortonMaterial& m, double initial_stress, double t) {
  return power_relaxation(initial_stress, m.A * m.young_modulus, m.n, t);
}

/// 3A: creep strain rate along x under the stresses (s, -s, 0): s the deviator, q = sqrt(3) s.
inline double shear_creep_rate(const NortonMaterial& m, double s) {
  return 1.5 * m.A * std::pow(3, 0.5 * (m.n - 1)) * std::pow(s, m.n);
}

/// 3B: strains (e, -e) held in plane stress; sigma_x. Any pure shear of the deviator relaxes like this.
inline double held_shear(const NortonMaterial& m, double initial_stress, double t) {
  const double rate = 2 * m.shear_modulus() * shear_creep_rate(m, 1);
  return power_relaxation(initial_stress, rate, m.n, t);
}

/// 5B: strains (e, e/2, 0) held: the mean stress stays, the deviator (s, 0, -s) relaxes; sigma_x.
inline double held_triaxial(const NortonMaterial& m, double e, double t) {
  const double bulk = m.young_modulus / (3 * (1 - 2 * m.poisson_ratio));
  return bulk * 1.5 * e + held_shear(m, m.shear_modulus() * e, t);
}

/// 10B, time hardening (creep strain A q^n sqrt(t)): 3B in the time sqrt(t).
inline double held_shear_time_hardening(const NortonMaterial& m, double initial_stress, double t) {
  return held_shear(m, initial_stress, std::sqrt(t));
}

/// 10B, strain hardening: d(eps)/dt = A^2 q^(2n) / (2 eps), eps = (s0 - s) / (sqrt(3) G), q = sqrt(3) s; hence
/// t = 2 / (3^(n+1) A^2 G^2) integral_s^s0 (s0 - s) s^(-2n) ds, solved for s by bisection.
inline double held_shear_strain_hardening(const NortonMaterial& m, double s0, double t) {
  const double k = 2 * m.n - 1, factor = std::pow(3, m.n + 1) * std::pow(m.A * m.shear_modulus(), 2) / 2;
  const auto time = [&](double s) {
    return (s0 * (std::pow(s, -k) - std::pow(s0, -k)) / k - (std::pow(s, 1 - k) - std::pow(s0, 1 - k)) / (k - 1)) /
           factor;
  };
  double low = 1e-3 * s0, high = s0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (time(middle) > t ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// 5A: stresses x and y held, no strain along z. Stress z and the creep strains by integration, to ten digits.
struct PlaneStrainCreep {
  double sigma_z, creep_x, creep_y, creep_z;
};
inline PlaneStrainCreep plane_strain_creep(const NortonMaterial& m, double sigma_x, double sigma_y, double t) {
  const NortonPoint law{m.A, m.n};
  const double E = m.young_modulus;
  // Unknowns alike in size: sigma_z, and the creep strains times E.
  const auto stress = [&](const Eigen::VectorXd& y) { return Eigen::Vector3d(sigma_x, sigma_y, y[0]); };
  StiffIntegrator integrator(
      [&](const Eigen::VectorXd& y) {
        const Eigen::Vector3d f = E * law.rate(stress(y));
        return Eigen::VectorXd(Eigen::Vector3d(-f[2], f[0], f[1]));
      },
      [&](const Eigen::VectorXd& y) {
        const Eigen::Matrix3d d = E * law.derivative(stress(y));
        Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, 3);
        jacobian.col(0) << -d(2, 2), d(0, 2), d(1, 2);
        return jacobian;
      },
      Eigen::Vector3d(m.poisson_ratio * (sigma_x + sigma_y), 0, 0), 1e-11);
  const Eigen::VectorXd y = integrator.advance(t);
  return {y[0], y[1] / E, y[2] / E, -(y[1] + y[2]) / E};
}

/// Two bars in series between fixed ends, same exponent: common stress after a stress s0 at t = 0.
struct Bar {
  double length, young_modulus, A;
};
inline double blocks_in_series(const Bar& one, const Bar& two, double n, double s0, double t) {
  const double flexibility = one.length / one.young_modulus + two.length / two.young_modulus;
  return power_relaxation(s0, (one.A * one.length + two.A * two.length) / flexibility, n, t);
}

}  // namespace creepcontact::reference
