#pragma once
/// Symmetric second-order tensors as six numbers in Mandel order
///   (xx, yy, zz, sqrt2 xy, sqrt2 yz, sqrt2 zx),
/// so that the scalar product of two tensors is the dot product of their arrays, and stress and strain are treated
/// alike.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace creepcontact {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Tensor6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;  ///< linear map of such tensors, e.g. strain to stress

namespace tensor {

inline constexpr double sqrt2 = std::numbers::sqrt2;

/// Tensors in memory owned by others. A copy refers to the same six numbers; assigning to a Map writes them.
using Map = Eigen::Map<Tensor6>;
using ConstMap = Eigen::Map<const Tensor6>;

/// The zero tensor, as a default.
inline ConstMap zero() {
  static constexpr std::array<double, 6> numbers{};
  return ConstMap(numbers.data());
}
/// View of a tensor; valid as long as the tensor.
inline ConstMap view(const Tensor6& of) {
  return ConstMap(of.data());
}
ConstMap view(const Tensor6&& temporary) = delete;  // the view would outlive it
/// Tensor i of an array. @param tensors  n x 6 @param i  < n
inline ConstMap view(std::span<const double> tensors, std::size_t i) {
  return ConstMap(tensors.data() + 6 * i);
}
inline Map writable(Tensor6& of) {
  return Map(of.data());
}
/// Tensor i of an array, for writing. @param tensors  n x 6 @param i  < n
inline Map writable(std::span<double> tensors, std::size_t i) {
  return Map(tensors.data() + 6 * i);
}

inline double trace(const Tensor6& a) {
  return a[0] + a[1] + a[2];
}

inline Tensor6 identity() {
  return (Tensor6() << 1, 1, 1, 0, 0, 0).finished();
}

inline Tensor6 deviator(const Tensor6& a) {
  Tensor6 s = a;
  s.head<3>().array() -= trace(a) / 3.0;
  return s;
}

/// Square of the von Mises stress, without the root where a sum of squares needs it
inline double squared_von_mises(const Tensor6& stress) {
  return 1.5 * deviator(stress).squaredNorm();
}

/// von Mises equivalent stress q = sqrt(3/2 s:s)
inline double von_mises(const Tensor6& stress) {
  return std::sqrt(1.5) * deviator(stress).norm();
}

/// Equivalent creep strain sqrt(2/3 e:e) of the deviator e; in a uniaxial creep test it is the axial strain
inline double equivalent_strain(const Tensor6& strain) {
  return std::sqrt(2.0 / 3.0) * deviator(strain).norm();
}

/// Conversion between Mandel order and a symmetric matrix; from_matrix() takes the symmetric part.
inline Matrix3 to_matrix(const Tensor6& a) {
  Matrix3 m;
  m << a[0], a[3] / sqrt2, a[5] / sqrt2, a[3] / sqrt2, a[1], a[4] / sqrt2, a[5] / sqrt2, a[4] / sqrt2, a[2];
  return m;
}

inline Tensor6 from_matrix(const Matrix3& m) {
  return (Tensor6() << m(0, 0), m(1, 1), m(2, 2), sqrt2 * 0.5 * (m(0, 1) + m(1, 0)), sqrt2 * 0.5 * (m(1, 2) + m(2, 1)),
          sqrt2 * 0.5 * (m(2, 0) + m(0, 2)))
      .finished();
}

/// Spectral decomposition of a symmetric matrix: the sum of values[i] directions.col(i) directions.col(i)^T, with
/// ascending values and orthonormal directions.
struct Principal {
  explicit Principal(const Matrix3& matrix);
  Vector3 values;
  Matrix3 directions;
};

/// Eigenvalues of a symmetric matrix, ascending.
Vector3 principal_values(const Matrix3& matrix);

}  // namespace tensor
}  // namespace creepcontact
