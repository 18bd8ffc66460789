#include "../../../src/results/local_fit.hpp"

#include <gtest/gtest.h>

#include "support/mechanics/meshes.hpp"

namespace creepcontact::results::test {
namespace {

using creepcontact::test::box_mesh;

double linear(const Vector3& x) {
  return 7 + 3 * x.x() - 2 * x.y() + 5 * x.z();
}

double quadratic(const Vector3& x) {
  return linear(x) + x.x() * x.x() - 2 * x.x() * x.y() + 0.5 * x.y() * x.z() + x.z() * x.z();
}

template <typename Field>
double fitted(const mechanics::Discretization& discretization, const mesh::Mesh& mesh, std::size_t element,
              const Vector3& at, const Field& field) {
  double value = 0;
  for (const auto& [point, weight] : local_fit(discretization, mesh, {&element, 1}, at))
    value += weight * field(discretization.point_coordinates()[point]);
  return value;
}

const Vector3 lengths(2, 1, 1.5);
/// A corner, the middle of a side, a place inside.
const std::vector<Vector3> positions{{0, 0, 0}, {2, 0.5, 0.75}, {0.7, 0.4, 1.1}};

class LocalFit : public testing::TestWithParam<mesh::CellType> {};

TEST_P(LocalFit, ConstantsWhateverTheMesh) {
  for (const std::array<int, 3> divisions : {std::array{1, 1, 1}, std::array{3, 1, 1}, std::array{2, 2, 1}}) {
    const mesh::Mesh mesh = box_mesh(GetParam(), divisions, lengths, Vector3::Zero(), 0.1);
    const mechanics::Discretization discretization(mesh);
    for (const Vector3& at : positions)
      EXPECT_NEAR(fitted(discretization, mesh, 0, at, [](const Vector3&) { return 7.0; }), 7, 1e-9)
          << divisions[0] << divisions[1] << divisions[2] << " at " << at.transpose();
  }
}

TEST_P(LocalFit, LinearFieldsWhereTheMeshDeterminesThem) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {2, 2, 2}, lengths, Vector3::Zero(), 0.1);
  const mechanics::Discretization discretization(mesh);
  for (const Vector3& at : positions) EXPECT_NEAR(fitted(discretization, mesh, 0, at, linear), linear(at), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Types, LocalFit, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& tested) { return std::string(mesh::name(tested.param)); });

TEST(LocalFitOfThreeLayers, QuadraticFieldsOfQuadraticElements) {
  // Of linear elements the middle is taken with the mean over the element, which is another value of a quadratic field.
  for (const mesh::CellType type : mesh::volume_cell_types()) {
    if (mesh::order(type) == 1) continue;
    const mesh::Mesh mesh = box_mesh(type, {3, 3, 3}, lengths, Vector3::Zero(), 0.1);
    const mechanics::Discretization discretization(mesh);
    // an element that has the middle of the box, and all others around it
    const std::size_t middle = discretization.n_elements() / 2;
    for (const Vector3& at : {Vector3(1, 0.5, 0.75), Vector3(0.8, 0.6, 0.6)})
      EXPECT_NEAR(fitted(discretization, mesh, middle, at, quadratic), quadratic(at), 1e-9) << mesh::name(type);
  }
}

TEST(LocalFitOfOneLayer, LinearFieldsOfQuadraticElements) {
  // The points lie in two planes: they determine a linear term across the layer, and no quadratic one beside it.
  for (const mesh::CellType type : {mesh::CellType::hex20, mesh::CellType::hex27, mesh::CellType::wedge15})
    for (const std::array<int, 3> divisions : {std::array{1, 1, 1}, std::array{3, 3, 1}, std::array{1, 4, 3}}) {
      const mesh::Mesh mesh = box_mesh(type, divisions, lengths);
      const mechanics::Discretization discretization(mesh);
      for (const Vector3& at : positions)
        EXPECT_NEAR(fitted(discretization, mesh, 0, at, linear), linear(at), 1e-9)
            << mesh::name(type) << " " << divisions[0] << divisions[1] << divisions[2] << " at " << at.transpose();
    }
}

TEST(LocalFitOfOneLayer, PlacesThatDoNotDifferAcrossItTellNothingOfThatDirection) {
  // The middles of linear elements lie in one plane but for rounding, and so does the place.
  const mesh::Mesh mesh = creepcontact::test::mapped(
      box_mesh(mesh::CellType::hex8, {8, 5, 1}, {60, 0.5, 2.1}),
      [](const Vector3& x) { return Vector3((60 + x.x()) * std::cos(x.y()), (60 + x.x()) * std::sin(x.y()), x.z()); });
  const mechanics::Discretization discretization(mesh);
  const std::size_t element = 17;
  for (const double angle : {0.21, 0.24, 0.27}) {
    const Vector3 at(71 * std::cos(angle), 71 * std::sin(angle), 1.05);
    double weights = 0;
    for (const auto& [point, weight] : local_fit(discretization, mesh, {&element, 1}, at)) weights += std::abs(weight);
    EXPECT_LT(weights, 4) << angle;
  }
}

/// At a node the fit does not depend on the element in which the place was found.
TEST(LocalFitAtANode, IsThatOfAllElementsAround) {
  for (const mesh::CellType type : {mesh::CellType::tet10, mesh::CellType::hex20, mesh::CellType::wedge15}) {
    const mesh::Mesh mesh = box_mesh(type, {4, 4, 4}, lengths, Vector3::Zero(), 0.1);
    const mechanics::Discretization discretization(mesh);
    const std::int64_t node = mesh.blocks[0].cell(discretization.n_elements() / 2)[0];
    std::vector<std::vector<std::pair<std::size_t, double>>> fits;
    for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
      const auto nodes = discretization.element_nodes(e);
      const auto found = std::ranges::find(nodes, node);
      if (found == nodes.end()) continue;
      PointLocation place{
          .element = e, .nodes = {nodes.begin(), nodes.end()}, .weights = std::vector<double>(nodes.size())};
      place.weights[static_cast<std::size_t>(found - nodes.begin())] = 1;
      fits.push_back(local_fit(discretization, mesh, elements_at(discretization, place), mesh.nodes[node]));
    }
    ASSERT_GT(fits.size(), 1u);
    for (const auto& fit : fits) EXPECT_EQ(fit, fits[0]) << mesh::name(type);
  }
}

}  // namespace
}  // namespace creepcontact::results::test
