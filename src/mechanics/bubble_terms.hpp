#pragma once
/// The inner displacement a of one element with a bubble (fem/bubble.hpp), eliminated within the element.
///
/// With the gradient g of the bubble at a point, less its mean over the element (which is zero but for quadrature: so
/// the patch test is exact with any rule), and its projection v = sum of m_j l_j on the linear functions l,
///   P B_b a = sym(g a) + 1/3 (v . a - g . a) I.
/// In axisymmetric sections g is the gradient as it is, for the hoop strain N/x a_x has a mean too.

#include <Eigen/LU>
#include <array>

#include "creepcontact/base/index.hpp"
#include "element_view.hpp"
#include "lanes.hpp"
#include "trace_projection.hpp"

namespace creepcontact::mechanics {

/// g at adjacent points.
template <typename V>
CREEPCONTACT_INLINE std::array<V, 3> bubble_gradient(const ElementView& element, std::size_t p) {
  const std::size_t n = element.n_points;
  std::array<V, 3> gradient;
  for (std::size_t j = 0; j < 3; ++j) {
    gradient[j] = V{} - element.bubble->mean_gradient[static_cast<Index>(j)];
    for (std::size_t k = 0; k < 3; ++k)
      gradient[j] += load<V>(element.inverse + (3 * k + j) * n + p) * load<V>(element.bubble_derivatives + k * n + p);
  }
  return gradient;
}

/// a for isotropic moduli, without axial symmetry: first add() at all points, then solve(), then strain() at all
/// points.
class BubbleTerms {
 public:
  CREEPCONTACT_INLINE BubbleTerms(const ElementView& element, bool uniform) : element_(element), is_uniform_(uniform) {}

  /// @param strain  of the nodal displacements, projected or not
  template <typename V>
  CREEPCONTACT_INLINE void add(std::size_t p, const std::array<V, 6>& strain, const V& lambda, const V& twice_mu) {
    const V mean = third * (strain[0] + strain[1] + strain[2]), weight = load<V>(element_.weight + p);
    const V xy = half_sqrt2 * strain[3], yz = half_sqrt2 * strain[4], zx = half_sqrt2 * strain[5];
    const std::array<V, 3> gradient = bubble_gradient<V>(element_, p);
    const V stiffness = weight * twice_mu, x = stiffness * gradient[0], y = stiffness * gradient[1],
            z = stiffness * gradient[2];
    for (std::size_t i = 0; i < 3; ++i) store(gradient[i], &gradients_[i][p]);
    deviatoric_[0].add((strain[0] - mean) * x + xy * y + zx * z);
    deviatoric_[1].add(xy * x + (strain[1] - mean) * y + yz * z);
    deviatoric_[2].add(zx * x + yz * y + (strain[2] - mean) * z);
    if (is_uniform_) {
      twice_mu_ = first(twice_mu);
      bulk_ = first(lambda) + third * twice_mu_;
      return;
    }
    const V bulk = weight * (lambda + third * twice_mu);
    for (std::size_t i = 0, entry = 0; i < 3; ++i) {
      const V weighted = stiffness * gradient[i], linear = bulk * linear_function<V>(element_, p, i);
      bulk_moments_[i].add(linear);
      for (std::size_t j = 0; j <= i; ++j, ++entry) {
        squares_[entry].add(weighted * gradient[j]);
        linear_squares_[entry].add(linear * linear_function<V>(element_, p, j));
      }
    }
  }

