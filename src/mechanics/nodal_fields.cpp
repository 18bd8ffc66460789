/// Fields at nodes and elements from their values at the integration points.

#include <algorithm>

#include "creepcontact/mechanics/discretization.hpp"
#include "element_block.hpp"
#include "node_entries.hpp"

namespace creepcontact::mechanics {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Of the values at an element's own points where its gradient is fitted: they count where neighbours tell nothing,
/// across a single layer of elements.
constexpr double own_weight = 1e-3;

/// The values at the points of an element, n_points x width.
Eigen::Map<const Rows> rows_of(const ElementBlock& block, std::size_t e, std::span<const double> point_values,
                               int width) {
  const std::size_t first = block.start().point + e * block.n_points();
  return {&point_values[first * static_cast<std::size_t>(width)], static_cast<Eigen::Index>(block.n_points()), width};
}

}  // namespace

/// Linear elements: their means are an order more accurate than what varies within them, so the gradient is that of the
/// means of the elements around.
class Discretization::LinearReconstruction {
 public:
  LinearReconstruction(const Discretization& body, std::span<const double> point_values, int width)
      : body_(body), width_(width), means_(body.n_elements() * static_cast<std::size_t>(width)) {
    body.to_elements(point_values, width, means_);
    std::vector<double> places(3 * body.n_points()), centres(3 * body.n_elements());
    for (std::size_t p = 0; p < body.n_points(); ++p) Vector3::Map(&places[3 * p]) = body.coordinates_[p];
    body.to_elements(places, 3, centres);
    for (std::size_t e = 0; e < body.n_elements(); ++e) centres_.emplace_back(Vector3::Map(&centres[3 * e]));
  }

  /// At the nodes of element e of the block, n_nodes x width.
  Rows at_nodes(const ElementBlock& block, std::size_t e, std::span<const double> point_values) const {
    const std::size_t element = block.start().element + e;
    const Vector3 centre = centres_[element];
    const auto cell = block.nodes(e);
    Eigen::MatrixX3d arms(cell.size(), 3);
    for (std::size_t a = 0; a < cell.size(); ++a)
      arms.row(static_cast<Eigen::Index>(a)) = body_.nodes_[static_cast<std::size_t>(cell[a])] - centre;
    // In element sizes, each direction by its own: flat elements weigh right.
    const Matrix3 to_sizes = Matrix3(arms.transpose() * arms).llt().matrixL().toDenseMatrix().inverse();

    Matrix3 normal = Matrix3::Zero();
    Rows right = Rows::Zero(3, width_);
    const auto add = [&](const Vector3& place, const auto& change, double weight) {
      const Vector3 arm = to_sizes * (place - centre);
      normal += weight * arm * arm.transpose();
      right += weight * arm * change;
    };
    for (const std::size_t other : neighbours(cell)) add(centres_[other], mean(other) - mean(element), 1.0);
    const auto own = rows_of(block, e, point_values, width_);
    for (std::size_t p = 0; p < block.n_points(); ++p)
      add(body_.coordinates_[block.start().point + e * block.n_points() + p],
          own.row(static_cast<Eigen::Index>(p)) - mean(element), own_weight);
    const Rows gradient = normal.completeOrthogonalDecomposition().solve(right);
    Rows values = arms * to_sizes.transpose() * gradient;
    values.rowwise() += mean(element);
    return values;
  }

 private:
  Eigen::RowVectorXd mean(std::size_t element) const {
    return Eigen::RowVectorXd::Map(&means_[element * static_cast<std::size_t>(width_)], width_);
  }

  /// Elements that share a node with the cell, itself among them.
  std::vector<std::size_t> neighbours(std::span<const std::int64_t> cell) const {
    std::vector<std::size_t> result;
    for (const std::int64_t node : cell)
      for (const std::size_t entry : body_.entries_->of(static_cast<std::size_t>(node)))
        result.push_back(body_.element_of_entry(entry));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const Discretization& body_;
  int width_;
  std::vector<double> means_;
  std::vector<Vector3> centres_;
};

std::unique_ptr<const Discretization::LinearReconstruction> Discretization::reconstruction(
    std::span<const double> point_values, int width) const {
  const bool any = std::ranges::any_of(blocks_, [](const auto& block) { return mesh::order(block->type()) == 1; });
  return any ? std::make_unique<const LinearReconstruction>(*this, point_values, width) : nullptr;
}

template <typename Values>
void Discretization::average_at_nodes(std::size_t width, std::span<double> node_values, const Values& values) const {
  std::fill(node_values.begin(), node_values.end(), 0.0);
  for (const auto& block : blocks_) {
    for (std::size_t e = 0; e < block->n_elements(); ++e) {
      const Rows at_nodes = values(*block, e);
      const auto cell = block->nodes(e);
      for (std::size_t a = 0; a < cell.size(); ++a)
        for (std::size_t i = 0; i < width; ++i)
          node_values[static_cast<std::size_t>(cell[a]) * width + i] += at_nodes.data()[a * width + i];
    }
  }
  for (std::size_t node = 0; node < n_nodes_; ++node) {
    const auto count = static_cast<double>(std::max<std::size_t>(1, entries_->of(node).size()));
    for (std::size_t i = 0; i < width; ++i) node_values[node * width + i] /= count;
  }
}

void Discretization::to_nodes(std::span<const double> point_values, int width, std::span<double> node_values) const {
  const auto linear = reconstruction(point_values, width);
  average_at_nodes(static_cast<std::size_t>(width), node_values, [&](const ElementBlock& block, std::size_t e) -> Rows {
    if (mesh::order(block.type()) == 1) return linear->at_nodes(block, e, point_values);
    return block.extrapolation() * rows_of(block, e, point_values, width);
  });
}

void Discretization::tensors_to_nodes(std::span<const double> point_values, std::span<double> node_values) const {
  const auto linear = reconstruction(point_values, 6);
  average_at_nodes(6, node_values, [&](const ElementBlock& block, std::size_t e) -> Rows {
    if (mesh::order(block.type()) == 1) return linear->at_nodes(block, e, point_values);
    const auto at_points = rows_of(block, e, point_values, 6);
    Rows at_nodes = block.extrapolation() * at_points;
    const Eigen::VectorXd trace = at_points.leftCols<3>().rowwise().sum();
    const Eigen::VectorXd shift =
        (block.mean_stress_extrapolation(e, nodes_) * trace - at_nodes.leftCols<3>().rowwise().sum()) / 3;
    at_nodes.leftCols<3>().colwise() += shift;
    return at_nodes;
  });
}

void Discretization::to_elements(std::span<const double> point_values, int width,
                                 std::span<double> element_values) const {
  const auto w = static_cast<std::size_t>(width);
  std::fill(element_values.begin(), element_values.end(), 0.0);
  std::size_t point = 0;
  for (std::size_t e = 0; e < n_elements_; ++e) {
    const std::size_t end = first_point(e + 1);
    double volume = 0;
    for (; point < end; ++point) {
      volume += weights_[point];
      for (std::size_t i = 0; i < w; ++i) element_values[e * w + i] += weights_[point] * point_values[point * w + i];
    }
    for (std::size_t i = 0; i < w; ++i) element_values[e * w + i] /= volume;
  }
}

}  // namespace creepcontact::mechanics
