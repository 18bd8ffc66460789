#include "creepcontact/mechanics/discretization.hpp"

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/numerics/parallel.hpp"
#include "element_block.hpp"
#include "linear_reconstruction.hpp"
#include "node_entries.hpp"

namespace creepcontact::mechanics {
namespace {

/// Work space of the calling thread; the loops overwrite all of it.
std::span<double> work_space(std::size_t n) {
  thread_local std::vector<double> space;
  if (space.size() < n) space.resize(n);
  return std::span(space).first(n);
}

}  // namespace

Discretization::Discretization(const mesh::Mesh& mesh) {
  append(mesh);
  if (blocks_.empty())
    throw ModelError(mesh.section.dimension() == 3 ? "the mesh has no volume elements"
                                                   : "the mesh has no surface elements");
  if (std::ranges::any_of(blocks_, [](const auto& block) { return LinearReconstruction::serves(block->type()); }))
    reconstruction_ = std::make_shared<LinearReconstruction>(
        blocks_, *entries_, coordinates_, weights_, [this](std::size_t entry) { return element_of_entry(entry); });
}

mesh::Mesh some_elements(const mesh::Mesh& mesh, std::span<const std::size_t> elements) {
  mesh::Mesh some;
  some.nodes = mesh.nodes;
  some.section = mesh.section;
  some.axial_node = mesh.axial_node;
  std::size_t first = 0;
  auto next = elements.begin();
  for (const mesh::CellBlock& cells : mesh.blocks) {
    if (!mesh.is_bulk(cells.type)) continue;
    mesh::CellBlock& chosen = some.blocks.emplace_back(mesh::CellBlock{.type = cells.type, .connectivity = {}});
    for (; next != elements.end() && *next < first + cells.size(); ++next) {
      const auto cell = cells.cell(*next - first);
      chosen.connectivity.insert(chosen.connectivity.end(), cell.begin(), cell.end());
    }
    first += cells.size();
  }
  return some;
}

Discretization Discretization::part(const mesh::Mesh& mesh, std::span<const std::size_t> elements) {
  Discretization result;
  result.append(some_elements(mesh, elements));
  return result;
}

void Discretization::append(const mesh::Mesh& mesh) {
  n_nodes_ = mesh.nodes.size();
  nodes_ = mesh.nodes;
  section_ = mesh.section;
  std::vector<std::int64_t> node_of_entry;
  for (const mesh::CellBlock& cells : mesh.blocks) {
    if (!mesh.is_bulk(cells.type) || cells.connectivity.empty()) continue;
    blocks_.push_back(std::make_shared<ElementBlock>(
        cells, mesh.nodes, mesh.section, BlockStart{n_elements_, n_points_, node_of_entry.size(), n_inner_}));
    const ElementBlock& block = *blocks_.back();
    node_of_entry.insert(node_of_entry.end(), block.connectivity().begin(), block.connectivity().end());
    n_elements_ += block.n_elements();
    n_points_ += block.n_elements() * block.n_points();
    n_inner_ += block.n_inner();
    for (std::size_t e = 0; e < block.n_elements(); ++e) {
      const auto weights = block.weights(e);
      weights_.insert(weights_.end(), weights.begin(), weights.end());
      for (std::size_t p = 0; p < block.n_points(); ++p) coordinates_.push_back(block.point(e, p, mesh.nodes));
    }
  }
  n_entries_ = node_of_entry.size();
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

std::size_t Discretization::element_of_entry(std::size_t entry) const {
  const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), entry,
                                      [](std::size_t i, const auto& block) { return i < block->start().entry; });
  const ElementBlock& block = **(after - 1);
  return block.start().element + (entry - block.start().entry) / block.n_coupled();
}

std::size_t Discretization::first_point(std::size_t element) const {
  if (element == n_elements_) return n_points_;
  const ElementBlock& block = block_of(element);
  return block.start().point + (element - block.start().element) * block.n_points();
}

std::optional<std::size_t> Discretization::inner(std::size_t element) const {
  const ElementBlock& block = block_of(element);
  if (block.n_inner() == 0) return std::nullopt;
  return block.start().inner + (element - block.start().element);
}

std::span<const std::int64_t> Discretization::element_nodes(std::size_t element) const {
  const ElementBlock& block = block_of(element);
  return block.nodes(element - block.start().element);
}

std::span<const std::int64_t> Discretization::coupled_nodes(std::size_t element) const {
  const ElementBlock& block = block_of(element);
  return block.coupled_nodes(element - block.start().element);
}

mesh::CellType Discretization::element_type(std::size_t element) const {
  return block_of(element).type();
}

Tensor6 ElasticState::elastic_strain(std::size_t point, const Tensor6& stress) const {
  if (matrices.empty()) return material::elastic_strain(at(point), stress);
  return linalg::solve_positive(matrices[point], stress);
}

void Discretization::stress(std::span<const double> u, const ElasticState& elastic, CreepStrainView creep,
                            std::span<double> stress) const {
  for (const auto& block : blocks_) block->stress(u, elastic, creep, stress);
}

void Discretization::add_internal_force(std::span<const double> stress, std::span<double> forces) const {
  const std::span<double> element_forces = work_space(3 * n_entries_);
  for (const auto& block : blocks_) block->internal_force(stress, element_forces);
  gather(element_forces, forces);
}

void Discretization::add_initial_strain_force(const ElasticState& elastic, CreepStrainView creep,
                                              std::span<double> forces) const {
  const std::span<double> element_forces = work_space(3 * n_entries_);
  for (const auto& block : blocks_) block->initial_strain_force(elastic, creep, element_forces);
  gather(element_forces, forces);
}

void Discretization::tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                                    std::span<const double> initial_stress, std::span<double> strain) const {
  for (const auto& block : blocks_) block->tangent_strain(u, moduli, initial_stress, strain);
}

void Discretization::add_initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                                              std::span<double> forces) const {
  const std::span<double> element_forces = work_space(3 * n_entries_);
  for (const auto& block : blocks_) block->initial_stress_force(moduli, initial_stress, element_forces);
  gather(element_forces, forces);
}

void Discretization::add_body_force(std::span<const Vector3> force_density, std::span<double> forces) const {
  const std::span<double> inner = forces.subspan(3 * n_nodes_);
  const std::span<double> element_forces = work_space(3 * n_entries_);
  for (const auto& block : blocks_) block->body_force(force_density, element_forces, inner);
  gather(element_forces, forces);
}

void Discretization::gather(std::span<const double> element_forces, std::span<double> forces) const {
#pragma omp parallel for schedule(static) if (n_nodes_ >= numerics::parallel_elements)
  for (std::size_t node = 0; node < n_nodes_; ++node) {
    double x = 0, y = 0, z = 0;
    for (const std::size_t entry : entries_->of(node)) {
      const double* force = element_forces.data() + 3 * entry;
      x += force[0];
      y += force[1];
      z += force[2];
    }
    forces[3 * node] += x;
    forces[3 * node + 1] += y;
    forces[3 * node + 2] += z;
  }
}

}  // namespace creepcontact::mechanics
