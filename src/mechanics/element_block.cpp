#include "element_block.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/bubble.hpp"
#include "creepcontact/fem/tangents.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::mechanics {

namespace {

using fem::Projection;

/// Rows: values of the shape functions of `basis` at positions in the reference cell.
Eigen::MatrixXd shape_values(const fem::ReferenceElement& basis, const Eigen::MatrixX3d& positions) {
  Eigen::MatrixXd values(positions.rows(), basis.n_nodes());
  Eigen::VectorXd shape(basis.n_nodes());
  for (Index i = 0; i < positions.rows(); ++i) {
    basis.shape(positions.row(i).transpose(), shape);
    values.row(i) = shape.transpose();
  }
  return values;
}

Eigen::MatrixXd extrapolation_matrix(const fem::ReferenceElement& reference, const fem::QuadratureRule& rule) {
  const bool complete = rule.points.rows() >= reference.n_nodes();
  const auto& basis = fem::reference_element(complete ? reference.type() : mesh::linear_type(reference.type()));
  // One point alone (tet4): the solution of least norm is the constant.
  return shape_values(basis, reference.nodes()) *
         linalg::least_squares(shape_values(basis, rule.points),
                               Eigen::MatrixXd::Identity(rule.points.rows(), rule.points.rows()));
}

Eigen::MatrixXd corner_matrix(const fem::ReferenceElement& reference, const fem::QuadratureRule& rule) {
  const Eigen::MatrixXd linear = shape_values(fem::reference_element(mesh::linear_type(reference.type())), rule.points);
  const Eigen::MatrixXd roots = rule.weights.cwiseSqrt().asDiagonal();
  return linalg::least_squares(roots * linear, roots);
}

}  // namespace

namespace {

/// The nodes of every cell, and in generalised plane strain the last node of all.
std::vector<std::int64_t> coupled_connectivity(const mesh::CellBlock& cells, std::size_t n_nodes,
                                               const mesh::Section& section) {
  if (!section.has_axial_node()) return cells.connectivity;
  std::vector<std::int64_t> result;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto cell = cells.cell(c);
    result.insert(result.end(), cell.begin(), cell.end());
    result.push_back(static_cast<std::int64_t>(n_nodes) - 1);
  }
  return result;
}

}  // namespace

ElementBlock::ElementBlock(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes,
                           const mesh::Section& section, BlockStart start)
    : reference_(fem::reference_element(cells.type)),
      rule_(fem::bulk_rule(cells.type, section)),
      section_(section),
      start_(start),
      n_nodes_(reference_.n_nodes()),
      n_coupled_(n_nodes_ + (section.has_axial_node() ? 1 : 0)),
      n_points_(rule_.size()),
      connectivity_(coupled_connectivity(cells, nodes.size(), section)),
      extrapolation_(extrapolation_matrix(reference_, rule_)) {
  tabulate();
  measure(nodes);
}

