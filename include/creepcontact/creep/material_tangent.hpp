#pragma once
/// The contribution of the material points of one body to a Newton system (I - gamma J) z = r of the creep rate. With
/// the linearised laws, d(rate) = A d(state) + C d(stress), the system of each point reads
///   M z - gamma C ds = r,   M = I - gamma A,   ds = H (B du - z_c)        (z_c: the creep strain in z).
/// It follows that z = M^-1 r + N ds with N = gamma M^-1 C, and
///   ds = D (B du - e),   D = (H^-1 + N_c)^-1,   e = (M^-1 r)_c.
/// An elastic problem for du remains, with the moduli D and the initial strain e.

#include <span>
#include <vector>

#include "creepcontact/creep/material_points.hpp"

namespace creepcontact::creep {

/// Elimination of z at all points of a body.
class MaterialTangent {
 public:
  /// @param points  of a body that creeps; must outlive the object
  explicit MaterialTangent(const MaterialPoints& points);

  /// Linearises the laws at `at`. Cost: stride + 6 directional derivatives of the laws per point.
  void prepare(double gamma, const PointsState& at);
  /// D per point. Symmetrised, since laws with internal variables may give unsymmetric ones; the Newton iteration then
  /// converges only linearly.
  std::span<const Matrix6> moduli() const { return moduli_; }

  /// stress = D e. @param r  n_points x stride @param stress  n_points x 6, Mandel order
  void initial_stress(std::span<const double> r, std::span<double> stress) const;
  /// z from the solution du. @param r, z  n_points x stride
  /// @param strain  B du, n_points x 6; empty: du = 0, each point by itself
  void solution(std::span<const double> r, std::span<const double> strain, std::span<double> z) const;
  /// z with du = 0, each point by itself, of laws linearised at `at`. Keeps nothing: less work than prepare() and
  /// solution() where the linearisation is used once.
  void solve_points(double gamma, const PointsState& at, std::span<const double> r, std::span<double> z) const;

 private:
  struct Work;
  /// [M^-1, N] of a point.
  Eigen::Map<Eigen::MatrixXd> eliminated_at(std::size_t p);
  Eigen::Map<const Eigen::MatrixXd> eliminated_at(std::size_t p) const;
  /// 6 if the rates at a point do not depend on the creep strain itself, as of most laws; else 0.
  Index first_state(std::size_t p, const PointsState& at, Work& work) const;
  void linearize(std::size_t p, const PointsState& at, Work& work) const;
  static void eliminate(double gamma, Work& work, Eigen::Ref<Eigen::MatrixXd> columns);
  void prepare_point(std::size_t p, double gamma, const PointsState& at, Work& work);

  const MaterialPoints& points_;
  std::size_t n_points_, stride_;
  std::vector<Matrix6> moduli_;
  std::vector<double> eliminated_;  // [M^-1, N] per point, stride x (stride + 6), column-major
};

}  // namespace creepcontact::creep
