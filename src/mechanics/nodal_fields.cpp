/// Fields at nodes and elements from their values at the integration points.

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/numerics/parallel.hpp"
#include "element_block.hpp"
#include "linear_reconstruction.hpp"
#include "node_entries.hpp"

namespace creepcontact::mechanics {
namespace {

using Rows = LinearReconstruction::Rows;

/// The values at the points of an element, n_points x width.
Eigen::Map<const Rows> rows_of(const ElementBlock& block, std::size_t e, std::span<const double> point_values,
                               int width) {
  const std::size_t first = block.start().point + e * block.n_points();
  return {&point_values[first * width], static_cast<Index>(block.n_points()), width};
}

}  // namespace

template <typename Values>
void Discretization::average_at_nodes(std::size_t width, std::span<double> node_values, const Values& values) const {
  std::fill(node_values.begin(), node_values.end(), 0.0);
  std::vector<double> volume_at(n_nodes_, 0.0);
  constexpr std::size_t at_once = 1024;
  std::vector<Rows> at_nodes(at_once);
  for (const auto& block : blocks_)
    for (std::size_t begin = 0; begin < block->n_elements(); begin += at_once) {
      const std::size_t n = std::min(at_once, block->n_elements() - begin);
      numerics::for_each_index(n, numerics::parallel_elements,
                               [&](std::size_t k) { at_nodes[k] = values(*block, begin + k); });
      for (std::size_t k = 0; k < n; ++k) {  // in order, for the same bits
        const double volume = block->weights(begin + k).sum();
        const double* value = at_nodes[k].data();
        for (const std::int64_t node : block->nodes(begin + k)) {
          volume_at[node] += volume;
          for (std::size_t i = 0; i < width; ++i) node_values[node * width + i] += volume * *value++;
        }
      }
    }
  for (std::size_t node = 0; node < n_nodes_; ++node)
    for (std::size_t i = 0; i < width && volume_at[node] > 0; ++i) node_values[node * width + i] /= volume_at[node];
}

void Discretization::to_nodes(std::span<const double> point_values, int width, std::span<double> node_values) const {
  const std::vector<double> means = reconstruction_means(point_values, width);
  average_at_nodes(width, node_values, [&](const ElementBlock& block, std::size_t e) -> Rows {
    const auto at_points = rows_of(block, e, point_values, width);
    if (mesh::order(block.type()) == 1) return reconstructed(block, e, means, at_points);
    return block.extrapolation() * at_points;
  });
}

void Discretization::tensors_to_nodes(std::span<const double> point_values, std::span<double> node_values) const {
  const std::size_t width = point_values.size() / n_points_;
  const Index n = static_cast<Index>(width) / 6;
  const std::vector<double> means = reconstruction_means(point_values, static_cast<int>(width));
  const auto traces = [n](const auto& rows) {
    Eigen::MatrixXd result(rows.rows(), n);
    for (Index i = 0; i < n; ++i) result.col(i) = rows.middleCols(6 * i, 3).rowwise().sum();
    return result;
  };
  average_at_nodes(width, node_values, [&](const ElementBlock& block, std::size_t e) -> Rows {
    const auto at_points = rows_of(block, e, point_values, static_cast<int>(width));
    if (mesh::order(block.type()) == 1) return reconstructed(block, e, means, at_points);
    Rows at_nodes = block.extrapolation() * at_points;
    if (block.has_plane_stress()) return at_nodes;
    const Eigen::MatrixXd trace = LinearReconstruction::serves(block.type())
                                      ? traces(reconstructed(block, e, means, at_points))
                                      : block.mean_stress_at_nodes(e, nodes_, traces(at_points));
    const Eigen::MatrixXd shift = (trace - traces(at_nodes)) / 3;
    for (Index i = 0; i < n; ++i) at_nodes.middleCols(6 * i, 3).colwise() += shift.col(i);
    return at_nodes;
  });
}

std::vector<double> Discretization::reconstruction_means(std::span<const double> point_values, int width) const {
  std::vector<double> means(reconstruction_ ? n_elements_ * static_cast<std::size_t>(width) : 0);
  if (reconstruction_) to_elements(point_values, width, means);
  return means;
}

/// Values at the nodes of an element, n_nodes x width.
Eigen::MatrixXd Discretization::reconstructed(const ElementBlock& block, std::size_t e, std::span<const double> means,
                                              const Eigen::Ref<const Rows>& at_points) const {
  const std::size_t element = block.start().element + e;
  const auto cell = block.nodes(e);
  Eigen::MatrixX3d arms(cell.size(), 3);
  for (std::size_t a = 0; a < cell.size(); ++a) arms.row(a) = nodes_[cell[a]] - reconstruction_->centre(element);
  Eigen::MatrixXd values = arms * reconstruction_->gradient(block, e, means, at_points);
  values.rowwise() += Eigen::RowVectorXd::Map(&means[element * at_points.cols()], at_points.cols());
  return values;
}

Eigen::MatrixXd Discretization::to_corners(std::size_t element) const {
  return block_of(element).to_corners();
}

bool Discretization::fits_mean_stress() const {
  if (has_plane_stress()) return false;
  return reconstruction_ || std::ranges::any_of(blocks_, [](const auto& block) { return block->fits_mean_stress(); });
}

void Discretization::fit_mean_stress(std::span<double> stress) const {
  if (has_plane_stress()) return;  // the stress zz must remain zero
  for (const auto& block : blocks_) block->fit_mean_stress(stress);
  if (!reconstruction_) return;
  std::vector<double> traces(n_points_), at_nodes(n_nodes_);
  for (std::size_t p = 0; p < n_points_; ++p) traces[p] = stress[6 * p] + stress[6 * p + 1] + stress[6 * p + 2];
  const std::vector<double> means = reconstruction_means(traces, 1);
  average_at_nodes(1, at_nodes, [&](const ElementBlock& block, std::size_t e) -> Rows {
    const auto at_points = rows_of(block, e, traces, 1);
    if (LinearReconstruction::serves(block.type())) return reconstructed(block, e, means, at_points);
    return block.mean_stress_at_nodes(e, nodes_, at_points);
  });
  for (const auto& block : blocks_) {
    if (!LinearReconstruction::serves(block->type())) continue;
    const std::size_t n_corners = mesh::n_corners(block->type());
#pragma omp parallel for schedule(static) if (block->n_elements() >= numerics::parallel_elements)
    for (std::size_t e = 0; e < block->n_elements(); ++e) {
      const Vector3 slope = reconstruction_->gradient(*block, e, means, rows_of(*block, e, traces, 1)).col(0);
      Vector3 middle = Vector3::Zero();
      double mean = 0;
      for (const std::int64_t node : block->nodes(e).first(n_corners)) {
        middle += nodes_[node] / static_cast<double>(n_corners);
        mean += at_nodes[node] / static_cast<double>(n_corners);
      }
      const std::size_t first = block->start().point + e * block->n_points();
      for (std::size_t p = first; p < first + block->n_points(); ++p) {
        const double fit = mean + slope.dot(coordinates_[p] - middle);
        for (std::size_t i = 0; i < 3; ++i) stress[6 * p + i] += (fit - traces[p]) / 3;
      }
    }
  }
}

void Discretization::to_elements(std::span<const double> point_values, int width,
                                 std::span<double> element_values) const {
  const std::size_t w = width;
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
