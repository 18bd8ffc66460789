#include "revolved_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include "creepcontact/mesh/cell_faces.hpp"

namespace creepcontact::results {
namespace {

using mesh::CellType;

CellType revolved(CellType type) {
  switch (type) {
    case CellType::tri3:
      return CellType::wedge6;
    case CellType::tri6:
      return CellType::wedge15;
    case CellType::quad4:
      return CellType::hex8;
    case CellType::quad8:
      return CellType::hex20;
    case CellType::quad9:
      return CellType::hex27;
    default:
      throw std::invalid_argument("no surface cell");
  }
}

/// The origin of a node of the solid cell: a node of the section's cell, and 0, 1 or 2 half segments.
struct Origin {
  int node = 0;
  int layer = 0;
};

std::vector<Origin> origins(CellType type) {
  const CellType solid = revolved(type);
  const int n = mesh::n_corners(type);
  std::vector<Origin> result;
  result.reserve(mesh::n_nodes(solid));
  for (int corner = 0; corner < 2 * n; ++corner) result.push_back({corner % n, corner < n ? 0 : 2});
  if (mesh::order(type) == 1) return result;
  const auto& edges = mesh::cell_edges(type);
  const auto between = [&](int a, int b) {
    const auto joins = [&](const std::array<int, 2>& edge) {
      return std::minmax(edge[0], edge[1]) == std::minmax(a, b);
    };
    return n + static_cast<int>(std::ranges::find_if(edges, joins) - edges.begin());
  };
  for (const auto& [i, j] : mesh::cell_edges(solid)) {
    const Origin a = result[i], b = result[j];
    result.push_back({a.node == b.node ? a.node : between(a.node, b.node), (a.layer + b.layer) / 2});
  }
  if (type != CellType::quad9) return result;
  constexpr int centre = 8;
  for (const mesh::LocalFace& face : mesh::cell_faces(solid)) {
    std::set<int> corners;
    int layers = 0;
    for (int i = 0; i < 4; ++i) {
      corners.insert(result[face.nodes[i]].node);
      layers += result[face.nodes[i]].layer;
    }
    result.push_back({corners.size() == 4 ? centre : between(*corners.begin(), *corners.rbegin()), layers / 4});
  }
  result.push_back({centre, 1});
  return result;
}

}  // namespace

RevolvedSection::RevolvedSection(const io::FieldMesh& section, int segments) : section_(section), segments_(segments) {}

/// The rotation to the direction of a layer: the section's x becomes radial, its z the hoop direction.
Matrix3 RevolvedSection::turn(double layer) const {
  const double angle = 2 * std::numbers::pi * layer / n_layers(), c = std::cos(angle), s = std::sin(angle);
  return (Matrix3() << c, 0, -s, 0, 1, 0, s, 0, c).finished();
}

io::FieldMesh RevolvedSection::mesh() const {
  io::FieldMesh result;
  result.texts = section_.texts;
  for (int layer = 0; layer < n_layers(); ++layer)
    for (const Vector3& x : section_.points) result.points.emplace_back(turn(layer) * x);
  const auto n_points = static_cast<std::int64_t>(section_.points.size());
  for (int segment = 0; segment < segments_; ++segment)
    for (const mesh::CellBlock& block : section_.blocks) {
      mesh::CellBlock cells{revolved(block.type), {}};
      const std::vector<Origin> from = origins(block.type);
      for (std::size_t c = 0; c < block.size(); ++c)
        for (const Origin& origin : from)
          cells.connectivity.push_back((2 * segment + origin.layer) % n_layers() * n_points +
                                       block.cell(c)[origin.node]);
      result.blocks.push_back(std::move(cells));
    }
  return result;
}

io::FieldData RevolvedSection::repeated(const io::FieldData& section, const std::vector<double>& layers) const {
  io::FieldData result = section;
  result.values.clear();
  const std::size_t width = section.components, n = section.values.size() / width;
  const bool turns = section.component_names.empty();
  for (const double layer : layers) {
    const Matrix3 turn = this->turn(layer);
    for (std::size_t i = 0; i < n; ++i) {
      const double* v = &section.values[i * width];
      if (turns && width == 3) {
        const Vector3 turned = turn * Vector3(v[0], v[1], v[2]);
        result.values.insert(result.values.end(), turned.begin(), turned.end());
      } else if (turns && width == 6) {
        Matrix3 tensor;
        tensor << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
        const Matrix3 t = turn * tensor * turn.transpose();
        result.values.insert(result.values.end(), {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(2, 0)});
      } else {
        result.values.insert(result.values.end(), v, v + width);
      }
    }
  }
  return result;
}

std::vector<io::FieldData> RevolvedSection::repeated(const std::vector<io::FieldData>& section,
                                                     const std::vector<double>& layers) const {
  std::vector<io::FieldData> result;
  result.reserve(section.size());
  for (const io::FieldData& field : section) result.push_back(repeated(field, layers));
  return result;
}

std::vector<io::FieldData> RevolvedSection::at_points(const std::vector<io::FieldData>& section) const {
  std::vector<double> layers(n_layers());
  std::iota(layers.begin(), layers.end(), 0.0);
  return repeated(section, layers);
}

std::vector<io::FieldData> RevolvedSection::at_cells(const std::vector<io::FieldData>& section) const {
  std::vector<double> layers(segments_);
  for (int segment = 0; segment < segments_; ++segment) layers[segment] = 2 * segment + 1;
  return repeated(section, layers);
}

}  // namespace creepcontact::results
