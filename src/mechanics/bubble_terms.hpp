#pragma once
/// The inner displacement a of one element with a bubble (fem/bubble.hpp), eliminated where it stands.
///
/// With the gradient g of the bubble at a point, less its mean over the element (which is zero but for quadrature: so
/// the patch test is exact with any rule), and its projection v on the linear functions,
///   P B_b a = sym(g a) + 1/3 (v . a - g . a) I.

#include <array>
#include <cstddef>

#include "element_block.hpp"

namespace creepcontact::mechanics {

template <std::size_t P>
class BubbleTerms {
 public:
  /// @param at, linear  of the P points of the element @param derivatives  of the bubble in reference coordinates, P x
  /// 3
  BubbleTerms(const PointGeometry* at, const LinearFunctions* linear, const double* derivatives) : at_(at) {
    std::array<double, 3> mean{};
    double volume = 0;
    for (std::size_t p = 0; p < P; ++p) {
      const double* d = derivatives + 3 * p;
      const double* inverse = at[p].inverse;
      for (std::size_t i = 0; i < 3; ++i) {
        gradient_[p][i] = inverse[i] * d[0] + inverse[3 + i] * d[1] + inverse[6 + i] * d[2];
        mean[i] += at[p].weight * gradient_[p][i];
      }
      volume += at[p].weight;
    }
    std::array<std::array<double, 3>, 3> moments{};  // of linear function j and gradient component i
    for (std::size_t p = 0; p < P; ++p)
      for (std::size_t i = 0; i < 3; ++i) {
        gradient_[p][i] -= mean[i] / volume;
        for (std::size_t j = 0; j < 3; ++j) moments[j][i] += at[p].weight * linear[p][j] * gradient_[p][i];
      }
    for (std::size_t p = 0; p < P; ++p)
      for (std::size_t i = 0; i < 3; ++i)
        projected_[p][i] = linear[p][0] * moments[0][i] + linear[p][1] * moments[1][i] + linear[p][2] * moments[2][i];
  }

  /// Adds to the stress of isotropic moduli(p) what balances it with the force on the bubble. @param stress P x 6
  template <typename ModuliAt>
  void balance(const ModuliAt& moduli, const std::array<double, 3>& force, double* stress) const {
    Matrix3 stiffness = Matrix3::Zero();
    Vector3 residual(force[0], force[1], force[2]);
    for (std::size_t p = 0; p < P; ++p) {
      const Moduli& h = moduli(p);
      const Vector3 g = gradient(p), v = projected(p);
      const double mu = at_[p].weight * h.mu, bulk = at_[p].weight * (h.lambda + 2.0 / 3.0 * h.mu);
      stiffness += (mu / 3 * g) * g.transpose() + (bulk * v) * v.transpose();
      stiffness.diagonal().array() += mu * g.squaredNorm();
      residual -= at_[p].weight * work(p, stress + 6 * p);
    }
    const Vector3 a = stiffness.inverse() * residual;
    for (std::size_t p = 0; p < P; ++p) {
      const Moduli& h = moduli(p);
      const Tensor6 strain = strain_at(p, a);
      const double spherical = h.lambda * (strain[0] + strain[1] + strain[2]);
      for (Eigen::Index i = 0; i < 6; ++i)
        stress[6 * p + static_cast<std::size_t>(i)] += 2 * h.mu * strain[i] + (i < 3 ? spherical : 0.0);
    }
  }

  /// strain += P B_b a, a in equilibrium with moduli strain - initial stress. @param moduli  P symmetric matrices
  /// @param initial_stress  P x 6 @param strain  P x 6
  void add_strain(const Matrix6* moduli, const double* initial_stress, double* strain) const {
    Matrix3 stiffness = Matrix3::Zero();
    Vector3 residual = Vector3::Zero();
    for (std::size_t p = 0; p < P; ++p) {
      Eigen::Matrix<double, 6, 3> matrix;
      for (Eigen::Index i = 0; i < 3; ++i) matrix.col(i) = strain_at(p, Vector3::Unit(i));
      const Tensor6 stress =
          moduli[p] * Eigen::Map<const Tensor6>(strain + 6 * p) - Eigen::Map<const Tensor6>(initial_stress + 6 * p);
      stiffness += at_[p].weight * matrix.transpose() * moduli[p] * matrix;
      residual -= at_[p].weight * matrix.transpose() * stress;
    }
    const Vector3 a = stiffness.inverse() * residual;
    for (std::size_t p = 0; p < P; ++p) Eigen::Map<Tensor6>(strain + 6 * p) += strain_at(p, a);
  }

 private:
  Eigen::Map<const Vector3> gradient(std::size_t p) const { return Eigen::Map<const Vector3>(gradient_[p].data()); }
  Eigen::Map<const Vector3> projected(std::size_t p) const { return Eigen::Map<const Vector3>(projected_[p].data()); }

  Tensor6 strain_at(std::size_t p, const Vector3& a) const {
    constexpr double half_sqrt2 = tensor::sqrt2 / 2;
    const auto g = gradient(p);
    Tensor6 strain;
    strain << g[0] * a[0], g[1] * a[1], g[2] * a[2], half_sqrt2 * (g[0] * a[1] + g[1] * a[0]),
        half_sqrt2 * (g[1] * a[2] + g[2] * a[1]), half_sqrt2 * (g[2] * a[0] + g[0] * a[2]);
    strain.head<3>().array() += (projected(p) - g).dot(a) / 3;
    return strain;
  }

  /// (P B_b)^T stress at a point.
  Vector3 work(std::size_t p, const double* s) const {
    constexpr double half_sqrt2 = tensor::sqrt2 / 2;
    const double mean = (s[0] + s[1] + s[2]) / 3;
    const double xy = half_sqrt2 * s[3], yz = half_sqrt2 * s[4], zx = half_sqrt2 * s[5];
    const auto g = gradient(p);
    return Vector3((s[0] - mean) * g[0] + xy * g[1] + zx * g[2], xy * g[0] + (s[1] - mean) * g[1] + yz * g[2],
                   zx * g[0] + yz * g[1] + (s[2] - mean) * g[2]) +
           mean * projected(p);
  }

  const PointGeometry* at_;
  std::array<std::array<double, 3>, P> gradient_, projected_;
};

}  // namespace creepcontact::mechanics
