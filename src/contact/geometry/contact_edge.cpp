#include "creepcontact/contact/geometry/contact_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "creepcontact/contact/geometry/facet.hpp"

namespace creepcontact::contact {
namespace {

constexpr int rings = 3;    // of open rows around the contact that the fit sees
constexpr int passes = 12;  // of the fit; each reduces its error to about a third

// Elements bend less sharply at the edge than the surface does, so that a node closes when the edge is still a third of
// an element away. What that does to the fitted distance, in elements: fitted to elastic and viscoelastic contacts
// whose edge is known (docs/results.md; quadratic hexahedra).
constexpr double at_all = 0.015;
constexpr double near_end = 0.6, near_rate = 0.35;
constexpr double far_begin = 1.03, far_rate = 0.45;
constexpr double farthest = 1.36;  // beyond it the row inside would be open
constexpr double step = 1.6;       // fitted distances beyond it: the gap begins with a step

double calibrated(double fitted) {
  if (!(fitted <= step)) return 0.5;  // no smooth opening: the edge is halfway
  const double distance =
      fitted + near_rate * std::max(0.0, near_end - fitted) + far_rate * std::max(0.0, fitted - far_begin);
  return std::min(distance - at_all, farthest);
}

constexpr double weight_of_no_curvature = 0.1;
constexpr double bend_of_rounding = 0.02;  // of the slope, over an element: what elements make of a straight line

double to_two_thirds(double x) {
  return x > 0 ? std::cbrt(x * x) : 0.0;
}

/// A row from which the distances of its neighbours inside are continued.
struct Known {
  Vector3 outward;  // normal of the edge
  double distance;
};

}  // namespace

std::vector<ContactEdge::OpenRow> ContactEdge::open_rows(const std::vector<char>& closed,
                                                         const Eigen::VectorXd& gap) const {
  const auto is_closed = [&](int row) { return closed[static_cast<std::size_t>(row)] != 0; };
  std::vector<int> index(grid_.places.size(), -1);
  std::vector<OpenRow> open;
  const auto add = [&](int row, int ring) {
    if (is_closed(row) || index[static_cast<std::size_t>(row)] >= 0) return;
    index[static_cast<std::size_t>(row)] = static_cast<int>(open.size());
    OpenRow made{row, ring, {}, 0, 0, Vector3::Zero()};
    made.measured = to_two_thirds(gap[row] / coupling_.area[static_cast<std::size_t>(row)]);
    made.root = made.measured;
    open.push_back(std::move(made));
  };
  for (int row = 0; row < static_cast<int>(grid_.places.size()); ++row)
    if (std::ranges::any_of(grid_.around(row), is_closed)) add(row, 1);
  for (std::size_t i = 0; i < open.size() && open[i].ring < rings; ++i)
    for (const int other : std::vector<int>(grid_.around(open[i].row))) add(other, open[i].ring + 1);
  for (OpenRow& row : open) {
    std::set<int> near;
    for (const int first : grid_.around(row.row)) {
      if (is_closed(first)) continue;
      near.insert(index[static_cast<std::size_t>(first)]);
      for (const int second : grid_.around(first)) near.insert(index[static_cast<std::size_t>(second)]);
    }
    near.erase(index[static_cast<std::size_t>(row.row)]);
    near.erase(-1);
    row.near.assign(near.begin(), near.end());
  }
  return open;
}

/// Least squares through the row's own value; across the slope a parabola, since lines of equal gap are curved.
void ContactEdge::fit_slope(OpenRow& open, const std::vector<OpenRow>& all) const {
  const Vector3 normal = coupling_.nodes[static_cast<std::size_t>(open.row)].normal;
  const contact::Plane plane = contact::Plane::through(grid_.place(open.row), normal);
  const Eigen::Vector2d before = plane.project_direction(open.slope);
  const Eigen::Vector2d across =
      before.norm() > 0 ? Eigen::Vector2d(-before.y(), before.x()).normalized() : Eigen::Vector2d::Zero();
  const auto n = static_cast<Eigen::Index>(open.near.size());
  if (n == 0) return;
  Eigen::MatrixX3d matrix(n + 1, 3);
  Eigen::VectorXd values(n + 1);
  double shortest = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < n; ++k) {
    const OpenRow& other = all[static_cast<std::size_t>(open.near[static_cast<std::size_t>(k)])];
    const Eigen::Vector2d x = plane.project(grid_.place(other.row));
    const double length = x.norm();
    shortest = std::min(shortest, length);
    matrix.row(k) << x.x() / length, x.y() / length, across.dot(x) * across.dot(x) / (2 * length);
    values[k] = (other.root - open.root) / length;
  }
  matrix.col(2) /= shortest;
  // Rows on one side alone, as in a slice, do not tell a curvature from a slope.
  matrix.row(n) << 0, 0, weight_of_no_curvature;
  values[n] = 0;
  const Eigen::Vector3d fit = matrix.completeOrthogonalDecomposition().solve(values);
  open.slope = fit.x() * plane.axis1 + fit.y() * plane.axis2;
}

