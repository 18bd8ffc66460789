#include "local_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <set>
#include <utility>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/tangents.hpp"

namespace creepcontact::results {
namespace {

/// A monomial is kept if at least this share of it is not represented by the others. Smaller shares come from the
/// curvature of the elements alone (a single layer around a pipe) and would magnify small deviations of the field.
constexpr double rank_threshold = 3e-2;
/// Monomials smaller than this share of the constant are rounding, in directions in which the places do not differ.
constexpr double min_extent = 1e-6;

Eigen::Matrix<double, 1, 10> monomials(const Vector3& x) {
  Eigen::Matrix<double, 1, 10> row;
  row << 1, x[0], x[1], x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0], x[0] * x[0], x[1] * x[1], x[2] * x[2];
  return row;
}

/// A place at which a value is taken: one integration point, or the mean over several.
struct SamplePlace {
  Vector3 position = Vector3::Zero();
  std::vector<std::pair<std::size_t, double>> points;  // with their shares, which add up to 1
};

/// The points where quadrilaterals and hexahedra with more points than nodes are most accurate: those of reduced
/// integration.
const fem::QuadratureRule& accurate_points(mesh::CellType type) {
  const bool is_plane = mesh::dimension(type) == 2;
  return fem::reference_element(is_plane ? mesh::CellType::quad8 : mesh::CellType::hex20).bulk_rule();
}

/// The places where elements are most accurate: integration points of quadratic ones, in fully integrated
/// quadrilaterals and hexahedra the points of reduced integration, the middle of linear ones (their stress varies
/// wrongly within an element).
void add_samples(const mechanics::Discretization& discretization, const mesh::Mesh& mesh, std::size_t element,
                 std::vector<SamplePlace>& samples) {
  const mesh::CellType type = discretization.element_type(element);
  const bool linear = mesh::order(type) == 1;
  const std::size_t first = discretization.first_point(element), last = discretization.first_point(element + 1);
  const fem::ReferenceElement& reference = fem::reference_element(type);
  if (!linear && mesh::n_corners(type) != 3 && std::cmp_greater_equal(last - first, reference.n_nodes())) {
    const Eigen::MatrixXd to_corners = discretization.to_corners(element);
    const fem::ReferenceElement& corners = fem::reference_element(mesh::linear_type(type));
    Eigen::VectorXd shape(reference.n_nodes()), linear_shape(corners.n_nodes());
    const auto nodes = discretization.element_nodes(element);
    const fem::QuadratureRule& rule = accurate_points(type);
    for (Index k = 0; k < rule.points.rows(); ++k) {
      const Vector3 xi = rule.points.row(k).transpose();
      reference.shape(xi, shape);
      corners.shape(xi, linear_shape);
      SamplePlace& place = samples.emplace_back();
      for (Index a = 0; a < shape.size(); ++a) place.position += shape[a] * mesh.nodes[nodes[a]];
      const Eigen::RowVectorXd shares = linear_shape.transpose() * to_corners;
      for (std::size_t p = first; p < last; ++p) place.points.emplace_back(p, shares[static_cast<Index>(p - first)]);
    }
    return;
  }
  double volume = 0;
  for (std::size_t p = first; p < last; ++p) volume += discretization.weights()[p];
  for (std::size_t p = first; p < last; ++p) {
    if (!linear || p == first) samples.emplace_back();
    const double share = linear ? discretization.weights()[p] / volume : 1.0;
    samples.back().position += share * discretization.point_coordinates()[p];
    samples.back().points.emplace_back(p, share);
  }
}

/// Places in these elements and in every element that shares a node with one of them.
std::vector<SamplePlace> samples_around(const mechanics::Discretization& discretization, const mesh::Mesh& mesh,
                                        std::span<const std::size_t> elements) {
  std::set<std::int64_t> nodes;
  for (const std::size_t element : elements) {
    const auto own = discretization.element_nodes(element);
    nodes.insert(own.begin(), own.end());
  }
  std::vector<SamplePlace> samples;
  for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
    const auto others = discretization.element_nodes(e);
    if (std::any_of(others.begin(), others.end(), [&](std::int64_t node) { return nodes.contains(node); }))
      add_samples(discretization, mesh, e, samples);
  }
  return samples;
}

