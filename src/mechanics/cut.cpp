#include "creepcontact/mechanics/cut.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/fem/cut_rule.hpp"
#include "creepcontact/fem/tangents.hpp"

namespace creepcontact::mechanics {
namespace {

constexpr double in_plane = 1e-7;  // of the size of the body: coordinates are given and meshed with rounding

}  // namespace

Cut::Cut(const mesh::Mesh& mesh, const Vector3& origin, const Vector3& normal)
    : mesh_(mesh), normal_(normal.normalized()), levels_(mesh.nodes.size(), 0.0) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < mesh.n_cell_nodes(); ++i) box.extend(mesh.nodes[i]);
  const double tolerance = in_plane * box.diagonal().norm();
  for (std::size_t i = 0; i < mesh.n_cell_nodes(); ++i) {
    const double distance = normal_.dot(mesh.nodes[i] - origin);
    levels_[i] = std::abs(distance) <= tolerance ? 0 : distance;
  }
  const std::span<const double> levels(levels_.data(), mesh.n_cell_nodes());
  const auto [least, most] = std::ranges::minmax_element(levels);
  ends_beyond_ = *most == 0;
  ends_behind_ = *least == 0;
  // The body may end there at a face; an edge or a corner carries nothing.
  const auto n_touching = std::ranges::count(levels, 0.0);
  const bool only_touches = ends_body() && n_touching < mesh.section.dimension();
  if (*most >= 0 && *least <= 0 && !only_touches) return;
  const Vector3 &low = box.min(), &high = box.max();
  throw ModelError(fmt::format(
      "section: the plane through ({:.6g}, {:.6g}, {:.6g}) with the normal ({:.6g}, {:.6g}, {:.6g}) misses the body, "
      "which lies within ({:.6g}, {:.6g}, {:.6g}) and ({:.6g}, {:.6g}, {:.6g}); choose an 'origin' inside",
      origin.x(), origin.y(), origin.z(), normal.x(), normal.y(), normal.z(), low.x(), low.y(), low.z(), high.x(),
      high.y(), high.z()));
}

Cut::Side Cut::side(std::span<const std::int64_t> nodes) const {
  const auto any = [&](auto condition) { return std::ranges::any_of(nodes, condition); };
  const bool beyond = any([&](std::int64_t node) { return level(node) > 0; });
  const bool behind = any([&](std::int64_t node) { return level(node) < 0; });
  if (beyond && behind) return Side::both;
  return beyond ? Side::beyond : Side::behind;
}

Cut::Side Cut::side(const mesh::Face& face) const {
  const bool lies_in_plane = std::ranges::all_of(face.nodes, [&](std::int64_t node) { return level(node) == 0; });
  if (!lies_in_plane) return side(std::span(face.nodes));
  if (ends_body()) return ends_beyond_ ? Side::beyond : Side::behind;
  const fem::ReferenceElement& element = fem::reference_element(face.type);
  Eigen::Matrix3Xd x(3, element.n_nodes());
  for (int i = 0; i < element.n_nodes(); ++i) x.col(i) = mesh_.nodes[face.nodes[i]];
  Eigen::MatrixX3d gradient(element.n_nodes(), 3);
  element.gradient(element.rule().points.row(0).transpose(), gradient);
  // Outward: a cell behind the plane has its outward normal along that of the plane.
  return normal_.dot(fem::area_vector(element, x, gradient)) > 0 ? Side::behind : Side::beyond;
}

fem::QuadratureRule Cut::rule_beyond(mesh::CellType type, std::span<const std::int64_t> nodes) const {
  Eigen::VectorXd levels(std::ssize(nodes));
  for (Index i = 0; i < levels.size(); ++i) levels[i] = level(nodes[i]);
  return fem::positive_part_rule(fem::reference_element(type), levels);
}

double Cut::node_share(std::int64_t node) const {
  if (level(node) != 0) return level(node) > 0 ? 1 : 0;
  if (ends_body()) return ends_beyond_ ? 1 : 0;
  return 0.5;
}

Cut::FaceArea Cut::area(const mesh::Face& face) const {
  const fem::ReferenceElement& element = fem::reference_element(face.type);
  Eigen::Matrix3Xd x(3, element.n_nodes());
  for (int i = 0; i < element.n_nodes(); ++i) x.col(i) = mesh_.nodes[face.nodes[i]];
  Eigen::VectorXd shape(element.n_nodes());
  Eigen::MatrixX3d gradient(element.n_nodes(), 3);
  const auto integral = [&](const fem::QuadratureRule& rule) {
    double sum = 0;
    for (Index q = 0; q < rule.size(); ++q) {
      const Vector3 xi = rule.points.row(q).transpose();
      element.shape(xi, shape);
      element.gradient(xi, gradient);
      sum += rule.weights[q] * mesh_.section.depth(x * shape) * fem::area_vector(element, x, gradient).norm();
    }
    return sum;
  };
  const double whole = integral(element.rule());
  switch (side(face)) {
    case Side::beyond:
      return {whole, whole};
    case Side::behind:
      return {0, whole};
    default:
      return {std::min(whole, integral(rule_beyond(face.type, face.nodes))), whole};
  }
}

PointForces::PointForces(std::vector<FieldPoint> points, Function f, Function factor, int power)
    : points_(std::move(points)), f_(std::move(f)), factor_(std::move(factor)), power_(power) {}

void PointForces::add(double t, const Vector3& about, Vector3& force, Vector3& moment) const {
  const double scale = std::pow(factor_({.t = t}), power_);
  if (scale == 0) return;
  for (const FieldPoint& point : points_) {
    const Vector3& x = point.position;
    const Vector3 own = scale * f_({.x = x.x(), .y = x.y(), .z = x.z(), .t = t}) * point.field;
    force += own;
    moment += (x - about).cross(own);
  }
}

}  // namespace creepcontact::mechanics