void ElementBlock::tabulate() {
  shape_.resize(n_nodes_, n_points_);
  derivatives_.resize(n_points_ * n_nodes_ * 3);
  derivative_lanes_.resize(derivatives_.size());
  shape_lanes_.resize(n_points_ * n_nodes_);
  derivatives_by_points_.resize(n_points_ * 3 * n_padded());
  shape_by_points_.resize(n_points_ * n_padded());
  if (fem::has_bubble(type()) && !has_plane_stress()) bubble_derivatives_.resize(n_points_, 3);
  Eigen::MatrixX3d gradient(n_nodes_, 3);
  const Vector3 middle = reference_.nodes().topRows(mesh::n_corners(type())).colwise().mean();
  for (std::size_t p = 0; p < n_points_; ++p) {
    const Vector3 xi = rule_.points.row(p).transpose();
    reference_.shape(xi, shape_.col(p));
    reference_.gradient(xi, gradient);
    for (std::size_t a = 0; a < n_nodes_; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        derivatives_[(p * n_nodes_ + a) * 3 + k] = derivative_lanes_[(3 * a + k) * n_points_ + p] =
            derivatives_by_points_[(3 * p + k) * n_padded() + a] = gradient(a, k);
    for (std::size_t a = 0; a < n_nodes_; ++a)
      shape_lanes_[a * n_points_ + p] = shape_by_points_[p * n_padded() + a] = shape_(a, p);
    if (!has_bubble()) continue;
    const Vector3 bubble = fem::bubble_gradient(type(), xi), from_middle = xi - middle;
    bubble_derivatives_.row(p) = bubble.transpose();
    bubble_values_.push_back(fem::bubble_value(type(), xi));
    // Integral of N = - integral of xi . grad N / dimension. By quadrature, only this balances the stress whose
    // divergence the force is.
    bubble_shares_.push_back(section_.is_axisymmetric() ? bubble_values_.back()
                                                        : -from_middle.dot(bubble) / section_.dimension());
  }
}

void ElementBlock::measure(const std::vector<Vector3>& nodes) {
  geometry_.resize(10 * n_elements() * n_points_);
  std::vector<Eigen::MatrixX3d> gradients(n_points_, Eigen::MatrixX3d(n_nodes_, 3));
  for (std::size_t p = 0; p < n_points_; ++p)
    reference_.gradient(rule_.points.row(static_cast<Index>(p)).transpose(), gradients[p]);
  Eigen::Matrix3Xd x(3, n_nodes_);
  for (std::size_t e = 0; e < n_elements(); ++e) {
    for (std::size_t a = 0; a < n_nodes_; ++a) x.col(static_cast<Index>(a)) = nodes[this->nodes(e)[a]];
    double* geometry = &geometry_[10 * n_points_ * e];
    for (std::size_t p = 0; p < n_points_; ++p) {
      const Matrix3 jacobian = fem::jacobian(reference_, x, gradients[p]);
      const double determinant = jacobian.determinant();
      if (!(determinant > 0)) {
        const Vector3 at = point(e, p, nodes);
        throw ModelError(
            fmt::format("element {} ({}) at ({:.6g}, {:.6g}, {:.6g}) is inverted or has no {}: "
                        "Jacobian {:.3g}; correct the mesh there",
                        start_.element + e, mesh::name(type()), at[0], at[1], at[2],
                        section_.dimension() == 3 ? "volume" : "area", determinant));
      }
      const Matrix3 inverse = jacobian.inverse();
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 3; ++j) geometry[(3 * k + j) * n_points_ + p] = inverse(k, j);
      const Vector3 position = point(e, p, nodes);
      geometry[9 * n_points_ + p] = determinant * rule_.weights[p] * section_.depth(position);
      if (section_.is_axisymmetric()) inverse_radius_.push_back(1 / position.x());
    }
  }
  if (projection() == Projection::linear) find_linear_functions(nodes);
  if (has_bubble()) measure_bubbles();
  if (fits_mean_stress()) measure_distortion();
}

Matrix3 ElementBlock::inverse_jacobian(std::size_t e, std::size_t p) const {
  Matrix3 result;
  for (std::size_t i = 0; i < 9; ++i) result(i / 3, i % 3) = geometry(e)[i * n_points_ + p];
  return result;
}

void ElementBlock::measure_distortion() {
  constexpr double min_distortion = 0.2,
                   max_distortion = 0.3;  // relative change of the inverse Jacobian: no projection, all of it
  for (std::size_t e = 0; e < n_elements(); ++e) {
    Matrix3 mean = Matrix3::Zero();
    for (std::size_t p = 0; p < n_points_; ++p) mean += inverse_jacobian(e, p) / static_cast<double>(n_points_);
    const Matrix3 jacobian = mean.inverse();
    double change = 0;
    for (std::size_t p = 0; p < n_points_; ++p)
      change = std::max(change, (inverse_jacobian(e, p) * jacobian - Matrix3::Identity()).norm());
    unprojected_part_.push_back(
        section_.project_distorted ? std::clamp((max_distortion - change) / (max_distortion - min_distortion), 0.0, 1.0)
                                   : 1.0);
  }
}

void ElementBlock::find_linear_functions(const std::vector<Vector3>& nodes) {
  linear_functions_.resize(3 * n_elements() * n_points_);
  for (std::size_t e = 0; e < n_elements(); ++e) {
    const auto weight = weights(e);
    Eigen::Map<Eigen::MatrixX3d> positions(&linear_functions_[3 * n_points_ * e], weight.size(), 3);
    for (std::size_t p = 0; p < n_points_; ++p) positions.row(p) = point(e, p, nodes);
    positions.rowwise() -= (weight.transpose() * positions / weight.sum()).eval();
    // Gram and Schmidt, twice: flat elements too.
    for (Index j = 0; j < section_.dimension(); ++j) {
      for (int pass = 0; pass < 2; ++pass)
        for (Index k = 0; k < j; ++k)
          positions.col(j) -= positions.col(k).cwiseProduct(weight).dot(positions.col(j)) * positions.col(k);
      positions.col(j) /= std::sqrt(positions.col(j).cwiseAbs2().dot(weight));
    }
  }
}