Matrix3 jacobian_at_centre(const mechanics::Discretization& discretization, const mesh::Mesh& mesh,
                           std::size_t element) {
  const fem::ReferenceElement& reference = fem::reference_element(discretization.element_type(element));
  Eigen::MatrixX3d gradient(reference.n_nodes(), 3);
  reference.gradient(reference.nodes().colwise().mean().transpose(), gradient);
  const auto nodes = discretization.element_nodes(element);
  Eigen::Matrix3Xd x(3, reference.n_nodes());
  for (int i = 0; i < reference.n_nodes(); ++i) x.col(i) = mesh.nodes[nodes[i]];
  return fem::jacobian(reference, x, gradient);
}

/// The map to coordinates in which the elements have the size 1; the mean of their metrics favours none of them.
Matrix3 to_element_sizes(const mechanics::Discretization& discretization, const mesh::Mesh& mesh,
                         std::span<const std::size_t> elements) {
  if (elements.size() == 1) return jacobian_at_centre(discretization, mesh, elements[0]).inverse();
  Matrix3 metric = Matrix3::Zero();
  for (const std::size_t element : elements) {
    const Matrix3 inverse = jacobian_at_centre(discretization, mesh, element).inverse();
    metric += inverse.transpose() * inverse / static_cast<double>(elements.size());
  }
  return metric.llt().matrixU();
}

/// Row of the pseudo-inverse that gives the coefficient of the first column. Columns are taken in their order, each
/// only if those before do not represent it: what is left out are quadratic terms rather than linear ones.
Eigen::VectorXd row_of_constant(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd basis(matrix.rows(), matrix.cols());
  Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(matrix.cols(), matrix.cols());
  Index rank = 0;
  for (Index k = 0; k < matrix.cols(); ++k) {
    const auto before = basis.leftCols(rank);
    Eigen::VectorXd rest = matrix.col(k) - before * (before.transpose() * matrix.col(k));
    rest -= before * (before.transpose() * rest);  // twice is enough for orthogonality
    if (rest.norm() <= std::max(rank_threshold * matrix.col(k).norm(), min_extent * matrix.col(0).norm())) continue;
    upper.col(rank).head(rank) = before.transpose() * matrix.col(k);
    upper(rank, rank) = rest.norm();
    basis.col(rank++) = rest.normalized();
  }
  // matrix = Q R on the columns taken; the row is that of R^-1 Q^T.
  const Eigen::VectorXd first = Eigen::VectorXd::Unit(rank, 0);
  const Eigen::MatrixXd triangle = upper.topLeftCorner(rank, rank).transpose();
  return basis.leftCols(rank) * triangle.triangularView<Eigen::Lower>().solve(first);
}

}  // namespace

std::vector<std::pair<std::size_t, double>> local_fit(const mechanics::Discretization& discretization,
                                                      const mesh::Mesh& mesh, std::span<const std::size_t> elements,
                                                      const Vector3& at) {
  const std::vector<SamplePlace> samples = samples_around(discretization, mesh, elements);
  const Matrix3 to_reference = to_element_sizes(discretization, mesh, elements);

  // Value at the place = first coefficient c0 of the fit, with the place as origin: c = (W M)^+ W f.
  const Index n = samples.size();
  Eigen::MatrixXd matrix(n, 10);
  Eigen::VectorXd weights(n);
  for (Index i = 0; i < n; ++i) {
    // Distances in element sizes, each direction by its own: flat elements weigh right.
    const Vector3 x = to_reference * (samples[i].position - at);
    weights[i] = 1 / (1 + x.squaredNorm() * x.squaredNorm());
    matrix.row(i) = weights[i] * monomials(x);
  }
  const Eigen::VectorXd row = row_of_constant(matrix);
  std::vector<std::pair<std::size_t, double>> result;
  for (Index i = 0; i < n; ++i)
    for (const auto& [point, share] : samples[i].points) result.emplace_back(point, share * row[i] * weights[i]);
  return result;
}

std::vector<std::size_t> elements_at(const mechanics::Discretization& discretization, const PointLocation& place) {
  constexpr double min_weight = 1e-6;  // of a node that the place is not on
  std::vector<std::int64_t> on;
  for (std::size_t i = 0; i < place.nodes.size(); ++i)
    if (std::abs(place.weights[i]) > min_weight) on.push_back(place.nodes[i]);
  std::vector<std::size_t> elements;
  for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
    const auto nodes = discretization.element_nodes(e);
    if (std::ranges::all_of(on, [&](std::int64_t node) { return std::ranges::find(nodes, node) != nodes.end(); }))
      elements.push_back(e);
  }
  return elements;
}

}  // namespace creepcontact::results