  /// a in equilibrium with the stress of the strain and the force on the bubble. @param trace  of that strain
  template <std::size_t D>
  CREEPCONTACT_INLINE void solve(const TraceProjection<D>& trace, const Vector3& force) {
    const Matrix3& moments = element_.bubble->moments;
    Matrix3 stiffness;
    Vector3 volumetric = Vector3::Zero(), deviatoric;
    for (std::size_t j = 0; j < D; ++j) volumetric[static_cast<Index>(j)] = trace.moment(j);
    for (std::size_t i = 0; i < 3; ++i) deviatoric[static_cast<Index>(i)] = deviatoric_[i].value();
    if (is_uniform_) {
      stiffness = twice_mu_ / 2 * element_.bubble->shear + bulk_ * moments.transpose().lazyProduct(moments);
      volumetric *= bulk_;
    } else {
      const Matrix3 squares = symmetric(squares_) / 2, linear = symmetric(linear_squares_);
      stiffness = third * squares + squares.trace() * Matrix3::Identity() +
                  moments.transpose().lazyProduct(linear.lazyProduct(moments).eval());
      volumetric = linear.lazyProduct(volumetric).eval();
      for (std::size_t i = 0; i < 3; ++i) volumetric[static_cast<Index>(i)] += trace.mean() * bulk_moments_[i].value();
    }
    const Vector3 residual = force - deviatoric - moments.transpose().lazyProduct(volumetric);
    const Vector3 a = stiffness.inverse().lazyProduct(residual), slopes = third * moments.lazyProduct(a);
    for (std::size_t i = 0; i < 3; ++i) {
      a_[i] = a[static_cast<Index>(i)];
      slopes_[i] = slopes[static_cast<Index>(i)];
    }
  }

  /// strain += P B_b a
  template <typename V>
  CREEPCONTACT_INLINE void add_strain(std::size_t p, std::array<V, 6>& strain) const {
    const V x = load<V>(&gradients_[0][p]), y = load<V>(&gradients_[1][p]), z = load<V>(&gradients_[2][p]);
    const V xx = a_[0] * x, yy = a_[1] * y, zz = a_[2] * z;
    V mean = -third * (xx + yy + zz);
    for (std::size_t j = 0; j < 3; ++j) mean += slopes_[j] * linear_function<V>(element_, p, j);
    strain[0] += xx + mean;
    strain[1] += yy + mean;
    strain[2] += zz + mean;
    strain[3] += half_sqrt2 * (a_[1] * x + a_[0] * y);
    strain[4] += half_sqrt2 * (a_[2] * y + a_[1] * z);
    strain[5] += half_sqrt2 * (a_[0] * z + a_[2] * x);
  }

 private:
  static constexpr double third = 1.0 / 3, half_sqrt2 = tensor::sqrt2 / 2;
  using Squares = std::array<LaneSum, 6>;  // of two vectors: the lower triangle, row by row

  CREEPCONTACT_INLINE static double first(double value) { return value; }
  CREEPCONTACT_INLINE static double first(const Four& values) { return values[0]; }
  CREEPCONTACT_INLINE static Matrix3 symmetric(const Squares& sums) {
    Matrix3 result;
    for (std::size_t i = 0, entry = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j, ++entry)
        result(static_cast<Index>(i), static_cast<Index>(j)) = result(static_cast<Index>(j), static_cast<Index>(i)) =
            sums[entry].value();
    return result;
  }

  std::array<LaneSum, 3> deviatoric_, bulk_moments_;
  Squares squares_, linear_squares_;
  std::array<std::array<double, ElementView::max_points>, 3> gradients_;
  std::array<double, 3> a_{}, slopes_{};
  double twice_mu_ = 0, bulk_ = 0;  // uniform ones
  const ElementView& element_;
  bool is_uniform_;
};

/// P B_b at a point.
inline Eigen::Matrix<double, 6, 3> bubble_strain_matrix(const ElementView& element, std::size_t p) {
  constexpr double half_sqrt2 = tensor::sqrt2 / 2;
  const std::array<double, 3> gradient = bubble_gradient<double>(element, p);
  const double x = gradient[0], y = gradient[1], z = gradient[2];
  const double xy = half_sqrt2 * x, yy = half_sqrt2 * y, zy = half_sqrt2 * z;
  const double hoop = element.is_axisymmetric ? element.bubble_values[p] * element.inverse_radius[p] : 0;
  Eigen::Matrix<double, 6, 3> result;
  result << x, 0, 0, 0, y, 0, 0, 0, z, yy, xy, 0, 0, zy, yy, zy, 0, xy;
  result(2, 0) += hoop;
  const Eigen::RowVector3d linear(linear_function<double>(element, p, 0), linear_function<double>(element, p, 1),
                                  linear_function<double>(element, p, 2));
  Eigen::RowVector3d mean = linear * element.bubble->moments - Eigen::RowVector3d(x, y, z);
  mean[0] -= hoop;
  result.topRows<3>().rowwise() += (mean + element.bubble->mean_divergence.transpose()) / 3;
  return result;
}

}  // namespace creepcontact::mechanics
