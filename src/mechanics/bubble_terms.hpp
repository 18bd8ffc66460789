#pragma once
/// The inner displacement a of one element with a bubble (fem/bubble.hpp), eliminated within the element.
///
/// With the gradient g of the bubble at a point, less its mean over the element (which is zero but for quadrature: so
/// the patch test is exact with any rule), and its projection v = sum of m_j l_j on the linear functions l,
///   P B_b a = sym(g a) + 1/3 (v . a - g . a) I.
/// In axisymmetric sections g is the gradient as it is, for the hoop strain N/x a_x has a mean too.

#include <Eigen/LU>

#include "creepcontact/base/index.hpp"
#include "element_block.hpp"

namespace creepcontact::mechanics {

/// Values at the points of an element.
template <int P>
using Lanes = Eigen::Array<double, P, 1>;
/// Tensors at the points of an element.
template <int P>
using LaneTensors = Eigen::Array<double, P, 6>;

inline constexpr double third = 1.0 / 3;

/// Isotropic moduli at the points of an element.
template <int P>
struct LaneModuli {
  LaneModuli(const ElasticState& elastic, std::size_t first) : uniform(elastic.moduli.size() == 1) {
    for (std::size_t p = 0; p < P; ++p) {
      const Moduli& h = elastic.at(first + p);
      lambda[p] = h.lambda;
      twice_mu[p] = 2 * h.mu;
    }
  }
  Lanes<P> bulk() const { return lambda + third * twice_mu; }

  bool uniform;
  Lanes<P> lambda, twice_mu;
};

/// How strain follows from displacements. Sections: unknowns and gradients in the plane z = 0 alone; zz is the hoop
/// strain u_x/x of axisymmetric ones, zero in plane strain, the displacement of the axial node in generalised plane
/// strain, and in plane stress the strain at which the stress zz vanishes.
enum class Kinematics { solid, plane, axisymmetric, generalized, plane_stress };

template <int P, Kinematics kinematics>
class BubbleTerms {
 public:
  using Values = Eigen::Map<const Lanes<P>>;
  using Vectors = Eigen::Map<const Eigen::Array<double, P, 3>>;
  using Geometry = Eigen::Map<const Eigen::Array<double, P, 10>>;

  /// @param geometry, derivatives  as ElementBlock has them @param linear  its linear_functions()
  /// @param hoop  N/x at the points; zero but in axisymmetric sections
  BubbleTerms(const Bubble& bubble, const Geometry& geometry, const Vectors& linear, const Vectors& derivatives,
              const Lanes<P>& hoop)
      : bubble_(bubble), weight_(geometry.col(9).data()), linear_(linear), hoop_(hoop) {
    for (Index i = 0; i < 3; ++i)
      gradient_.col(i) = geometry.col(i) * derivatives.col(0) + geometry.col(3 + i) * derivatives.col(1) +
                         geometry.col(6 + i) * derivatives.col(2) - bubble.mean_gradient[i];
  }

  /// strain += P B_b a, a in equilibrium with the stress H strain and the force on the bubble.
  void add_strain(const LaneModuli<P>& moduli, const Vector3& force, LaneTensors<P>& strain) const {
    if constexpr (kinematics == Kinematics::axisymmetric) return add_strain_by_matrices(moduli, force, strain);
    constexpr double half_sqrt2 = tensor::sqrt2 / 2;
    const Matrix3 flexibility = stiffness(moduli).inverse();  // first, for it does not wait for the sums
    const Lanes<P> bulk = weight_ * moduli.bulk(), twice_mu = weight_ * moduli.twice_mu;
    const Lanes<P> trace = strain.col(0) + strain.col(1) + strain.col(2), mean = third * trace, pressure = bulk * trace;
    const Lanes<P> x = twice_mu * gradient_.col(0), y = twice_mu * gradient_.col(1), z = twice_mu * gradient_.col(2);
    const Lanes<P> xy = half_sqrt2 * strain.col(3), yz = half_sqrt2 * strain.col(4), zx = half_sqrt2 * strain.col(5);
    const Vector3 deviatoric(((strain.col(0) - mean) * x + xy * y + zx * z).sum(),
                             (xy * x + (strain.col(1) - mean) * y + yz * z).sum(),
                             (zx * x + yz * y + (strain.col(2) - mean) * z).sum());
    const Vector3 volumetric((pressure * linear_.col(0)).sum(), (pressure * linear_.col(1)).sum(),
                             (pressure * linear_.col(2)).sum());
    const Vector3 residual = force - deviatoric - bubble_.moments.transpose() * volumetric;
    add_strain(flexibility * residual, strain);
  }

