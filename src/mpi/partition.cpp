#include "creepcontact/mpi/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <numeric>

#include "creepcontact/base/error.hpp"

namespace creepcontact::mpi {
namespace {

/// Fewer elements per process are not worth the messages.
constexpr std::size_t least_elements = 20;

struct Elements {
  std::vector<idx_t> first{0}, corners;  // of every element its corner nodes
  std::vector<idx_t> work;               // about proportional to the time that its loops take
  std::size_t size() const { return work.size(); }
};

Elements elements_of(const mesh::Mesh& mesh) {
  Elements elements;
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    const int n_corners = mesh::n_corners(block.type);
    for (std::size_t c = 0; c < block.size(); ++c) {
      for (int i = 0; i < n_corners; ++i) elements.corners.push_back(static_cast<idx_t>(block.cell(c)[i]));
      elements.first.push_back(static_cast<idx_t>(elements.corners.size()));
      elements.work.push_back(mesh::n_nodes(block.type));
    }
  }
  return elements;
}

/// Parts that share faces (in sections edges) are neighbours.
std::vector<idx_t> pieces(Elements& elements, const mesh::Mesh& mesh, idx_t n_parts) {
  if (n_parts == 1) return std::vector<idx_t>(elements.size(), 0);  // METIS divides by zero
  idx_t n_elements = static_cast<idx_t>(elements.size()), n_nodes = static_cast<idx_t>(mesh.nodes.size());
  idx_t common = mesh.section.dimension(), cut = 0;
  std::vector<idx_t> of_element(elements.size()), of_node(mesh.nodes.size());
  if (METIS_PartMeshDual(&n_elements, &n_nodes, elements.first.data(), elements.corners.data(), elements.work.data(),
                         nullptr, &common, &n_parts, nullptr, nullptr, &cut, of_element.data(),
                         of_node.data()) != METIS_OK)
    throw SolverError("METIS cannot deal out the elements; probably memory has run out");
  return of_element;
}

}  // namespace

std::vector<std::vector<std::int32_t>> partition(const std::vector<const mesh::Mesh*>& bodies, const Team& team) {
  const int n = team.size();
  std::vector<std::vector<std::int32_t>> result(bodies.size());
  std::vector<double> load(n, 0.0);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Elements elements = elements_of(*bodies[b]);
    std::vector<double> ranks(elements.size(), 0.0);
    together(team, [&] {
      if (team.rank() != 0) return;
      if (elements.size() < least_elements * static_cast<std::size_t>(n)) {
        const auto least = std::ranges::min_element(load);
        *least += std::accumulate(elements.work.begin(), elements.work.end(), 0.0);
        std::ranges::fill(ranks, static_cast<double>(least - load.begin()));
        return;
      }
      std::ranges::copy(pieces(elements, *bodies[b], n), ranks.begin());
      for (std::size_t e = 0; e < ranks.size(); ++e) load[static_cast<std::size_t>(ranks[e])] += elements.work[e];
    });
    team.broadcast(ranks, 0);
    result[b].assign(ranks.begin(), ranks.end());
  }
  return result;
}

}  // namespace creepcontact::mpi
