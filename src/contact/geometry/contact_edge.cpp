#include "creepcontact/contact/geometry/contact_edge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/geometry/facet.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::contact {
namespace {

constexpr int rows_fitted = 5;  // outwards, ...
// In regular meshes rows lie at multiples of half an element: those on a limit are outside, whatever the round-off.
constexpr double inside = 1 - 1e-9;
constexpr double max_fit_distance = 4.5 * inside;  // ... in elements: fewer where these grow
constexpr double half_width = 1.5 * inside;        // in elements: of the strip across the edge whose rows are fitted
constexpr double punch_overhang =
    0.1;  // in elements: how far the closed rows, as a punch, reach beyond the last of them
constexpr double max_lateral_distance = 2;   // in elements: over which the end of the punch is averaged along the edge
constexpr double max_unevenness = 1.6;       // in elements: how unevenly it may end
constexpr double min_to_punch = 0.1;         // in elements: nearer rows tell nothing
constexpr double weight_next = 0.1;          // of rows next to closed ones
constexpr double weight_small = 0.1;         // of unknowns being small, where the rows do not tell them
constexpr double max_distance_beyond = 1.5;  // in elements beyond the closed row: further out that would be open
constexpr double edge_step = 2;  // in elements: where the gap, to the power of 2/3, is zero further inside, it jumps

}  // namespace

struct ContactEdge::State {
  std::vector<char> closed;
  Eigen::VectorXd gap;  // mean

  bool is_closed(int row) const { return closed[row] != 0; }
};

/// The row itself first.
std::vector<int> ContactEdge::open_around(int row, int steps, const State& state) const {
  std::vector<int> found{row};
  std::size_t begin = 0;
  for (int i = 0; i < steps; ++i) {
    const std::size_t end = found.size();
    for (; begin < end; ++begin)
      for (const int other : grid_.around(found[begin]))
        if (!state.is_closed(other) && std::ranges::find(found, other) == found.end()) found.push_back(other);
  }
  return found;
}

/// Least squares: gap^(2/3) as a plane, bent across its slope since lines of equal gap are curved.
ContactEdge::Edge ContactEdge::edge_near(int row, const State& state) const {
  Edge edge{Vector3::Zero()};
  for (const int other : grid_.around(row)) {
    const Vector3 out = grid_.position(row) - grid_.position(other);
    if (state.is_closed(other)) edge.outward += out / out.squaredNorm();
  }
  edge.outward.normalize();
  const auto set_length = [&] {
    edge.length = 0;
    for (const int other : grid_.around(row))
      if (state.is_closed(other))
        edge.length = std::max(edge.length, edge.outward.dot(grid_.position(row) - grid_.position(other)));
  };
  set_length();

  const std::vector<int> near = open_around(row, 2, state);
  const Index n = near.size();
  const contact::Plane plane = contact::Plane::through(grid_.position(row), coupling_.nodes[row].normal);
  Eigen::MatrixX4d matrix = Eigen::MatrixX4d::Zero(n + 1, 4);
  Eigen::VectorXd roots = Eigen::VectorXd::Zero(n + 1);
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  Eigen::Vector4d fit;
  for (int pass = 0; pass < 2; ++pass) {
    for (Index k = 0; k < n; ++k) {
      const Eigen::Vector2d x = plane.project(grid_.position(near[k])) / edge.length;
      matrix.row(k) << 1, x.x(), x.y(), across.dot(x) * across.dot(x) / 2;
      roots[k] = std::cbrt(std::pow(std::max(0.0, state.gap[near[k]]), 2));
    }
    matrix(n, 3) = weight_small * std::max(1.0, matrix.col(3).head(n).maxCoeff());
    fit = linalg::least_squares(matrix, roots);
    const Eigen::Vector2d slope = fit.segment<2>(1);
    if (slope.norm() > 0) across = Eigen::Vector2d(-slope.y(), slope.x()).normalized();
  }
  const Vector3 slope = fit[1] * plane.axis1 + fit[2] * plane.axis2;
  const double size = slope.norm();
  edge.smooth = size > 0 && fit[0] < edge_step * size && slope.dot(edge.outward) > 0.3 * size;
  if (edge.smooth) {
    edge.outward = slope / size;
    edge.curvature = fit[3] / (size * edge.length);
    set_length();
  }
  return edge;
}

double ContactEdge::mean_to_punch(int row, const std::map<int, Edge>& edges) const {
  const Edge& own = edges.at(row);
  double sum = 0, weights = 0;
  for (const auto& [other, edge] : edges) {
    const Vector3 x = (grid_.position(other) - grid_.position(row)) / own.length;
    const double out = own.outward.dot(x), beside = (x - out * own.outward).norm();
    if (beside >= max_lateral_distance || std::abs(out) >= max_unevenness || !edge.smooth) continue;
    const double weight = 1 - beside / max_lateral_distance;
    sum += weight *
           ((1 - punch_overhang) * edge.length / own.length - out - own.curvature * own.length * beside * beside / 2);
    weights += weight;
  }
  return weights > 0 ? std::max(sum / weights, min_to_punch) : 1 - punch_overhang;
}

