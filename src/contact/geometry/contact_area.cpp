#include "creepcontact/contact/geometry/contact_area.hpp"

#include <Eigen/Geometry>
#include <array>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

/// A corner of a piece of a facet: where it is, how large the level and the facet's hats are there.
struct Corner {
  Vector3 position = Vector3::Zero();
  double level = 0;
  std::array<double, 4> hats{};
};

Corner between(const Corner& a, const Corner& b, double part) {
  Corner middle{a.position + part * (b.position - a.position), a.level + part * (b.level - a.level), {}};
  for (std::size_t i = 0; i < 4; ++i) middle.hats[i] = a.hats[i] + part * (b.hats[i] - a.hats[i]);
  return middle;
}

/// Integrals of the hats over a triangle.
std::array<double, 4> integral(const Corner& a, const Corner& b, const Corner& c) {
  const double area = 0.5 * (b.position - a.position).cross(c.position - a.position).norm();
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

ContactArea::ContactArea(const contact::Pair& pair, const mesh::Mesh& slave)
    : coupling_(pair.coupling), grid_(pair, slave), edge_(coupling_, grid_) {}

void ContactArea::add_inside(const ContactGrid::Facet& facet, const Eigen::VectorXd& level, Eigen::VectorXd& inside,
                             Eigen::VectorXd& whole) const {
  std::array<Corner, 4> corners;
  Corner centre;
  for (std::size_t i = 0; i < facet.n_corners; ++i) {
    const int row = facet.rows[i];
    corners[i] = {facet.positions[i], level[row], {}};
    corners[i].hats[i] = 1;
    const double share = 1.0 / static_cast<double>(facet.n_corners);
    centre.position += share * corners[i].position;
    centre.level += share * level[row];
    centre.hats[i] = share;
  }
  const auto add = [&](const std::array<double, 4>& integrals, Eigen::VectorXd& sums) {
    for (std::size_t i = 0; i < facet.n_corners; ++i) sums[grid_.own(facet.rows[i])] += integrals[i];
  };
  for (std::size_t i = 0; i < facet.n_corners; ++i) {
    const std::array<Corner, 3> piece{corners[i], corners[(i + 1) % facet.n_corners], centre};
    add(integral(piece[0], piece[1], piece[2]), whole);
    const std::vector<Corner> part = positive_part(piece);
    for (std::size_t k = 2; k < part.size(); ++k) add(integral(part[0], part[k - 1], part[k]), inside);
  }
}

double ContactArea::value(const std::vector<char>& closed, const Eigen::VectorXd& gap) const {
  return of_nodes(closed, gap).sum();
}

Eigen::VectorXd ContactArea::of_nodes(const std::vector<char>& closed, const Eigen::VectorXd& gap) const {
  const Eigen::VectorXd level = edge_.distances(closed, gap);
  Eigen::VectorXd inside = Eigen::VectorXd::Zero(grid_.n_own), whole = inside;
  for (const ContactGrid::Facet& facet : grid_.facets) add_inside(facet, level, inside, whole);
  Eigen::VectorXd areas(inside.size());
  for (Index row = 0; row < areas.size(); ++row)
    // A row without a facet that is covered at all its corners has no edge to be seen.
    areas[row] =
        coupling_.area[static_cast<std::size_t>(row)] *
        (whole[row] > 0 ? inside[row] / whole[row] : static_cast<double>(closed[static_cast<std::size_t>(row)]));
  return areas;
}

}  // namespace creepcontact::contact