/// Least squares with the slope's size left open, from the rows that lie outwards rather than sidewards.
void ContactEdge::fit_bend(OpenRow& open, const std::vector<OpenRow>& all) const {
  const double slope = open.slope.norm();
  if (!(slope > 0)) return;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const int index : open.near) {
    const OpenRow& other = all[static_cast<std::size_t>(index)];
    const Vector3 x = grid_.place(other.row) - grid_.place(open.row);
    const double out = open.slope.dot(x) / slope;
    if (out < 0.9 * x.norm()) continue;
    const Eigen::Vector2d columns(1, out / 2);
    normal += columns * columns.transpose();
    right += (other.root - open.root) / out * columns;
  }
  if (!(normal.determinant() > 1e-6 * normal(0, 0) * normal(1, 1))) return;
  open.bend = normal.inverse().row(1).dot(right);
  open.lever = normal(0, 1) / normal(0, 0);
}

/// The weighted mean of the gap that root and slope give, to the power of 2/3.
double ContactEdge::weighted_root(const OpenRow& open) const {
  double sum = 0;
  for (contact::RowMatrix::InnerIterator it(coupling_.gap_weights, open.row); it; ++it) {
    const Vector3& x = coupling_.gap_points[static_cast<std::size_t>(it.col())];
    const double root = open.root + open.slope.dot(x - grid_.place(open.row));
    if (root > 0) sum += it.value() * root * std::sqrt(root);
  }
  sum /= coupling_.area[static_cast<std::size_t>(open.row)];
  return sum > 0 ? to_two_thirds(sum) : -to_two_thirds(-sum);
}

void ContactEdge::add_distances(const std::vector<OpenRow>& open, const std::vector<char>& closed,
                                Eigen::VectorXd& distance) const {
  const auto is_closed = [&](int row) { return closed[static_cast<std::size_t>(row)] != 0; };
  double mean_slope = 0;
  int n_slopes = 0;
  std::vector<std::pair<int, Known>> known;
  std::vector<const OpenRow*> first_ring;
  for (const OpenRow& row : open) {
    if (row.ring > 1) continue;
    first_ring.push_back(&row);
    if (row.slope.norm() > 0) mean_slope += row.slope.norm(), ++n_slopes;
  }
  if (n_slopes > 0) mean_slope /= n_slopes;

  for (const OpenRow* row : first_ring) {
    Vector3 outward = Vector3::Zero();
    for (const int other : grid_.around(row->row))
      if (is_closed(other))
        outward +=
            (grid_.place(row->row) - grid_.place(other)) / (grid_.place(row->row) - grid_.place(other)).squaredNorm();
    // A gap that does not grow away from the contact has no slope to follow.
    const bool grows = row->slope.dot(outward) > 0.3 * row->slope.norm() * outward.norm();
    outward = (grows ? row->slope : outward).normalized();
    double length = 0;  // of the elements across the edge
    for (const int other : grid_.around(row->row))
      if (is_closed(other)) length = std::max(length, outward.dot(grid_.place(row->row) - grid_.place(other)));
    const double slope = grows ? row->slope.norm() : mean_slope;
    double fitted = slope > 0 ? row->root / (slope * length) : std::numeric_limits<double>::infinity();
    if (grows && fitted <= step) {
      // Where elements grow quickly outwards, the rows reach to where the line is bent.
      const double bend = std::max(0.0, row->bend * length / slope - bend_of_rounding);
      fitted /= std::max(0.5, 1 - bend * row->lever / length);
      fitted *= 1 + bend * fitted / 2;
    }
    distance[row->row] = -calibrated(fitted) * length;
    known.push_back({row->row, {outward, distance[row->row]}});
  }

  // Inwards along the normals of the edge, row by row: the edge may lie beyond the first closed row.
  for (int ring = 0; ring < 2; ++ring) {
    std::map<int, std::pair<double, Known>> found;  // by row, with its weight
    for (const auto& [row, from] : known)
      for (const int other : grid_.around(row)) {
        if (distance[other] < far_distance()) continue;
        const Vector3 inwards = grid_.place(row) - grid_.place(other);
        const double depth = from.outward.dot(inwards);
        if (!(depth > 0)) continue;
        const double weight = depth * depth / (inwards.squaredNorm() * inwards.squaredNorm());
        auto& [sum, next] = found.try_emplace(other, 0.0, Known{Vector3::Zero(), 0.0}).first->second;
        sum += weight;
        next.outward += weight * from.outward;
        next.distance += weight * (from.distance + depth);
      }
    known.clear();
    for (auto& [row, weighed] : found) {
      auto& [sum, next] = weighed;
      next.distance /= sum;
      next.outward.normalize();
      distance[row] = next.distance;
      known.push_back({row, next});
    }
  }
}

double ContactEdge::far_distance() const {
  return std::sqrt(std::accumulate(coupling_.area.begin(), coupling_.area.end(), 0.0));
}

Eigen::VectorXd ContactEdge::distances(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const {
  const double far = far_distance();
  std::vector<char> closed(grid_.places.size());
  Eigen::VectorXd distance(pressure.size());
  for (Eigen::Index i = 0; i < pressure.size(); ++i) {
    closed[static_cast<std::size_t>(i)] = pressure[i] > 0 ? 1 : 0;
    distance[i] = pressure[i] > 0 ? far : -far;
  }
  std::vector<OpenRow> open = open_rows(closed, gap);
  for (int pass = 0; pass < passes; ++pass) {
    for (OpenRow& row : open) fit_slope(row, open);
    for (OpenRow& row : open) row.root += 0.7 * (row.measured - weighted_root(row));
  }
  for (OpenRow& row : open) {
    fit_slope(row, open);
    fit_bend(row, open);
  }
  add_distances(open, closed, distance);
  return distance;
}

}  // namespace creepcontact::contact