/// Distance of an open row next to a closed one, outwards from the edge, in edge lengths.
double ContactEdge::distance_to(int row, const Edge& edge, const State& state) const {
  const double to_punch = edge.to_punch;
  const Vector3 origin = grid_.position(row), outward = edge.outward / edge.length;
  const double bend = edge.curvature * edge.length / 2, square = 1 / (edge.length * edge.length);
  const auto from_punch = [&](const Vector3& position) {
    const Vector3 x = position - origin;
    const double out = outward.dot(x);
    return to_punch + out + bend * (x.squaredNorm() * square - out * out);
  };
  std::vector<int> fitted;
  for (const int other : open_around(row, rows_fitted - 1, state)) {
    const Vector3 x = grid_.position(other) - grid_.position(row);
    const double out = edge.outward.dot(x);
    // Around a hole of the contact the normals of the edge meet.
    if ((x - out * edge.outward).norm() < half_width * edge.length &&
        from_punch(grid_.position(other)) > 0.9 * std::min(to_punch, 1 - punch_overhang) &&
        1 + edge.curvature * out > 0.5 && out < max_fit_distance * edge.length)
      fitted.push_back(other);
  }
  const Index n = fitted.size();
  Eigen::MatrixX3d matrix = Eigen::MatrixX3d::Zero(n + 1, 3);
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(n + 1);
  for (Index k = 0; k < n; ++k) {
    const int other = fitted[k];
    double first = 0, second = 0, third = 0;  // of d^(3/2), d^(1/2) and d^(5/2)
    for (contact::RowMatrix::InnerIterator it(coupling_.gap_weights, grid_.own(other)); it; ++it) {
      const double d = from_punch(grid_.image_near(other, coupling_.gap_points[it.col()]));
      if (!(d > 0)) continue;
      const double root = it.value() * std::sqrt(d);
      first += root * d;
      second += root;
      third += root * d * d;
    }
    matrix.row(k) << first, second, third;
    matrix.row(k) /= coupling_.area[grid_.own(other)];
    const bool next = std::ranges::any_of(grid_.around(other), [&](int r) { return state.is_closed(r); });
    const double d = from_punch(grid_.position(other)), weight = (next ? weight_next : 1) / (d * std::sqrt(d));
    matrix.row(k) *= weight;
    gaps[k] = weight * state.gap[other];
  }
  matrix(n, 2) = weight_small;
  const Eigen::Vector3d fit = linalg::least_squares(matrix, gaps);
  if (!(fit[0] > 0)) return 0.5 * edge.length;
  return std::clamp(to_punch + fit[1] / (1.5 * fit[0]), 0.0, max_distance_beyond) * edge.length;
}

/// Along the normals of the edge, row by row: the edge may lie beyond the first closed row.
/// @param known  rows whose distance is known, with the outward normals of the edge
void ContactEdge::continue_inwards(std::vector<std::pair<int, Vector3>> known, Eigen::VectorXd& distance) const {
  struct Sum {
    double weight = 0, distance = 0;
    Vector3 outward = Vector3::Zero();
  };
  const double far = far_distance();
  for (int ring = 0; ring < 2; ++ring) {
    std::map<int, Sum> sums;
    for (const auto& [row, outward] : known)
      for (const int other : grid_.around(row)) {
        if (distance[other] < far) continue;
        const Vector3 inwards = grid_.position(row) - grid_.position(other);
        const double depth = outward.dot(inwards);
        if (!(depth > 0)) continue;
        const double weight = depth * depth / (inwards.squaredNorm() * inwards.squaredNorm());
        Sum& sum = sums[other];
        sum.weight += weight;
        sum.outward += weight * outward;
        sum.distance += weight * (distance[row] + depth);
      }
    known.clear();
    for (const auto& [row, sum] : sums) {
      distance[row] = sum.distance / sum.weight;
      known.emplace_back(row, sum.outward.normalized());
    }
  }
}

double ContactEdge::far_distance() const {
  Eigen::AlignedBox3d box;
  for (const Vector3& position : grid_.positions) box.extend(position);
  return box.diagonal().norm();
}

Eigen::VectorXd ContactEdge::distances(const std::vector<char>& closed, const Eigen::VectorXd& gap) const {
  const double far = far_distance();
  const Eigen::Map<const Eigen::VectorXd> area(coupling_.area.data(), gap.size());
  State state{std::vector<char>(grid_.positions.size()), grid_.of_all(gap.cwiseQuotient(area))};
  Eigen::VectorXd distance(state.gap.size());
  for (int row = 0; row < distance.size(); ++row) {
    state.closed[row] = closed[grid_.own(row)];
    distance[row] = state.is_closed(row) ? far : -far;
  }
  std::vector<std::pair<int, Vector3>> known;
  std::map<int, Edge> edges;
  for (int row = 0; row < distance.size(); ++row) {
    if (state.is_closed(row) ||
        std::ranges::none_of(grid_.around(row), [&](int other) { return state.is_closed(other); }))
      continue;
    edges.emplace(row, edge_near(row, state));
  }
  for (auto& [row, edge] : edges) edge.to_punch = mean_to_punch(row, edges);
  for (const auto& [row, edge] : edges) {
    distance[row] = -(edge.smooth ? distance_to(row, edge, state) : 0.5 * edge.length);
    known.emplace_back(row, edge.outward);
  }
  continue_inwards(std::move(known), distance);
  return distance;
}

}  // namespace creepcontact::contact
