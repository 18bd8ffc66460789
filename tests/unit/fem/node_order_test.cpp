/// Node order and faces against Gmsh's own reference coordinates (getElementProperties of Gmsh 4.8).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "creepcontact/base/index.hpp"
#include "elements.hpp"

namespace creepcontact::fem {
namespace {

using testing::gradient_at;

/// Coordinates node by node, as many a node as the element has dimensions.
const std::map<CellType, std::vector<double>>& gmsh_nodes() {
  static const std::map<CellType, std::vector<double>> nodes{
      {CellType::line2, {-1, 1}},
      {CellType::line3, {-1, 1, 0}},
      {CellType::tri3, {0, 0, 1, 0, 0, 1}},
      {CellType::tri6, {0, 0, 1, 0, 0, 1, 0.5, 0, 0.5, 0.5, 0, 0.5}},
      {CellType::quad4, {-1, -1, 1, -1, 1, 1, -1, 1}},
      {CellType::quad8, {-1, -1, 1, -1, 1, 1, -1, 1, 0, -1, 1, 0, 0, 1, -1, 0}},
      {CellType::quad9, {-1, -1, 1, -1, 1, 1, -1, 1, 0, -1, 1, 0, 0, 1, -1, 0, 0, 0}},
      {CellType::tet4, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}},
      {CellType::tet10,
       {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0.5, 0.5, 0.5, 0, 0.5}},
      {CellType::hex8, {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1}},
      {CellType::hex20,
       {-1, -1, -1, 1, -1, -1, 1, 1,  -1, -1, 1, -1, -1, -1, 1, 1,  -1, 1, 1, 1,  1, -1, 1, 1, 0, -1, -1, -1, 0, -1,
        -1, -1, 0,  1, 0,  -1, 1, -1, 0,  0,  1, -1, 1,  1,  0, -1, 1,  0, 0, -1, 1, -1, 0, 1, 1, 0,  1,  0,  1, 1}},
      {CellType::hex27,
       {-1, -1, -1, 1,  -1, -1, 1, 1, -1, -1, 1,  -1, -1, -1, 1,  1, -1, 1, 1,  1, 1, -1, 1,  1, 0,  -1, -1,
        -1, 0,  -1, -1, -1, 0,  1, 0, -1, 1,  -1, 0,  0,  1,  -1, 1, 1,  0, -1, 1, 0, 0,  -1, 1, -1, 0,  1,
        1,  0,  1,  0,  1,  1,  0, 0, -1, 0,  -1, 0,  -1, 0,  0,  1, 0,  0, 0,  1, 0, 0,  0,  1, 0,  0,  0}},
      {CellType::wedge6, {0, 0, -1, 1, 0, -1, 0, 1, -1, 0, 0, 1, 1, 0, 1, 0, 1, 1}},
      {CellType::wedge15, {0,  0, -1, 1, 0,   -1,  0,  1, -1, 0, 0, 1, 1, 0,   1, 0, 1, 1,   0.5, 0,   -1,  0, 0.5,
                           -1, 0, 0,  0, 0.5, 0.5, -1, 1, 0,  0, 0, 1, 0, 0.5, 0, 1, 0, 0.5, 1,   0.5, 0.5, 1}},
  };
  return nodes;
}

class NodeOrder : public ::testing::TestWithParam<CellType> {};
INSTANTIATE_TEST_SUITE_P(AllTypes, NodeOrder, ::testing::ValuesIn(testing::element_types()), testing::type_name);

TEST_P(NodeOrder, IsThatOfGmsh) {
  const ReferenceElement& element = reference_element(GetParam());
  const std::vector<double>& expected = gmsh_nodes().at(GetParam());
  const int dimension = element.dimension();
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(element.n_nodes() * dimension));
  for (int i = 0; i < element.n_nodes(); ++i) {
    for (int d = 0; d < 3; ++d) {
      const double x = d < dimension ? expected[i * dimension + d] : 0;
      EXPECT_DOUBLE_EQ(element.nodes()(i, d), x) << "node " << i << ", coordinate " << d;
    }
  }
}

TEST_P(NodeOrder, FacesLieOnTheBoundaryAndLookOutward) {
  const ReferenceElement& element = reference_element(GetParam());
  if (element.dimension() < 2) {
    EXPECT_TRUE(element.faces().empty());
    return;
  }
  if (element.dimension() == 2) {
    double area = 0;  // of the triangles from the origin to the corners of the edges, which go round the cell
    for (const auto& edge : element.faces()) {
      const Vector3 a = element.nodes().row(edge.nodes[0]), b = element.nodes().row(edge.nodes[1]);
      area += 0.5 * a.cross(b).z();
      const Vector3 middle =
          edge.nodes.size() > 2 ? Vector3(element.nodes().row(edge.nodes[2])) : Vector3(0.5 * (a + b));
      EXPECT_LT((middle - 0.5 * (a + b)).norm(), 1e-15);
    }
    EXPECT_NEAR(area, element.rule().weights.sum(), 1e-14);
    return;
  }
  const Vector3 centre = element.nodes().topRows(mesh::n_corners(GetParam())).colwise().mean();
  double volume = 0;  // by the divergence theorem: a missing or doubled face would show
  for (const ReferenceElement::Face& local : element.faces()) {
    const ReferenceElement& face = reference_element(local.type);
    ASSERT_EQ(local.nodes.size(), static_cast<std::size_t>(face.n_nodes()));
    const Eigen::MatrixX3d position = element.nodes()(local.nodes, Eigen::all);
    const QuadratureRule& rule = face.rule();
    for (int q = 0; q < rule.size(); ++q) {
      const Vector3 xi = rule.points.row(q);
      const Matrix3 tangents = position.transpose() * gradient_at(face, xi);
      const Vector3 normal = tangents.col(0).cross(tangents.col(1));
      const Vector3 x = position.transpose() * testing::shape_at(face, xi);
      EXPECT_GT(normal.dot(x - centre), 0.01);
      EXPECT_GT(normal.norm(), 0.1);
      volume += rule.weights[q] * normal.dot(x) / 3;
      for (Index i = 0; i < element.nodes().rows(); ++i) {  // the element is on one side of its face
        EXPECT_LT(normal.dot(element.nodes().row(i).transpose() - x), 1e-14);
      }
      // Nodes off the face have no part in the trace, those on it the face's own shape functions.
      Eigen::VectorXd trace = testing::shape_at(element, x);
      trace(local.nodes) -= testing::shape_at(face, xi);
      EXPECT_LT(trace.lpNorm<Eigen::Infinity>(), 1e-14);
    }
  }
  const double expected = element.rule().weights.sum();
  EXPECT_NEAR(volume, expected, 4e-15 * expected);
}

}  // namespace
}  // namespace creepcontact::fem
