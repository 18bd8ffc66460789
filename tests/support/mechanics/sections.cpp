#include "support/mechanics/sections.hpp"

#include <map>
#include <random>
#include <string>
#include <vector>

#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::test {

using mesh::CellType;

mesh::Mesh section_mesh(CellType type, std::array<int, 2> divisions, const Eigen::Vector2d& lengths,
                        const Eigen::Vector2d& origin, const mesh::Section& section, double distortion) {
  using GridPoint = std::array<int, 2>;  // twice the index in the grid: middle nodes have whole numbers too
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shift(-distortion, distortion);
  std::map<GridPoint, Vector3> corners;
  for (int j = 0; j <= divisions[1]; ++j)
    for (int i = 0; i <= divisions[0]; ++i) {
      Eigen::Vector2d place(i, j);
      if (i > 0 && j > 0 && i < divisions[0] && j < divisions[1])
        place += Eigen::Vector2d(shift(generator), shift(generator));
      place = origin + place.cwiseQuotient(Eigen::Vector2d(divisions[0], divisions[1])).cwiseProduct(lengths);
      corners[{2 * i, 2 * j}] = Vector3(place.x(), place.y(), 0);
    }

  mesh::Mesh mesh;
  mesh.section = section;
  std::map<GridPoint, std::int64_t> numbers;
  const auto number = [&](const GridPoint& at, const Vector3& position) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<std::int64_t>(mesh.nodes.size()));
    if (is_new) mesh.nodes.push_back(position);
    return found->second;
  };
  mesh::CellBlock cells{type, {}}, edges{mesh::order(type) == 1 ? CellType::line2 : CellType::line3, {}};
  std::map<std::string, std::vector<mesh::CellRef>> sides;
  const auto add_cell = [&](const std::vector<GridPoint>& grid) {
    std::vector<GridPoint> all = grid;
    std::vector<Vector3> positions;
    for (const GridPoint& at : grid) positions.push_back(corners.at(at));
    const auto add_middle = [&](const std::vector<std::size_t>& of) {
      GridPoint sum{};
      Vector3 mean = Vector3::Zero();
      for (const std::size_t k : of) {
        for (std::size_t c = 0; c < 2; ++c) sum[c] += grid[k][c];
        mean += positions[k] / static_cast<double>(of.size());
      }
      all.push_back({sum[0] / static_cast<int>(of.size()), sum[1] / static_cast<int>(of.size())});
      positions.push_back(mean);
    };
    if (mesh::order(type) == 2)
      for (const auto& [a, b] : mesh::cell_edges(type))
        add_middle({static_cast<std::size_t>(a), static_cast<std::size_t>(b)});
    if (type == CellType::quad9) add_middle({0, 1, 2, 3});
    std::vector<std::int64_t> nodes;
    for (std::size_t k = 0; k < all.size(); ++k) nodes.push_back(number(all[k], positions[k]));
    cells.connectivity.insert(cells.connectivity.end(), nodes.begin(), nodes.end());
    for (const mesh::LocalFace& edge : mesh::cell_faces(type)) {
      const GridPoint a = all[edge.nodes[0]], b = all[edge.nodes[1]];
      for (std::size_t c = 0; c < 2; ++c)
        if (a[c] == b[c] && (a[c] == 0 || a[c] == 2 * divisions[c])) {
          sides[std::string(1, "xy"[c]) + (a[c] == 0 ? '0' : '1')].push_back({1, edges.size()});
          for (const int local : edge.nodes) edges.connectivity.push_back(nodes[local]);
          break;
        }
    }
  };
  for (int j = 0; j < 2 * divisions[1]; j += 2)
    for (int i = 0; i < 2 * divisions[0]; i += 2) {
      const GridPoint a{i, j}, b{i + 2, j}, c{i + 2, j + 2}, d{i, j + 2};
      if (mesh::n_corners(type) == 4) {
        add_cell({a, b, c, d});
      } else {
        add_cell({a, b, c});
        add_cell({a, c, d});
      }
    }
  mesh::Group all{"section", 2, {}};
  for (std::size_t cell = 0; cell < cells.size(); ++cell) all.cells.push_back({0, cell});
  mesh.groups["section"] = all;
  mesh.blocks.push_back(std::move(cells));
  mesh.blocks.push_back(std::move(edges));
  for (auto& [name, refs] : sides) mesh.groups[name] = {name, 1, std::move(refs)};
  if (section.has_axial_node()) {
    mesh.axial_node = static_cast<std::int64_t>(mesh.nodes.size());
    mesh.nodes.emplace_back(origin.x() + lengths.x() / 2, origin.y() + lengths.y() / 2, 0);
  }
  return mesh;
}

}  // namespace creepcontact::test
