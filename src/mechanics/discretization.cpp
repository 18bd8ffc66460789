#include "creepcontact/mechanics/discretization.hpp"

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "element_block.hpp"
#include "node_entries.hpp"

namespace creepcontact::mechanics {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The values at the points of an element, n_points x width.
Eigen::Map<const Rows> rows_of(const ElementBlock& block, std::size_t e, std::span<const double> point_values,
                               int width) {
  const std::size_t first = block.start().point + e * block.n_points();
  return {&point_values[first * static_cast<std::size_t>(width)], static_cast<Eigen::Index>(block.n_points()), width};
}

}  // namespace

Discretization::Discretization(const mesh::Mesh& mesh) : n_nodes_(mesh.nodes.size()), nodes_(mesh.nodes) {
  std::vector<std::int64_t> node_of_entry;
  for (const mesh::CellBlock& cells : mesh.blocks) {
    if (mesh::dimension(cells.type) != 3 || cells.connectivity.empty()) continue;
    blocks_.push_back(ElementBlock::make(cells, mesh.nodes, {n_elements_, n_points_, node_of_entry.size(), n_inner_}));
    const ElementBlock& block = *blocks_.back();
    node_of_entry.insert(node_of_entry.end(), cells.connectivity.begin(), cells.connectivity.end());
    n_elements_ += block.n_elements();
    n_points_ += block.n_elements() * block.n_points();
    n_inner_ += block.n_inner();
    for (const PointGeometry& at : block.geometry()) weights_.push_back(at.weight);
    for (std::size_t e = 0; e < block.n_elements(); ++e)
      for (std::size_t p = 0; p < block.n_points(); ++p) coordinates_.push_back(block.point(e, p, mesh.nodes));
  }
  if (blocks_.empty()) throw ModelError("the mesh has no volume elements");
  element_forces_.resize(3 * node_of_entry.size());
  entries_ = std::make_shared<NodeEntries>(n_nodes_, node_of_entry);
}

std::size_t Discretization::n_nodes() const {
  return n_nodes_;
}
std::size_t Discretization::n_elements() const {
  return n_elements_;
}
std::size_t Discretization::n_points() const {
  return n_points_;
}
std::size_t Discretization::n_inner() const {
  return n_inner_;
}
std::span<const Vector3> Discretization::point_coordinates() const {
  return coordinates_;
}
std::span<const double> Discretization::weights() const {
  return weights_;
}

const ElementBlock& Discretization::block_of(std::size_t element) const {
  const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), element,
                                      [](std::size_t e, const auto& block) { return e < block->start().element; });
  return **(after - 1);
}

std::size_t Discretization::first_point(std::size_t element) const {
  if (element == n_elements_) return n_points_;
  const ElementBlock& block = block_of(element);
  return block.start().point + (element - block.start().element) * block.n_points();
}

std::span<const std::int64_t> Discretization::element_nodes(std::size_t element) const {
  const ElementBlock& block = block_of(element);
  return block.nodes(element - block.start().element);
}

mesh::CellType Discretization::element_type(std::size_t element) const {
  return block_of(element).type();
}

void Discretization::stress(std::span<const double> u, const ElasticState& elastic, CreepStrainView creep,
                            std::span<double> stress) const {
  for (const auto& block : blocks_) block->stress(u, elastic, creep, stress);
}

void Discretization::add_internal_force(std::span<const double> stress, std::span<double> forces) const {
  for (const auto& block : blocks_) block->internal_force(stress, element_forces_);
  gather(forces);
}

void Discretization::add_initial_strain_force(const ElasticState& elastic, CreepStrainView creep,
                                              std::span<double> forces) const {
  for (const auto& block : blocks_) block->initial_strain_force(elastic, creep, element_forces_);
  gather(forces);
}

void Discretization::tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                                    std::span<const double> initial_stress, std::span<double> strain) const {
  for (const auto& block : blocks_) block->tangent_strain(u, moduli, initial_stress, strain);
}

void Discretization::add_initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                                              std::span<double> forces) const {
  for (const auto& block : blocks_) block->initial_stress_force(moduli, initial_stress, element_forces_);
  gather(forces);
}

void Discretization::add_body_force(std::span<const Vector3> force_density, std::span<double> forces) const {
  const std::span<double> inner = forces.subspan(3 * n_nodes_);
  for (const auto& block : blocks_) block->body_force(force_density, element_forces_, inner);
  gather(forces);
}

void Discretization::gather(std::span<double> forces) const {
#pragma omp parallel for schedule(static) if (n_nodes_ >= parallel_threshold)
  for (std::size_t node = 0; node < n_nodes_; ++node) {
    double x = 0, y = 0, z = 0;
    for (const std::size_t entry : entries_->of(node)) {
      const double* force = element_forces_.data() + 3 * entry;
      x += force[0];
      y += force[1];
      z += force[2];
    }
    forces[3 * node] += x;
    forces[3 * node + 1] += y;
    forces[3 * node + 2] += z;
  }
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

bool Discretization::fits_mean_stress() const {
  return std::ranges::any_of(blocks_, [](const auto& block) { return block->fits_mean_stress(); });
}

void Discretization::fit_mean_stress(std::span<double> stress) const {
  for (const auto& block : blocks_) block->fit_mean_stress(stress);
}

void Discretization::to_nodes(std::span<const double> point_values, int width, std::span<double> node_values) const {
  average_at_nodes(static_cast<std::size_t>(width), node_values, [&](const ElementBlock& block, std::size_t e) -> Rows {
    return block.extrapolation() * rows_of(block, e, point_values, width);
  });
}

void Discretization::tensors_to_nodes(std::span<const double> point_values, std::span<double> node_values) const {
  average_at_nodes(6, node_values, [&](const ElementBlock& block, std::size_t e) {
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
