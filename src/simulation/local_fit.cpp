#include "local_fit.hpp"

#include <algorithm>
#include <set>

#include "creepcontact/fem/reference_element.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double rank_threshold = 1e-5;  // of a monomial's part that others do not represent

Eigen::Matrix<double, 1, 10> monomials(const Vector3& x) {
  Eigen::Matrix<double, 1, 10> row;
  row << 1, x[0], x[1], x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0], x[0] * x[0], x[1] * x[1], x[2] * x[2];
  return row;
}

/// Integration points of the element and of every element that shares a node with it.
std::vector<std::size_t> points_around(const mechanics::Discretization& discretization, std::size_t element) {
  const auto own = discretization.element_nodes(element);
  const std::set<std::int64_t> nodes(own.begin(), own.end());
  std::vector<std::size_t> points;
  for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
    const auto others = discretization.element_nodes(e);
    if (!std::any_of(others.begin(), others.end(), [&](std::int64_t node) { return nodes.contains(node); })) continue;
    for (std::size_t p = discretization.first_point(e); p < discretization.first_point(e + 1); ++p) points.push_back(p);
  }
  return points;
}

Matrix3 jacobian_at_centre(const mechanics::Discretization& discretization, const mesh::Mesh& mesh,
                           std::size_t element) {
  const fem::ReferenceElement& reference = fem::reference_element(discretization.element_type(element));
  Eigen::MatrixX3d gradient(reference.n_nodes(), 3);
  reference.gradient(reference.nodes().colwise().mean().transpose(), gradient);
  Matrix3 jacobian = Matrix3::Zero();
  const auto nodes = discretization.element_nodes(element);
  for (int i = 0; i < reference.n_nodes(); ++i)
    jacobian += mesh.nodes[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)])] * gradient.row(i);
  return jacobian;
}

}  // namespace

std::vector<std::pair<std::size_t, double>> local_fit(const mechanics::Discretization& discretization,
                                                      const mesh::Mesh& mesh, std::size_t element, const Vector3& at) {
  const std::span<const Vector3> places = discretization.point_coordinates();
  const std::vector<std::size_t> points = points_around(discretization, element);
  const Matrix3 to_reference = jacobian_at_centre(discretization, mesh, element).inverse();

  // Value at the place = first coefficient c0 of the fit, with the place as origin: c = (W M)^+ W f.
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd matrix(n, 10);
  Eigen::VectorXd weights(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    // Distances in element sizes, each direction by its own: flat elements weigh right.
    const Vector3 x = to_reference * (places[points[static_cast<std::size_t>(i)]] - at);
    weights[i] = 1 / (1 + x.squaredNorm() * x.squaredNorm());
    matrix.row(i) = weights[i] * monomials(x);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor;
  factor.setThreshold(rank_threshold);
  factor.compute(matrix);
  // Row of the pseudo-inverse that gives c0, restricted to the columns of full rank.
  const Eigen::Index rank = factor.rank();
  Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < rank; ++k)
    if (factor.colsPermutation().indices()[k] == 0) row[k] = 1;
  const auto upper = factor.matrixQR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>();
  row.head(rank) = upper.transpose().solve(Eigen::VectorXd(row.head(rank)));
  row.applyOnTheLeft(factor.householderQ());
  std::vector<std::pair<std::size_t, double>> result;
  for (Eigen::Index i = 0; i < n; ++i) result.emplace_back(points[static_cast<std::size_t>(i)], row[i] * weights[i]);
  return result;
}

}  // namespace creepcontact::simulation
