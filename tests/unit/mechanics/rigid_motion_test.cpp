/// Free rigid-body motions of many supports, in words.
#include "creepcontact/mechanics/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>

#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"
#include "support/says.hpp"

namespace creepcontact::test {
namespace {

using mechanics::Constraints;
using mechanics::Support;
using Facts = std::vector<std::vector<std::string_view>>;

const mesh::Mesh& box() {
  static const mesh::Mesh mesh = box_mesh(CellType::hex8, {2, 2, 2}, {2, 2, 2}, {0, 0, 4});  // centre (1, 1, 5)
  return mesh;
}

std::vector<std::int64_t> all_nodes(const std::vector<Vector3>& nodes) {
  std::vector<std::int64_t> all(nodes.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<std::string> free_motions(const std::vector<Vector3>& nodes, const std::vector<Support>& supports) {
  const Constraints constraints(nodes, supports);
  mesh::Mesh mesh;
  mesh.nodes = nodes;
  std::vector<std::string> words;
  for (const auto& motion : free_rigid_motions(mesh, constraints, all_nodes(nodes))) {
    words.push_back(motion.describe());
    for (const Support& s : supports) {
      for (std::size_t i = 0; i < s.nodes.size(); ++i) {
        const Vector3& n = s.directions[s.directions.size() == 1 ? 0 : i];
        EXPECT_NEAR(n.dot(motion.displacement(nodes[s.nodes[i]])), 0.0, 1e-10) << words.back();
      }
    }
  }
  return words;
}

std::vector<std::string> free_motions(const std::vector<Support>& supports) {
  return free_motions(box().nodes, supports);
}

/// Of each motion its kind, its direction and, of a rotation, a point of the axis.
void expect_motions(const std::vector<std::string>& found, const Facts& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_TRUE(says(found[i], expected[i]));
    EXPECT_EQ(found[i].find("radian"), std::string::npos) << "no shift along the axis: " << found[i];
  }
}

Support on(const std::string& surface, const Vector3& direction) {
  return support(box(), surface, direction);
}

std::vector<std::int64_t> nodes_at(const Vector3& position) {
  for (std::size_t i = 0; i < box().nodes.size(); ++i)
    if ((box().nodes[i] - position).norm() < 1e-12) return {static_cast<std::int64_t>(i)};
  return {};
}

TEST(RigidMotions, OfAFreeBody) {
  expect_motions(free_motions({}), {{"translation", " x"},
                                    {"translation", " y"},
                                    {"translation", " z"},
                                    {"rotation", "(1, 0, 0)", "(1, 1, 5)"},
                                    {"rotation", "(0, 1, 0)", "(1, 1, 5)"},
                                    {"rotation", "(0, 0, 1)", "(1, 1, 5)"}});
}

TEST(RigidMotions, OnOneSymmetryPlane) {
  expect_motions(free_motions({on("z0", Vector3::UnitZ())}),
                 {{"translation", " x"}, {"translation", " y"}, {"rotation", "(0, 0, 1)", "(1, 1, 5)"}});
}

TEST(RigidMotions, OnTwoSymmetryPlanes) {
  expect_motions(free_motions({on("z0", Vector3::UnitZ()), on("x0", Vector3::UnitX())}), {{"translation", " y"}});
}

TEST(RigidMotions, OnThreeSymmetryPlanes) {
  expect_motions(free_motions(symmetry_supports(box())), {});
}

TEST(RigidMotions, OfAClampedBody) {
  expect_motions(free_motions({on("x0", Vector3::UnitX()), on("x0", Vector3::UnitY()), on("x0", Vector3::UnitZ())}),
                 {});
}

TEST(RigidMotions, AboutAFixedPoint) {
  std::vector<Support> supports;
  for (int i = 0; i < 3; ++i) supports.push_back({"corner", nodes_at({2, 0, 4}), {Vector3::Unit(i)}, 0.0});
  expect_motions(free_motions(supports), {{"rotation", "(1, 0, 0)", "(1, 0, 4)"},
                                          {"rotation", "(0, 1, 0)", "(2, 1, 4)"},
                                          {"rotation", "(0, 0, 1)", "(2, 0, 5)"}});
}

TEST(RigidMotions, AboutAnObliqueHinge) {
  std::vector<Support> supports;
  for (int i = 0; i < 3; ++i) {
    supports.push_back({"one end", nodes_at({0, 0, 4}), {Vector3::Unit(i)}, 0.0});
    supports.push_back({"other end", nodes_at({2, 2, 4}), {Vector3::Unit(i)}, 0.0});
  }
  expect_motions(free_motions(supports), {{"rotation", "(0.7071, 0.7071, 0)", "(1, 1, 4)"}});
}

TEST(RigidMotions, OnAnInclinedPlane) {
  const mesh::Mesh tilted = mapped(box(), [](const Vector3& x) {
    return Vector3(Eigen::AngleAxisd(0.5, Vector3::UnitX()) * (x - Vector3(1, 1, 5)));
  });
  const Vector3 normal(0, -std::sin(0.5), std::cos(0.5));
  expect_motions(free_motions(tilted.nodes, {support(tilted, "z0", normal)}),
                 {{"translation", " x"},
                  {"translation", " (0, 0.8776, 0.4794)"},
                  {"rotation", "(0, -0.4794, 0.8776)", "(0, 0, 0)"}});
}

/// A ring held radially on its bore slides and turns; held at one end it only turns.
TEST(RigidMotions, OfARingOnAShaft) {
  std::vector<Vector3> nodes;
  Support radial{"bore", {}, {}, 0.0}, end{"end", {}, {Vector3::UnitZ()}, 0.0};
  for (int layer = 0; layer < 2; ++layer) {
    for (int i = 0; i < 12; ++i) {
      const double angle = 2 * std::numbers::pi * i / 12;
      radial.nodes.push_back(nodes.size());
      radial.directions.emplace_back(std::cos(angle), std::sin(angle), 0);
      nodes.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), layer);
      if (layer == 0) end.nodes.push_back(radial.nodes.back());
    }
  }
  expect_motions(free_motions(nodes, {radial}), {{"translation", " z"}, {"rotation", "(0, 0, 1)", "(0, 0, 0.5)"}});
  expect_motions(free_motions(nodes, {radial, end}), {{"rotation", "(0, 0, 1)", "(0, 0, 0.5)"}});
}

TEST(RigidMotions, DescribeAScrew) {
  const mechanics::RigidMotion screw{{0, 0, 0.5}, {0, 0, 2}, {1, 0, 0}};
  EXPECT_TRUE(says(screw.describe(), {"rotation", "(0, 0, 1)", "(1, 0, 0)", "0.25", "radian"}));
}

TEST(RigidMotions, AreTidiedForTheReader) {
  const mechanics::RigidMotion nearly_a_turn{{0, 1e-6, 1e-6}, {1e-6, 0, -1}, {1e-6, 3, 0}};
  EXPECT_TRUE(says(nearly_a_turn.tidied(1.0).describe(), {"rotation", "(0, 0, 1)", "(0, 3, 0)"}));
  EXPECT_EQ(nearly_a_turn.tidied(1.0).describe().find("radian"), std::string::npos);
  const mechanics::RigidMotion nearly_a_shift{{0, 1, 1e-6}, {1e-6, 0, 0}, {0, 0, 0}};
  EXPECT_TRUE(says(nearly_a_shift.tidied(1.0).describe(), {"translation", " y"}));
  const mechanics::RigidMotion screw{{0, 0, 0.5}, {0, 0, 2}, {1, 0, 0}};
  EXPECT_EQ(screw.tidied(1.0).describe(), screw.describe());
}

/// What supports and links leave of them: every motion of the free unknowns moves the nodes as the rigid body does,
/// wherever nothing holds or guides them.
TEST(RigidMotionsOnFree, MoveTheNodesThatNothingHolds) {
  const std::vector<Vector3>& nodes = box().nodes;
  std::vector<Support> supports(2);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].z() == 4) supports[0].nodes.push_back(static_cast<std::int64_t>(i));
    if (nodes[i].x() == 0 && nodes[i].z() < 6) supports[1].nodes.push_back(static_cast<std::int64_t>(i));
  }
  supports[0].directions = {Vector3(0, 0, 1)};
  supports[1].directions = {Vector3(1, 1, 0).normalized()};
  for (const bool linked : {false, true}) {
    mechanics::NodeLinks links;
    if (linked) {
      mechanics::NodeLinks::Rigid surface{.on = "top", .nodes = {}};
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].z() == 6) surface.nodes.push_back(static_cast<std::int64_t>(i));
      links.rigid.push_back(surface);
    }
    const Constraints constraints(nodes, supports, links);
    const Eigen::MatrixXd motions = rigid_motions_on_free(nodes, constraints);
    ASSERT_EQ(motions.rows(), constraints.n_free());
    ASSERT_EQ(motions.cols(), 6);
    const std::vector<double> zero(constraints.n_full(), 0.0);
    for (int k = 0; k < 6; ++k) {
      mechanics::RigidMotion motion{.centre = {1, 1, 5}};
      (k < 3 ? motion.translation : motion.rotation)[k % 3] = 1;
      std::vector<double> full(constraints.n_full());
      constraints.expand({motions.col(k).data(), static_cast<std::size_t>(motions.rows())}, zero, full);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].z() == 4 || (nodes[i].x() == 0 && nodes[i].z() < 6)) continue;
        const Vector3 moved(full[3 * i], full[3 * i + 1], full[3 * i + 2]);
        EXPECT_LE((moved - motion.displacement(nodes[i])).norm(), 1e-8) << k << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace creepcontact::test
