#pragma once
/// Materials with three axes of symmetry: orthotropic elasticity and thermal expansion, and creep with the
/// equivalent stress of Hill.
/// Tensors with respect to the material axes are six numbers in Mandel order, as all others.

#include <array>
#include <utility>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/tensor.hpp"

namespace creepcontact::material {

/// Engineering constants along the material axes 1, 2, 3, functions of T. Strain along axis 2 under stress along axis 1
/// is -nu12/E1 times the stress; nu21/E2 = nu12/E1.
struct Orthotropy {
  std::array<Function, 3> young_moduli;    ///< E1, E2, E3
  std::array<Function, 3> poisson_ratios;  ///< nu12, nu23, nu13
  std::array<Function, 3> shear_moduli;    ///< G12, G23, G13

  bool depends_on_temperature() const;
  /// Stress = H elastic strain, both with respect to the material axes. Symmetric and positive definite.
  /// @throws ModelError if the constants at T do not give such a matrix
  Matrix6 stiffness(double T) const;

  /// Isotropic constants of a mixture of such crystals in all directions, functions of T that throw as stiffness():
  /// mean of the bounds of Voigt and Reuss. Source: R. Hill, Proc. Phys. Soc. A 65 (1952).
  Function average_young_modulus() const;
  Function average_poisson_ratio() const;
};

/// Secant coefficients along the material axes 1, 2, 3, functions of T: thermal strain = alpha(T) (T - reference).
/// Without strains of shear between these axes.
struct ThermalExpansion {
  // NOLINTNEXTLINE(google-explicit-constructor): one is the usual case
  ThermalExpansion(const Function& in_all_directions = 0.0)
      : along{in_all_directions, in_all_directions, in_all_directions} {}
  ThermalExpansion(double in_all_directions)  // NOLINT(google-explicit-constructor)
      : ThermalExpansion(Function(in_all_directions)) {}
  explicit ThermalExpansion(std::array<Function, 3> along_axes) : along(std::move(along_axes)), has_axes(true) {}

  bool is_zero() const;
  /// Strains along the axes at the temperature T.
  Vector3 strains(double T, double reference) const;

  std::array<Function, 3> along;
  bool has_axes = false;  ///< false: the three are one
};

/// Ratios of the stresses along axes 1, 2, 3 and the shear stresses 12, 23, 13 times sqrt(3) to the von Mises stress of
/// an isotropic material that creeps as fast. All 1: isotropic. Equivalent stress:
///   q^2 = F (s22-s33)^2 + G (s33-s11)^2 + H (s11-s22)^2 + 2 L s23^2 + 2 M s13^2 + 2 N s12^2,
///   F = (1/R22^2 + 1/R33^2 - 1/R11^2)/2 and so on, L = 3/(2 R23^2), M = 3/(2 R13^2), N = 3/(2 R12^2).
/// Source: R. Hill, Proc. R. Soc. A 193 (1948).
struct HillRatios {
  std::array<double, 6> values{1, 1, 1, 1, 1, 1};  ///< R11, R22, R33, R12, R23, R13, all > 0
};

/// The symmetric A for which the von Mises stress of A stress is q, and which leaves the mean stress as it is. So the
/// isotropic part of a law (volumetric creep) stays isotropic, and equal ratios of 1 make A the identity. A law f(q) of
/// isotropic creep, seen through A, is the anisotropic one: strain rate = A rate(A stress) = f(q) dq/dstress. It is
/// associated, changes the volume only as the isotropic law does, and dissipates as the isotropic law does.
/// Source: A. P. Karafillis, M. C. Boyce, J. Mech. Phys. Solids 41 (1993).
/// @throws ModelError if q^2 is negative for some stress
Matrix6 hill_transformation(const HillRatios& ratios);

/// The orthogonal matrix that turns tensors with respect to material axes into global ones.
/// @param axes  orthonormal; column i is axis i
Matrix6 rotation(const Matrix3& axes);

/// A map between tensors with respect to the material axes, for tensors with respect to the global ones.
inline Matrix6 turned(const Matrix6& map, const Matrix3& axes) {
  const Matrix6 turn = rotation(axes);
  return turn * map * turn.transpose();
}

}  // namespace creepcontact::material
