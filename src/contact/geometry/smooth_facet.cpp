#include "smooth_facet.hpp"

namespace creepcontact::contact {
namespace {

/// Middle of the smooth curve between two points with normals there.
Vector3 middle_of_arc(const Vector3& x0, const Vector3& n0, const Vector3& x1, const Vector3& n1) {
  const Vector3 chord = x1 - x0;
  Vector3 middle = 0.5 * (x0 + x1);
  const Vector3 normal = 0.5 * (n0 + n1);
  // Both are chord * sin(half the angle of the arc) on a circle; their harmonic mean is none where one is.
  const double turn0 = -n0.dot(chord), turn1 = n1.dot(chord);
  const double length = normal.norm();
  if (turn0 * turn1 <= 0 || length == 0) return middle;
  const double turn = 2 * turn0 * turn1 / (turn0 + turn1);
  return middle + (0.5 * turn / (1 + length) / length) * normal;  // chord/2 tan(a/2) = chord/2 sin(a)/(1 + cos(a))
}

}  // namespace

Facet smooth_facet(const Facet& facet, const std::vector<Vector3>& normals) {
  const int n = facet.n_corners();
  if (facet.n_nodes() > n) return facet;
  const auto middle = [&](int i, int j) {
    return middle_of_arc(facet.node_position(i), normals[i], facet.node_position(j), normals[j]);
  };
  Facet::Coordinates x(n == 3 ? 6 : 9, 3);
  for (int i = 0; i < n; ++i) {
    x.row(i) = facet.node_position(i).transpose();
    x.row(n + i) = middle(i, (i + 1) % n).transpose();
  }
  if (n == 4) {
    // The serendipity value and the mean of the diagonals' middles err by opposite amounts on any quadratic surface.
    const Vector3 serendipity = 0.5 * x.middleRows(4, 4).colwise().sum() - 0.25 * x.topRows(4).colwise().sum();
    const Vector3 diagonals = 0.5 * (middle(0, 2) + middle(1, 3));
    x.row(8) = 0.5 * (serendipity + diagonals).transpose();
  }
  return {n == 3 ? mesh::CellType::tri6 : mesh::CellType::quad9, std::move(x)};
}

}  // namespace creepcontact::contact
