#include "creepcontact/results/contact_width.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "creepcontact/base/index.hpp"
#include "support/contact/curved_pair.hpp"

namespace creepcontact::results::test {
namespace {

using Force = std::function<double(double, double)>;

/// Width of contact on the rectangle nx x ny, elements of size one, with a force at every node.
std::optional<int> width(int nx, int ny, const Force& force, mesh::CellType type = mesh::CellType::hex8) {
  const Vector3 lengths(nx, ny, 1);
  const creepcontact::test::Part slave(creepcontact::test::box_mesh(type, {nx, ny, 1}, lengths, {0, 0, -1}), "z1"),
      master(creepcontact::test::box_mesh(type, {2, 2, 1}, lengths), "z0");
  contact::Pair pair;
  pair.slave_surface = "z1";
  pair.coupling = contact::mortar_coupling(slave.surface(), master.surface(), contact::ContactType::unilateral);
  const contact::ContactGrid grid(pair, slave.mesh);
  Eigen::VectorXd forces(grid.positions.size());
  for (Index i = 0; i < forces.size(); ++i)
    forces[i] = force(grid.position(static_cast<int>(i)).x(), grid.position(static_cast<int>(i)).y());
  return elements_across(grid, forces);
}

/// One for |x - x0| <= half, else zero.
Force strip(double x0, double half) {
  return [=](double x, double) { return std::abs(x - x0) < half + 0.1 ? 1.0 : 0.0; };
}

TEST(ContactWidth, NothingAndTheWholeSurface) {
  EXPECT_EQ(width(6, 6, [](double, double) { return 0.0; }), std::nullopt);
  EXPECT_EQ(width(6, 6, [](double, double) { return 1.0; }), std::nullopt);
}

TEST(ContactWidth, StripsAcrossASurface) {
  for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet4}) {
    EXPECT_EQ(width(12, 4, strip(6, 0), type), 1);
    EXPECT_EQ(width(12, 4, strip(6, 1), type), 3);
    EXPECT_EQ(width(12, 4, strip(6, 2), type), 5);
  }
}

/// One row of elements: the zone is as wide as the surface in that direction, which has no edge.
TEST(ContactWidth, ThinSurfacesCountAlongTheirLengthAlone) {
  EXPECT_EQ(width(12, 1, strip(6, 3)), 7);
  EXPECT_EQ(width(12, 1, [](double, double) { return 1.0; }), std::nullopt);
}

/// A plane of symmetry at x = 0: half of a zone of nine nodes.
TEST(ContactWidth, HalfAZoneAtTheEndOfTheSurface) {
  EXPECT_EQ(width(12, 2, strip(0, 4)), 9);
  EXPECT_EQ(width(12, 2, strip(0, 1)), 3);
}

TEST(ContactWidth, NarrowestOfTheZonesThatCarry) {
  const auto two = [](double second) {
    return [=](double x, double) { return x < 4.5 ? 1.0 : x > 9.5 && x < 12.5 ? second : 0.0; };
  };
  EXPECT_EQ(width(20, 2, two(1)), 3);
  EXPECT_EQ(width(20, 2, two(0.1)), 9) << "a twentieth of the force";
}

}  // namespace
}  // namespace creepcontact::results::test
