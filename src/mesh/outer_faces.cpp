#include "creepcontact/mesh/outer_faces.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::mesh {
namespace {

constexpr std::size_t max_corners = 4;

/// A face of a cell, and what identifies it: its corners, ascending.
struct Candidate {
  std::array<std::int64_t, max_corners> corners;
  std::uint32_t block, face;
  std::uint64_t cell;

  auto place() const { return std::tie(block, cell, face); }
};

std::vector<Candidate> all_faces(std::span<const CellBlock> blocks, int dimension) {
  std::vector<Candidate> all;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (mesh::dimension(blocks[b].type) != dimension) continue;
    const std::vector<LocalFace>& faces = cell_faces(blocks[b].type);
    for (std::size_t c = 0; c < blocks[b].size(); ++c)
      for (std::size_t f = 0; f < faces.size(); ++f) {
        Candidate candidate{{-1, -1, -1, -1}, static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(f), c};
        for (int i = 0; i < n_corners(faces[f].type); ++i)
          candidate.corners[static_cast<std::size_t>(i)] =
              blocks[b].cell(c)[static_cast<std::size_t>(faces[f].nodes[static_cast<std::size_t>(i)])];
        std::ranges::sort(candidate.corners);
        all.push_back(candidate);
      }
  }
  return all;
}

}  // namespace

std::vector<Face> outer_faces(std::span<const CellBlock> blocks, int dimension) {
  std::vector<Candidate> all = all_faces(blocks, dimension);
  std::ranges::sort(all, {}, &Candidate::corners);
  std::vector<Candidate> outer;
  for (auto one = all.begin(); one != all.end();) {
    const auto next =
        std::find_if(one, all.end(), [&](const Candidate& other) { return other.corners != one->corners; });
    if (next - one == 1) outer.push_back(*one);
    one = next;
  }
  std::ranges::sort(outer, [](const Candidate& a, const Candidate& b) { return a.place() < b.place(); });
  std::vector<Face> faces;
  faces.reserve(outer.size());
  for (const Candidate& one : outer) {
    const LocalFace& local = cell_faces(blocks[one.block].type)[one.face];
    Face face{local.type, {}};
    for (const int node : local.nodes)
      face.nodes.push_back(blocks[one.block].cell(one.cell)[static_cast<std::size_t>(node)]);
    faces.push_back(std::move(face));
  }
  return faces;
}

std::vector<Face> cells_of_group(const Mesh& mesh, const Group& group) {
  std::vector<Face> cells;
  cells.reserve(group.cells.size());
  for (const auto& [block, number] : group.cells) {
    const std::span<const std::int64_t> nodes = mesh.blocks[block].cell(number);
    cells.push_back({mesh.blocks[block].type, {nodes.begin(), nodes.end()}});
  }
  return cells;
}

std::vector<std::int64_t> corners_of(const Face& face) {
  std::vector<std::int64_t> corners(face.nodes.begin(), face.nodes.begin() + n_corners(face.type));
  std::ranges::sort(corners);
  return corners;
}

}  // namespace creepcontact::mesh
