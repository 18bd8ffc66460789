#include "contact_area.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "creepcontact/contact/facet.hpp"

namespace creepcontact::simulation {
namespace {

// A multiplier is a mean over its hat: a node on the edge of contact has this part of the squared pressure one element
// further inside. Rows with less lie outside, and only the end of their hat is under pressure.
constexpr double squared_pressure_at_edge = 0.07;

/// Rows of the multiplier nodes at each mesh node: one, or several at a crease.
std::unordered_map<std::int64_t, std::vector<int>> rows_of_nodes(const std::vector<contact::MultiplierNode>& nodes) {
  std::unordered_map<std::int64_t, std::vector<int>> rows;
  for (std::size_t i = 0; i < nodes.size(); ++i) rows[nodes[i].node].push_back(static_cast<int>(i));
  return rows;
}

/// A corner of a piece of a facet: where it is, how large the level and the facet's hats are there.
struct Corner {
  Vector3 place = Vector3::Zero();
  double level = 0;
  std::array<double, 4> hats{};
};

Corner between(const Corner& a, const Corner& b, double part) {
  Corner middle{a.place + part * (b.place - a.place), a.level + part * (b.level - a.level), {}};
  for (std::size_t i = 0; i < 4; ++i) middle.hats[i] = a.hats[i] + part * (b.hats[i] - a.hats[i]);
  return middle;
}

/// Integrals of the hats over a triangle.
std::array<double, 4> integral(const Corner& a, const Corner& b, const Corner& c) {
  const double area = 0.5 * (b.place - a.place).cross(c.place - a.place).norm();
  std::array<double, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = area * (a.hats[i] + b.hats[i] + c.hats[i]) / 3;
  return result;
}

/// The part of a triangle where the level is positive, at most four corners.
std::vector<Corner> positive_part(const std::array<Corner, 3>& triangle) {
  std::vector<Corner> part;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (a.level > 0) part.push_back(a);
    if ((a.level > 0) != (b.level > 0)) part.push_back(between(a, b, a.level / (a.level - b.level)));
  }
  return part;
}

}  // namespace

ContactArea::ContactArea(const contact::Pair& pair, const mesh::Mesh& slave) : area_(pair.coupling.area) {
  for (const contact::MultiplierNode& node : pair.coupling.nodes) {
    place_.push_back(slave.nodes[static_cast<std::size_t>(node.node)]);
    normal_.push_back(node.normal);
  }
  const auto rows = rows_of_nodes(pair.coupling.nodes);
  std::vector<std::set<int>> around(place_.size());
  for (const contact::Facet& face : contact::make_facets(slave, mesh::boundary_faces(slave, pair.slave_surface))) {
    Facet facet;
    const Vector3 normal = face.area_vector_at_centre();
    for (int corner = 0; corner < face.n_corners(); ++corner) {
      const auto found = rows.find(face.nodes()[static_cast<std::size_t>(corner)]);
      if (found == rows.end()) break;
      const auto less = [&](int a, int b) {
        return normal_[static_cast<std::size_t>(a)].dot(normal) < normal_[static_cast<std::size_t>(b)].dot(normal);
      };
      facet.rows[facet.n_corners++] = *std::max_element(found->second.begin(), found->second.end(), less);
    }
    if (facet.n_corners < static_cast<std::size_t>(face.n_corners())) continue;  // hardly covered by the other surface
    for (std::size_t i = 0; i < facet.n_corners; ++i)
      for (std::size_t j = 0; j < facet.n_corners; ++j)
        if (i != j) around[static_cast<std::size_t>(facet.rows[i])].insert(facet.rows[j]);
    facets_.push_back(facet);
  }
  for (const std::set<int>& rows_around : around) neighbours_.emplace_back(rows_around.begin(), rows_around.end());
}

bool ContactArea::carries(std::size_t row, const Eigen::VectorXd& pressure) const {
  const double own = pressure[static_cast<Eigen::Index>(row)];
  double largest = 0;
  bool at_edge = false;
  for (const int other : neighbours_[row]) {
    largest = std::max(largest, pressure[other]);
    at_edge = at_edge || pressure[other] <= 0;
  }
  return own > 0 && (!at_edge || own * own > squared_pressure_at_edge * largest * largest);
}

