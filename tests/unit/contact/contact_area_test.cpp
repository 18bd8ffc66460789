#include "creepcontact/contact/geometry/contact_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "creepcontact/base/index.hpp"
#include "support/contact/curved_pair.hpp"

namespace creepcontact::contact::test {
namespace {

/// The unit square with n x n elements as slave, fully covered.
class Square {
 public:
  /// Distance from the edge of contact, positive inside.
  using Distance = std::function<double(double, double)>;
  using Gap = std::function<double(double)>;  // over the distance outside

  Square(mesh::CellType type, int n)
      : n_(n), slave_(creepcontact::test::box_mesh(type, {n, n, 1}, Vector3::Ones(), {0, 0, -1}), "z1") {
    const creepcontact::test::Part master(creepcontact::test::box_mesh(type, {2, 2, 1}), "z0");
    pair_.slave_surface = "z1";
    pair_.coupling = contact::mortar_coupling(slave_.surface(), master.surface(), contact::ContactType::unilateral);
  }

  static double smooth(double outside) { return std::pow(outside, 1.5); }

  double area(const Distance& distance, const Gap& gap = smooth) const {
    const Eigen::VectorXd pressure = closed(distance);
    const contact::MortarCoupling& coupling = pair_.coupling;
    Eigen::VectorXd gaps(coupling.gap_points.size());
    for (Index i = 0; i < gaps.size(); ++i) {
      const Vector3& x = coupling.gap_points[i];
      const double inside = distance(x.x(), x.y());
      gaps[i] = inside < 0 ? gap(-inside) : 0.0;
    }
    const Eigen::VectorXd weighted = coupling.gap_weights * gaps;
    std::vector<char> in_contact;
    for (const double value : pressure) in_contact.push_back(value > 0 ? 1 : 0);
    return ContactArea(pair_, slave_.mesh).value(in_contact, (pressure.array() > 0).select(0.0, weighted));
  }
  /// Area of the multipliers under pressure.
  double counted(const Distance& distance) const {
    const Eigen::VectorXd pressure = closed(distance);
    return pressure.dot(Eigen::Map<const Eigen::VectorXd>(pair_.coupling.area.data(), pressure.size()));
  }

 private:
  /// A pressure of one where nodes are closed. A node closes when the edge is still a third of an element away: between
  /// elements the gap cannot bend as sharply as it does at the edge.
  Eigen::VectorXd closed(const Distance& distance) const {
    Eigen::VectorXd result(pair_.coupling.nodes.size());
    for (Index i = 0; i < result.size(); ++i) {
      const Vector3& x = slave_.mesh.nodes[pair_.coupling.nodes[i].node];
      result[i] = distance(x.x(), x.y()) > -1.0 / (3 * n_) ? 1 : 0;
    }
    return result;
  }

  int n_;
  creepcontact::test::Part slave_;
  contact::Pair pair_;
};

/// A circle of contact.
Square::Distance circle(double x, double y, double radius) {
  return [=](double px, double py) { return radius - std::hypot(px - x, py - y); };
}

class ContactAreas : public testing::TestWithParam<mesh::CellType> {};

TEST_P(ContactAreas, WholeSurfaceAndNone) {
  const Square square(GetParam(), 4);
  EXPECT_NEAR(square.area([](double, double) { return 1.0; }), 1, 1e-12);
  EXPECT_NEAR(square.area([](double x, double) { return 1e-9 + x; }), 1, 1e-12);
  EXPECT_EQ(square.area([](double, double) { return -1.0; }), 0);
}

// Circles anywhere in the mesh: the radius from the area, with five and ten elements over it.
TEST_P(ContactAreas, Circles) {
  const double radius = 0.3;
  for (const auto& [n, bound] : {std::pair(16, 0.02), std::pair(32, 0.01)}) {
    double worst = 0, worst_counted = 0;
    const Square square(GetParam(), n);
    for (const double x : {0.5, 0.51, 0.523})
      for (const double y : {0.5, 0.489, 0.53}) {
        const auto error = [&](double area) { return std::abs(std::sqrt(area / std::numbers::pi) / radius - 1); };
        worst = std::max(worst, error(square.area(circle(x, y, radius))));
        worst_counted = std::max(worst_counted, error(square.counted(circle(x, y, radius))));
      }
    EXPECT_LT(worst, bound) << n;
    EXPECT_GT(worst_counted, 3 * worst) << n;
  }
}

// A straight edge that wanders through an element: the error stays below an eighth of the element.
TEST_P(ContactAreas, EdgeWithinAnElement) {
  const int n = 8;
  const Square square(GetParam(), n);
  for (int percent = 0; percent < 100 / n; ++percent) {
    const double edge = 0.5 + 0.01 * percent;
    EXPECT_NEAR(square.area([&](double x, double) { return edge - x; }), edge, 0.125 / n) << edge;
  }
}

// The same where the contact is the outer part, and around a hole of it.
TEST_P(ContactAreas, OpenInTheMiddle) {
  const int n = 16;
  const Square square(GetParam(), n);
  const auto hole = [](double x, double y) { return -circle(0.5, 0.5, 0.3)(x, y); };
  EXPECT_NEAR(square.area(hole), 1 - std::numbers::pi * 0.09, 0.125 / n * 2 * std::numbers::pi * 0.3);
}

// Nothing tells more of the edge than the nodes: a gap that begins with a step, and one open row at the end.
TEST_P(ContactAreas, HalfwayWhereTheGapDoesNotTell) {
  const int n = 8;
  const Square square(GetParam(), n);
  const double last = 4.0 / n;  // closed nodes, x <= last
  EXPECT_NEAR(square.area([&](double x, double) { return last + 0.3 / n - x; }, [](double) { return 1e-3; }),
              last + 0.5 / n, 0.125 / n);
  EXPECT_NEAR(square.area([&](double x, double) { return 1 - 0.7 / n - x; }), 1 - 0.5 / n, 0.125 / n);
}

// Too few nodes under pressure for any slope inside: about the area that belongs to the node.
TEST_P(ContactAreas, SingleNode) {
  const int n = 8;
  const Square square(GetParam(), n);
  const double area = square.area(circle(0.5, 0.5, 0.5 / n));
  EXPECT_LT(square.counted(circle(0.5, 0.5, 0.5 / n)), 2.0 / (n * n));
  EXPECT_GT(area, 0.3 / (n * n));
  EXPECT_LT(area, 2.0 / (n * n));
}

INSTANTIATE_TEST_SUITE_P(Cells, ContactAreas,
                         testing::Values(mesh::CellType::hex8, mesh::CellType::hex20, mesh::CellType::tet4),
                         [](const auto& tested) { return std::string(mesh::name(tested.param)); });

}  // namespace
}  // namespace creepcontact::contact::test
