#include "support/mechanics/meshes.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::test {
namespace {

/// Twice the grid index, so that the middle of any edge, face or cell has whole numbers too.
using GridPoint = std::array<int, 3>;

/// Cells of the unit grid cell by their corners (as bits x + 2 y + 4 z): 1 hexahedron, 2 wedges or 6 tetrahedra, the
/// same in every grid cell and fitting its neighbours.
std::vector<std::vector<int>> corner_bits(CellType type) {
  switch (mesh::n_corners(type)) {
    case 8:
      return {{0, 1, 3, 2, 4, 5, 7, 6}};
    case 6:
      return {{0, 1, 3, 4, 5, 7}, {0, 3, 2, 4, 7, 6}};
    default:
      return {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  }
}

GridPoint middle(const std::vector<GridPoint>& corners) {
  GridPoint sum{};
  for (const GridPoint& corner : corners)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += corner[i];
  for (int& component : sum) component /= static_cast<int>(corners.size());
  return sum;
}

/// All nodes of a cell in Gmsh's order, from its corners.
std::vector<GridPoint> cell_nodes(CellType type, const std::vector<GridPoint>& corners) {
  std::vector<GridPoint> nodes = corners;
  if (mesh::order(type) == 1) return nodes;
  for (const auto& [a, b] : mesh::cell_edges(type)) nodes.push_back(middle({corners[a], corners[b]}));
  if (type != CellType::hex27) return nodes;
  for (const mesh::LocalFace& face : mesh::cell_faces(type)) {
    std::vector<GridPoint> around;
    for (std::size_t i = 0; i < 4; ++i) around.push_back(corners[face.nodes[i]]);
    nodes.push_back(middle(around));
  }
  nodes.push_back(middle(corners));
  return nodes;
}

/// Nodes and cells of a box, added one after the other.
class BoxBuilder {
 public:
  BoxBuilder(CellType type, std::array<int, 3> divisions) : type_(type), divisions_(divisions), volume_{type, {}} {}

  void place_corners(const Vector3& lengths, const Vector3& origin, double distortion) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> shift(-distortion, distortion);
    for_each({divisions_[0] + 1, divisions_[1] + 1, divisions_[2] + 1}, [&](const GridPoint& index) {
      Vector3 position(index[0], index[1], index[2]);
      bool inside = distortion > 0;
      for (std::size_t c = 0; c < 3; ++c) inside = inside && index[c] > 0 && index[c] < divisions_[c];
      if (inside) position += Vector3(shift(generator), shift(generator), shift(generator));
      for (std::size_t c = 0; c < 3; ++c) position[c] /= divisions_[c];
      corner_places_[{2 * index[0], 2 * index[1], 2 * index[2]}] = origin + position.cwiseProduct(lengths);
    });
  }

  void add_cells() {
    for_each(divisions_, [&](const GridPoint& index) {
      for (const std::vector<int>& bits : corner_bits(type_)) {
        std::vector<GridPoint> corners;
        corners.reserve(bits.size());
        for (const int b : bits)
          corners.push_back({2 * (index[0] + (b & 1)), 2 * (index[1] + (b >> 1 & 1)), 2 * (index[2] + (b >> 2))});
        add_cell(cell_nodes(type_, corners));
      }
    });
  }

  mesh::Mesh build() && {
    mesh::Group all{"volume", 3, {}};
    for (std::size_t cell = 0; cell < volume_.size(); ++cell) all.cells.push_back({0, cell});
    mesh_.groups["volume"] = all;
    mesh_.blocks.push_back(std::move(volume_));
    for (auto& [type, block] : surface_blocks_) {
      for (const auto& [group, cell] : surface_cells_[type])
        mesh_.groups.try_emplace(group, mesh::Group{group, 2, {}})
            .first->second.cells.push_back({mesh_.blocks.size(), cell});
      mesh_.blocks.push_back(std::move(block));
    }
    return std::move(mesh_);
  }

 private:
  template <typename Work>
  static void for_each(const GridPoint& counts, const Work& work) {
    for (int k = 0; k < counts[2]; ++k)
      for (int j = 0; j < counts[1]; ++j)
        for (int i = 0; i < counts[0]; ++i) work(GridPoint{i, j, k});
  }

  void add_cell(const std::vector<GridPoint>& points) {
    for (const GridPoint& point : points) volume_.connectivity.push_back(number(point));
    for (const mesh::LocalFace& face : mesh::cell_faces(type_)) {
      for (std::size_t c = 0; c < 3; ++c) {
        for (const int side : {0, 1}) {
          const bool on_side =
              std::ranges::all_of(face.nodes, [&](int n) { return points[n][c] == 2 * side * divisions_[c]; });
          if (!on_side) continue;
          mesh::CellBlock& block = surface_blocks_.try_emplace(face.type, mesh::CellBlock{face.type, {}}).first->second;
          surface_cells_[face.type].emplace_back(std::string(1, "xyz"[c]) + "01"[side], block.size());
          for (const int n : face.nodes) block.connectivity.push_back(number(points[n]));
        }
      }
    }
  }

  std::int64_t number(const GridPoint& point) {
    const auto [entry, is_new] = numbers_.try_emplace(point, mesh_.nodes.size());
    if (is_new) mesh_.nodes.push_back(mean_of_corners(point));
    return entry->second;
  }

  /// Of the 1, 2, 4 or 8 corners around a node, or of the two ends of a diagonal. All diagonals of the simplices, and
  /// those of the wedges within the plane x, y, run in the direction (1, 1, 1) or its part within a face.
  Vector3 mean_of_corners(const GridPoint& point) const {
    const std::size_t n_diagonal = mesh::n_corners(type_) == 4 ? 3 : mesh::n_corners(type_) == 6 ? 2 : 0;
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (int bits = 0; bits < 8; ++bits) {
      GridPoint corner = point;
      bool used = true;
      int along_diagonal = -1;
      for (std::size_t c = 0; c < 3; ++c) {
        const int up = bits >> c & 1;
        if (point[c] % 2 == 0) {
          used = used && up == 1;
          continue;
        }
        corner[c] += 2 * up - 1;
        if (c >= n_diagonal) continue;
        used = used && (along_diagonal == -1 || along_diagonal == up);
        along_diagonal = up;
      }
      if (!used) continue;
      sum += corner_places_.at(corner);
      ++count;
    }
    return sum / count;
  }

  CellType type_;
  std::array<int, 3> divisions_;
  std::map<GridPoint, Vector3> corner_places_;
  std::map<GridPoint, std::int64_t> numbers_;
  mesh::Mesh mesh_;
  mesh::CellBlock volume_;
  std::map<CellType, mesh::CellBlock> surface_blocks_;
  std::map<CellType, std::vector<std::pair<std::string, std::size_t>>> surface_cells_;  // group, cell of the block
};

}  // namespace

mesh::Mesh box_mesh(CellType type, std::array<int, 3> divisions, const Vector3& lengths, const Vector3& origin,
                    double distortion) {
  BoxBuilder builder(type, divisions);
  builder.place_corners(lengths, origin, distortion);
  builder.add_cells();
  return std::move(builder).build();
}

}  // namespace creepcontact::test