double ContactArea::continued(std::size_t row, const std::vector<char>& carrying,
                              const Eigen::VectorXd& squared) const {
  std::set<int> near;
  double sum = 0;
  for (const int first : neighbours_[row]) {
    if (!carrying[static_cast<std::size_t>(first)]) continue;
    sum += squared[first];
    near.insert(first);
    for (const int second : neighbours_[static_cast<std::size_t>(first)])
      if (carrying[static_cast<std::size_t>(second)]) near.insert(second);
  }
  const contact::Plane plane = contact::Plane::through(place_[row], normal_[row]);
  Eigen::MatrixX3d matrix(static_cast<Eigen::Index>(near.size()), 3);
  Eigen::VectorXd values(matrix.rows());
  Eigen::Index k = 0;
  for (const int other : near) {
    const Eigen::Vector2d x = plane.project(place_[static_cast<std::size_t>(other)]);
    const double weight = 1 / x.squaredNorm();
    matrix.row(k) << weight, weight * x.x(), weight * x.y();
    values[k++] = weight * squared[other];
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> fit(matrix);
  const auto n_first = std::count_if(neighbours_[row].begin(), neighbours_[row].end(),
                                     [&](int other) { return carrying[static_cast<std::size_t>(other)]; });
  // Too few rows for a slope: the edge is halfway.
  if (fit.rank() < 3) return -sum / static_cast<double>(n_first);
  return std::min(0.0, fit.solve(values)[0]);
}

void ContactArea::add_inside(const Facet& facet, const Eigen::VectorXd& level, Eigen::VectorXd& inside,
                             Eigen::VectorXd& whole) const {
  std::array<Corner, 4> corners;
  Corner centre;
  for (std::size_t i = 0; i < facet.n_corners; ++i) {
    const int row = facet.rows[i];
    corners[i] = {place_[static_cast<std::size_t>(row)], level[row], {}};
    corners[i].hats[i] = 1;
    const double share = 1.0 / static_cast<double>(facet.n_corners);
    centre.place += share * corners[i].place;
    centre.level += share * level[row];
    centre.hats[i] = share;
  }
  const auto add = [&](const std::array<double, 4>& integrals, Eigen::VectorXd& sums) {
    for (std::size_t i = 0; i < facet.n_corners; ++i) sums[facet.rows[i]] += integrals[i];
  };
  for (std::size_t i = 0; i < facet.n_corners; ++i) {
    const std::array<Corner, 3> piece{corners[i], corners[(i + 1) % facet.n_corners], centre};
    add(integral(piece[0], piece[1], piece[2]), whole);
    const std::vector<Corner> part = positive_part(piece);
    for (std::size_t k = 2; k < part.size(); ++k) add(integral(part[0], part[k - 1], part[k]), inside);
  }
}

double ContactArea::value(const Eigen::VectorXd& pressure) const {
  const std::size_t n_rows = area_.size();
  std::vector<char> carrying(n_rows);
  for (std::size_t i = 0; i < n_rows; ++i) carrying[i] = carries(i, pressure) ? 1 : 0;
  const Eigen::VectorXd squared = pressure.cwiseAbs2();
  Eigen::VectorXd level = Eigen::VectorXd::Constant(squared.size(), -1.0);
  for (std::size_t i = 0; i < n_rows; ++i) {
    const auto is_carrying = [&](int other) { return carrying[static_cast<std::size_t>(other)] != 0; };
    const auto row = static_cast<Eigen::Index>(i);
    if (carrying[i])
      level[row] = squared[row];
    else if (std::any_of(neighbours_[i].begin(), neighbours_[i].end(), is_carrying))
      level[row] = continued(i, carrying, squared);
  }
  Eigen::VectorXd inside = Eigen::VectorXd::Zero(level.size()), whole = inside;
  for (const Facet& facet : facets_) add_inside(facet, level, inside, whole);
  double sum = 0;
  for (std::size_t i = 0; i < n_rows; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    // A row without a facet that is covered at all its corners has no edge to be seen.
    sum += area_[i] * (whole[row] > 0 ? inside[row] / whole[row] : double(carrying[i]));
  }
  return sum;
}

}  // namespace creepcontact::simulation
