
#include <algorithm>
#include <array>

#include "creepcontact/base/disjoint_sets.hpp"
#include "creepcontact/mechanics/free_motions.hpp"
#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::mechanics {
namespace {

struct FaceOfElement {
  std::array<std::int64_t, 4> corners{-1, -1, -1, -1};  // ascending
  std::size_t element = 0;
};

std::vector<FaceOfElement> all_faces(const mesh::Mesh& mesh) {
  std::vector<FaceOfElement> faces;
  std::size_t element = 0;
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    for (std::size_t c = 0; c < block.size(); ++c, ++element)
      for (const mesh::LocalFace& local : mesh::cell_faces(block.type)) {
        FaceOfElement face{.element = element};
        for (int i = 0; i < mesh::n_corners(local.type); ++i) face.corners[i] = block.cell(c)[local.nodes[i]];
        std::sort(face.corners.begin(), face.corners.end());
        faces.push_back(face);
      }
  }
  return faces;
}

}  // namespace

MeshParts mesh_parts(const mesh::Mesh& mesh) {
  std::vector<FaceOfElement> faces = all_faces(mesh);
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.corners < b.corners; });
  std::size_t n_elements = 0;
  for (const FaceOfElement& face : faces) n_elements = std::max(n_elements, face.element + 1);
  DisjointSets sets(n_elements);
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].corners == faces[i - 1].corners) sets.join(faces[i].element, faces[i - 1].element);

  std::vector<std::size_t> part_of_root(n_elements, n_elements);
  MeshParts parts;
  std::size_t element = 0;
  for (const mesh::CellBlock& block : mesh.blocks) {
    if (!mesh.is_bulk(block.type)) continue;
    for (std::size_t c = 0; c < block.size(); ++c, ++element) {
      std::size_t& part = part_of_root[sets.find(element)];
      if (part == n_elements) {
        part = parts.size();
        parts.emplace_back();
      }
      parts[part].insert(parts[part].end(), block.cell(c).begin(), block.cell(c).end());
    }
  }
  for (auto& nodes : parts) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  return parts;
}

}  // namespace creepcontact::mechanics
