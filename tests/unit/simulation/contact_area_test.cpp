#include "../../../src/simulation/contact_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "unit/contact/curved_pair.hpp"

namespace creepcontact::simulation::test {
namespace {

/// The unit square with n x n elements as slave, fully covered.
class Square {
 public:
  Square(mesh::CellType type, int n)
      : n_(n), slave_(creepcontact::test::box_mesh(type, {n, n, 1}, Vector3::Ones(), {0, 0, -1}), "z1") {
    const creepcontact::test::Part master(creepcontact::test::box_mesh(type, {2, 2, 1}), "z0");
    pair_.slave_surface = "z1";
    pair_.coupling = contact::mortar_coupling(slave_.surface(), master.surface(), contact::ContactType::unilateral);
  }

  /// Area for multipliers that are the means of a pressure over the hats of squares.
  double area(const std::function<double(double, double)>& pressure) const {
    const ContactArea contact_area(pair_, mesh());
    return contact_area.value(means(pressure));
  }
  /// Area with pressure at the node (x, y) alone.
  double area_of_node(double x, double y) const {
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(pair_.coupling.nodes.size()));
    for (Eigen::Index i = 0; i < multipliers.size(); ++i) {
      const auto node = static_cast<std::size_t>(pair_.coupling.nodes[static_cast<std::size_t>(i)].node);
      if ((mesh().nodes[node].head<2>() - Eigen::Vector2d(x, y)).norm() < 1e-9) multipliers[i] = 1;
    }
    EXPECT_EQ(multipliers.sum(), 1);
    return ContactArea(pair_, mesh()).value(multipliers);
  }
  /// Area of the multipliers under pressure.
  double counted(const std::function<double(double, double)>& pressure) const {
    const Eigen::VectorXd multipliers = means(pressure);
    double sum = 0;
    for (std::size_t i = 0; i < pair_.coupling.area.size(); ++i)
      sum += multipliers[static_cast<int>(i)] > 0 ? pair_.coupling.area[i] : 0;
    return sum;
  }

 private:
  const mesh::Mesh& mesh() const { return slave_.mesh; }

  Eigen::VectorXd means(const std::function<double(double, double)>& pressure) const {
    constexpr int samples = 24;
    const double h = 1.0 / n_;
    Eigen::VectorXd result(static_cast<Eigen::Index>(pair_.coupling.nodes.size()));
    for (Eigen::Index i = 0; i < result.size(); ++i) {
      const auto node = static_cast<std::size_t>(pair_.coupling.nodes[static_cast<std::size_t>(i)].node);
      double sum = 0, weight = 0;
      for (int j = 0; j < samples; ++j)
        for (int k = 0; k < samples; ++k) {
          const double s = (j + 0.5) * 2 / samples - 1, t = (k + 0.5) * 2 / samples - 1;
          const double x = mesh().nodes[node].x() + s * h, y = mesh().nodes[node].y() + t * h;
          if (x < 0 || x > 1 || y < 0 || y > 1) continue;
          const double hat = (1 - std::abs(s)) * (1 - std::abs(t));
          sum += hat * pressure(x, y);
          weight += hat;
        }
      result[i] = sum / weight;
    }
    return result;
  }

  int n_;
  creepcontact::test::Part slave_;
  contact::Pair pair_;
};

class ContactAreas : public testing::TestWithParam<mesh::CellType> {};

TEST_P(ContactAreas, WholeSurfaceAndNone) {
  const Square square(GetParam(), 4);
  EXPECT_NEAR(square.area([](double, double) { return 1.0; }), 1, 1e-12);
  EXPECT_NEAR(square.area([](double x, double) { return 1e-9 + x; }), 1, 1e-12);
  EXPECT_EQ(square.area([](double, double) { return 0.0; }), 0);
}

// Hertz' pressure on circles anywhere in the mesh: the radius from the area, with five and ten elements over it.
TEST_P(ContactAreas, CirclesOfHertz) {
  const double radius = 0.3;
  for (const auto& [n, bound] : {std::pair(16, 0.02), std::pair(32, 0.01)}) {
    double worst = 0, worst_counted = 0;
    const Square square(GetParam(), n);
    for (const double x : {0.5, 0.51, 0.523})
      for (const double y : {0.5, 0.489, 0.53}) {
        const auto pressure = [&](double px, double py) {
          return std::sqrt(std::max(0.0, 1 - ((px - x) * (px - x) + (py - y) * (py - y)) / (radius * radius)));
        };
        const auto error = [&](double area) { return std::abs(std::sqrt(area / std::numbers::pi) / radius - 1); };
        worst = std::max(worst, error(square.area(pressure)));
        worst_counted = std::max(worst_counted, error(square.counted(pressure)));
      }
    EXPECT_LT(worst, bound) << n;
    EXPECT_GT(worst_counted, 3 * worst) << n;
  }
}

// A straight edge that wanders through an element, pressure like sqrt(distance): the error stays below an eighth of the
// element (the means over the hats are a little smaller than the pressure at their nodes, where it bends).
TEST_P(ContactAreas, EdgeWithinAnElement) {
  const int n = 8;
  const Square square(GetParam(), n);
  for (double edge = 0.5; edge < 0.5 + 1.0 / n; edge += 0.01)
    EXPECT_NEAR(square.area([&](double x, double) { return std::sqrt(std::max(0.0, edge - x)); }), edge, 0.125 / n)
        << edge;
}

// Too few nodes under pressure for any slope: about the area that belongs to the node.
TEST_P(ContactAreas, SingleNode) {
  const int n = 8;
  const Square square(GetParam(), n);
  const double area = square.area_of_node(0.5, 0.5);
  EXPECT_GT(area, 0.3 / (n * n));
  EXPECT_LT(area, 2.0 / (n * n));
}

INSTANTIATE_TEST_SUITE_P(Cells, ContactAreas,
                         testing::Values(mesh::CellType::hex8, mesh::CellType::hex20, mesh::CellType::tet4),
                         [](const auto& tested) { return std::string(mesh::name(tested.param)); });

}  // namespace
}  // namespace creepcontact::simulation::test
