#include "contact_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace creepcontact::model {
namespace {

constexpr double along = 0.8;   // square of the share of a direction that a support holds: it is held
constexpr double beyond = 0.3;  // of the element at the edge: where the other surface is looked for
constexpr double opposite = 2;  // sizes of the element at the edge: distance of the other surface there
constexpr int enough = 2;       // rows: of surfaces with more, the edges need not be known

/// Corners of a face in turn; in sections the two ends of an edge.
std::vector<std::int64_t> corners(const mesh::Face& face) {
  return {face.nodes.begin(), face.nodes.begin() + mesh::n_corners(face.type)};
}

/// A border of a surface: an edge that one face alone has, in sections a node.
struct Border {
  std::vector<std::int64_t> nodes;
  Vector3 middle, outward;  ///< the unit vector lies in the surface, across the border
  Vector3 normal;           ///< of the surface
  double size = 0;          ///< of the element, across the border
};

Vector3 mean(const std::vector<Vector3>& positions, const std::vector<std::int64_t>& nodes) {
  Vector3 sum = Vector3::Zero();
  for (const std::int64_t node : nodes) sum += positions[node];
  return sum / static_cast<double>(nodes.size());
}

std::vector<Border> borders(const mesh::Mesh& mesh, const std::vector<mesh::Face>& faces) {
  const bool is_section = mesh.section.dimension() == 2;
  std::map<std::vector<std::int64_t>, std::vector<const mesh::Face*>> sides;
  for (const mesh::Face& face : faces) {
    const std::vector<std::int64_t> own = corners(face);
    for (std::size_t i = 0; i < own.size(); ++i) {
      std::vector<std::int64_t> side{own[i]};
      if (!is_section) side.push_back(own[(i + 1) % own.size()]);
      std::ranges::sort(side);
      sides[side].push_back(&face);
    }
  }
  std::vector<Border> result;
  for (const auto& [side, of] : sides) {
    if (of.size() != 1) continue;
    const std::vector<std::int64_t> own = corners(*of.front());
    Border border{.nodes = side, .middle = mean(mesh.nodes, side), .outward = {}, .normal = {}};
    Vector3 out = border.middle - mean(mesh.nodes, own);
    if (is_section) {
      border.normal = out.cross(Vector3::UnitZ()).normalized();
    } else {
      const Vector3 tangent = (mesh.nodes[side[1]] - mesh.nodes[side[0]]).normalized();
      out -= out.dot(tangent) * tangent;
      border.normal = out.cross(tangent).normalized();
    }
    border.outward = out.normalized();
    for (const std::int64_t node : own)
      border.size = std::max(border.size, (border.middle - mesh.nodes[node]).dot(border.outward));
    result.push_back(std::move(border));
  }
  return result;
}

/// True if the surface goes on beyond the border in what is not modelled: symmetry, or the next sector.
/// @param of_sector  nodes at the faces of a sector
bool continues(const Border& border, const mechanics::Constraints& constraints,
               const std::set<std::int64_t>& of_sector) {
  return std::ranges::all_of(border.nodes, [&](std::int64_t node) {
    if (of_sector.contains(node)) return true;
    const Matrix3 frame = constraints.frame(node);
    double held = 0;
    for (int k = 0; k < constraints.n_held(node); ++k) held += std::pow(frame.col(k).dot(border.outward), 2);
    return held > along;
  });
}

/// True if a face lies opposite a position, seen along the normal.
bool is_opposite(const mesh::Mesh& mesh, const mesh::Face& face, const Vector3& at, const Border& border) {
  const Vector3 across = border.normal.cross(border.outward);
  std::vector<Eigen::Vector2d> polygon;
  double least = std::numeric_limits<double>::infinity();
  for (const std::int64_t node : corners(face)) {
    const Vector3 arm = mesh.nodes[node] - at;
    least = std::min(least, std::abs(arm.dot(border.normal)));
    polygon.emplace_back(arm.dot(border.outward), arm.dot(across));
  }
  if (least > opposite * border.size) return false;
  if (polygon.size() == 2) return polygon[0].x() * polygon[1].x() <= 0;
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[j];
    if ((a.y() > 0) == (b.y() > 0)) continue;
    if (a.x() + (b.x() - a.x()) * (0 - a.y()) / (b.y() - a.y()) > 0) inside = !inside;
  }
  return inside;
}

/// The largest number of rows that nodes are away from these, which are the first row.
int rows_to_the_middle(const std::vector<mesh::Face>& faces, const std::vector<Border>& from) {
  std::map<std::int64_t, std::set<std::int64_t>> around;
  for (const mesh::Face& face : faces)
    for (const std::int64_t a : corners(face))
      for (const std::int64_t b : corners(face)) around[a].insert(b);
  std::map<std::int64_t, int> row;
  std::vector<std::int64_t> front;
  for (const Border& border : from)
    for (const std::int64_t node : border.nodes)
      if (row.emplace(node, 1).second) front.push_back(node);
  int last = 0;
  for (std::size_t i = 0; i < front.size(); ++i) {  // NOLINT(modernize-loop-convert): it grows within
    last = row[front[i]];
    for (const std::int64_t node : around[front[i]])
      if (row.emplace(node, last + 1).second) front.push_back(node);
  }
  return last;
}

}  // namespace

std::optional<int> rows_between_edges(const mechanics::Body& body, const std::string& surface,
                                      const mechanics::Body& other, const std::string& other_surface) {
  const std::vector<mesh::Face> faces = mesh::boundary_faces(body.mesh(), surface);
  std::vector<Border> edges = borders(body.mesh(), faces);
  std::set<std::int64_t> of_sector;
  for (const mechanics::NodeLinks::Turned& link : body.constraints().links().turned)
    for (const std::int64_t node : {link.node, link.of}) of_sector.insert(node);
  std::erase_if(edges, [&](const Border& border) { return continues(border, body.constraints(), of_sector); });
  if (const int rows = rows_to_the_middle(faces, edges); rows == 0 || rows > enough)
    return rows == 0 ? std::nullopt : std::optional(rows);
  const std::vector<mesh::Face> opposite_faces = mesh::boundary_faces(other.mesh(), other_surface);
  std::erase_if(edges, [&](const Border& border) {
    const Vector3 at = border.middle + beyond * border.size * border.outward;
    return std::ranges::none_of(opposite_faces,
                                [&](const mesh::Face& face) { return is_opposite(other.mesh(), face, at, border); });
  });
  const int rows = rows_to_the_middle(faces, edges);
  return rows == 0 ? std::nullopt : std::optional(rows);
}

}  // namespace creepcontact::model