void ElementBlock::measure_bubbles() {
  std::vector<Vector3> gradients(n_points_);
  for (std::size_t e = 0; e < n_elements(); ++e) {
    const auto weight = weights(e);
    const double volume = weight.sum();
    Vector3 mean = Vector3::Zero();
    for (std::size_t p = 0; p < n_points_; ++p) {
      gradients[p] = inverse_jacobian(e, p).transpose() * bubble_derivatives_.row(static_cast<Index>(p)).transpose();
      // The divergence, where it is more than the gradient.
      if (section_.is_axisymmetric()) gradients[p][0] += bubble_values_[p] * inverse_radius(e)[p];
      mean += weight[static_cast<Index>(p)] / volume * gradients[p];
    }
    Bubble bubble{Vector3::Zero(), Matrix3::Zero(), Matrix3::Zero()};
    (section_.is_axisymmetric() ? bubble.mean_divergence : bubble.mean_gradient) = mean;
    Matrix3 squares = Matrix3::Zero();
    for (std::size_t p = 0; p < n_points_; ++p) {
      const double* const linear = linear_functions(e) + p;
      const Vector3 own = gradients[p] - bubble.mean_gradient, weighted = weight[static_cast<Index>(p)] * own;
      bubble.moments += Vector3(linear[0], linear[n_points_], linear[2 * n_points_]) * weighted.transpose();
      squares += weighted * own.transpose();
    }
    if (!section_.is_axisymmetric()) bubble.shear = squares / 3 + squares.trace() * Matrix3::Identity();
    bubbles_.push_back(bubble);
  }
}

Eigen::MatrixXd ElementBlock::basis(std::size_t e) const {
  const Projection projection = this->projection();
  const Index n_p = n_points_;
  if (projection == Projection::none) return Eigen::MatrixXd(n_p, 0);
  const double constant = 1 / std::sqrt(weights(e).sum());
  if (projection == Projection::constant) return Eigen::MatrixXd::Constant(n_p, 1, constant);
  Eigen::MatrixXd basis(n_p, 4);
  basis.col(0).setConstant(constant);
  basis.rightCols<3>() = Eigen::Map<const Eigen::MatrixX3d>(linear_functions(e), n_p, 3);
  return basis;
}

Projection ElementBlock::projection() const {
  return has_plane_stress() ? Projection::none : reference_.volumetric_strain();
}

bool ElementBlock::fits_mean_stress() const {
  const bool is_reduced = rule_.size() < reference_.n_nodes();
  return is_reduced && reference_.projects_distorted_elements_only() && !has_plane_stress();
}

Eigen::MatrixXd ElementBlock::to_corners() const {
  return corner_matrix(reference_, rule_);
}

Eigen::MatrixXd ElementBlock::mean_stress_at_nodes(std::size_t e, const std::vector<Vector3>& nodes,
                                                   const Eigen::Ref<const Eigen::MatrixXd>& at_points) const {
  const Eigen::MatrixXd basis = this->basis(e);
  const auto weight = weights(e);
  Eigen::MatrixXd fitted = Eigen::MatrixXd::Zero(n_points_, at_points.cols());
  for (Index field = 0; field < fitted.cols(); ++field)
    for (Index j = 0; j < basis.cols(); ++j) {
      double moment = 0;
      for (Index p = 0; p < fitted.rows(); ++p) moment += basis(p, j) * weight[p] * at_points(p, field);
      fitted.col(field) += moment * basis.col(j);
    }
  // The fit is linear in the place: its values at the points give those at the nodes.
  Eigen::MatrixXd points(n_points_, 4), places(n_nodes_, 4);
  const Vector3 origin = point(e, 0, nodes);
  for (std::size_t p = 0; p < n_points_; ++p) points.row(p) << 1, (point(e, p, nodes) - origin).transpose();
  const auto cell = this->nodes(e);
  for (std::size_t a = 0; a < n_nodes_; ++a) places.row(a) << 1, (nodes[cell[a]] - origin).transpose();
  return places * linalg::least_squares(points, fitted);
}

Vector3 ElementBlock::point(std::size_t e, std::size_t p, const std::vector<Vector3>& nodes) const {
  Vector3 x = Vector3::Zero();
  const auto cell = this->nodes(e);
  for (std::size_t a = 0; a < n_nodes_; ++a) x += shape_(a, p) * nodes[cell[a]];
  return x;
}

void ElementBlock::body_force(std::span<const Vector3> force_density, std::span<double> element_forces,
                              std::span<double> inner_forces) const {
  for (std::size_t e = 0; e < n_elements(); ++e) {
    Eigen::Map<Eigen::Matrix3Xd> forces(&element_forces[3 * (start_.entry + e * n_coupled_)], 3, n_coupled_);
    forces.setZero();
    for (std::size_t p = 0; p < n_points_; ++p) {
      const Vector3 force = weights(e)[p] * force_density[start_.point + e * n_points_ + p];
      forces.leftCols(shape_.rows()) += force * shape_.col(p).transpose();
      if (has_bubble()) Vector3::Map(&inner_forces[3 * (start_.inner + e)]) += bubble_shares_[p] * force;
    }
  }
}

}  // namespace creepcontact::mechanics