  /// strain += P B_b a, a in equilibrium with moduli strain - initial stress and the force on the bubble.
  /// @param moduli  P symmetric matrices @param initial_stress  P x 6, or empty
  void add_strain(std::span<const Matrix6> moduli, std::span<const double> initial_stress, const Vector3& force,
                  LaneTensors<P>& strain) const {
    Matrix3 stiffness = Matrix3::Zero();
    Vector3 residual = force;
    for (Index p = 0; p < P; ++p) {
      const Eigen::Matrix<double, 6, 3> matrix = strain_matrix(p), stress = moduli[p] * matrix;
      stiffness += weight_[p] * matrix.transpose() * stress;
      residual -= weight_[p] * stress.transpose() * strain.row(p).matrix().transpose();
      if (!initial_stress.empty()) residual += weight_[p] * matrix.transpose() * tensor::view(initial_stress, p);
    }
    add_matrices(stiffness.inverse() * residual, strain);
  }

 private:
  using StrainMatrix = Eigen::Matrix<double, 6, 3>;

  void add_matrices(const Vector3& a, LaneTensors<P>& strain) const {
    if constexpr (kinematics != Kinematics::axisymmetric) return add_strain(a, strain);
    for (Index p = 0; p < P; ++p) strain.row(p) += (strain_matrix(p) * a).transpose().array();
  }

  void add_strain_by_matrices(const LaneModuli<P>& moduli, const Vector3& force, LaneTensors<P>& strain) const {
    Matrix3 stiffness = Matrix3::Zero();
    Vector3 residual = force;
    for (Index p = 0; p < P; ++p) {
      const StrainMatrix matrix = strain_matrix(p);
      StrainMatrix stress = moduli.twice_mu[p] * matrix;
      stress.template topRows<3>().rowwise() += moduli.lambda[p] * matrix.template topRows<3>().colwise().sum();
      stiffness += weight_[p] * matrix.transpose() * stress;
      residual -= weight_[p] * stress.transpose() * strain.row(p).matrix().transpose();
    }
    add_matrices(stiffness.inverse() * residual, strain);
  }

  Matrix3 stiffness(const LaneModuli<P>& moduli) const {
    const Matrix3& m = bubble_.moments;
    if (moduli.uniform) return moduli.twice_mu[0] / 2 * bubble_.shear + moduli.bulk()[0] * m.transpose().lazyProduct(m);
    const Matrix3 squares = weighted_squares(gradient_, weight_ * moduli.twice_mu / 2);
    return third * squares + squares.trace() * Matrix3::Identity() +
           m.transpose() * weighted_squares(linear_, weight_ * moduli.bulk()) * m;
  }

  /// Sum over the points of weight x x^T.
  template <typename X>
  static Matrix3 weighted_squares(const X& x, const Lanes<P>& weight) {
    Matrix3 result;
    for (Index i = 0; i < 3; ++i) {
      const Lanes<P> weighted = weight * x.col(i);
      for (Index j = 0; j <= i; ++j) result(i, j) = result(j, i) = (weighted * x.col(j)).sum();
    }
    return result;
  }

  void add_strain(const Vector3& a, LaneTensors<P>& strain) const {
    constexpr double half_sqrt2 = tensor::sqrt2 / 2;
    const auto x = gradient_.col(0), y = gradient_.col(1), z = gradient_.col(2);
    const Vector3 slopes = third * (bubble_.moments * a), b = half_sqrt2 * a;
    const Lanes<P> xx = a[0] * x, yy = a[1] * y, zz = a[2] * z;
    const Lanes<P> mean =
        slopes[0] * linear_.col(0) + slopes[1] * linear_.col(1) + slopes[2] * linear_.col(2) - third * (xx + yy + zz);
    strain.col(0) += xx + mean;
    strain.col(1) += yy + mean;
    strain.col(2) += zz + mean;
    strain.col(3) += b[1] * x + b[0] * y;
    strain.col(4) += b[2] * y + b[1] * z;
    strain.col(5) += b[0] * z + b[2] * x;
  }

  /// P B_b at a point.
  Eigen::Matrix<double, 6, 3> strain_matrix(Index p) const {
    constexpr double half_sqrt2 = tensor::sqrt2 / 2;
    const double x = gradient_(p, 0), y = gradient_(p, 1), z = gradient_(p, 2);
    const double xy = half_sqrt2 * x, yy = half_sqrt2 * y, zy = half_sqrt2 * z;
    Eigen::Matrix<double, 6, 3> result;
    result << x, 0, 0, 0, y, 0, 0, 0, z, yy, xy, 0, 0, zy, yy, zy, 0, xy;
    result(2, 0) += hoop_[p];
    Eigen::RowVector3d mean = linear_.row(p).matrix() * bubble_.moments - gradient_.row(p).matrix();
    mean[0] -= hoop_[p];
    result.template topRows<3>().rowwise() += (mean + bubble_.mean_divergence.transpose()) / 3;
    return result;
  }

  const Bubble& bubble_;
  Values weight_;
  Vectors linear_;
  Lanes<P> hoop_;
  Eigen::Array<double, P, 3> gradient_;
};

}  // namespace creepcontact::mechanics
