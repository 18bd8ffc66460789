/// Supports: frames, combined and contradictory conditions, reduction of matrices.
#include "creepcontact/mechanics/constraints.hpp"

#include <gtest/gtest.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"
#include "support/says.hpp"

namespace creepcontact::test {
namespace {

using mechanics::Constraints;
using mechanics::Support;

const std::vector<Vector3> two_nodes{{0, 0, 0}, {1, 2, 3}};

Vector3 prescribed_at(const Constraints& constraints, std::size_t node, double t = 0.0) {
  std::vector<double> full(constraints.n_full(), 9.0);
  constraints.prescribed(t, full);
  return Vector3::Map(&full[3 * node]);
}

std::string message_of(const std::vector<Support>& supports) {
  try {
    const Constraints constraints(two_nodes, supports);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "";
}

TEST(Constraints, NumberTheFreeUnknownsNodeByNode) {
  const Constraints constraints(two_nodes, {{"a", {0}, {Vector3::UnitY()}, 0.0}});
  EXPECT_EQ(constraints.n_free(), 5);
  EXPECT_EQ(constraints.n_full(), 6);
  EXPECT_EQ(constraints.free_index(0), (std::array<std::int64_t, 3>{-1, 0, 1}));
  EXPECT_EQ(constraints.free_index(1), (std::array<std::int64_t, 3>{2, 3, 4}));
  EXPECT_EQ(constraints.node_of_free(), (std::vector<std::int64_t>{0, 0, 1, 1, 1}));
  Matrix3 expected;
  expected << 0, 1, 0, 1, 0, 0, 0, 0, 1;  // y held, then x and z
  EXPECT_EQ(constraints.frame(0), expected);
  EXPECT_EQ(constraints.frame(1), Matrix3(Matrix3::Identity()));
  EXPECT_EQ(constraints.n_held(0), 1);
  EXPECT_EQ(constraints.n_held(1), 0);
}

TEST(Constraints, InclinedNormalGivesARotatedFrame) {
  const Vector3 normal = Vector3(1, 2, -2) / 3;
  const Constraints constraints(two_nodes, {{"a", {1}, {normal}, 0.3}});
  const Matrix3 frame = constraints.frame(1);
  EXPECT_LT((frame.transpose() * frame - Matrix3::Identity()).norm(), 1e-15);
  EXPECT_NEAR(std::abs(frame.col(0).dot(normal)), 1.0, 1e-15);
  EXPECT_LT((prescribed_at(constraints, 1) - 0.3 * normal).norm(), 1e-16);
  EXPECT_EQ(prescribed_at(constraints, 0), Vector3(0, 0, 0));
}

TEST(Constraints, TwoInclinedConditionsInACoordinatePlaneKeepTheAxes) {
  const Vector3 a = Vector3(1, 1, 0).normalized(), b = Vector3(1, 0.2, 0).normalized();
  const Constraints constraints(two_nodes, {{"a", {0}, {a}, 1.0}, {"b", {0}, {b}, -2.0}});
  EXPECT_EQ(constraints.frame(0), Matrix3(Matrix3::Identity()));
  EXPECT_EQ(constraints.n_held(0), 2);
  const Vector3 u = prescribed_at(constraints, 0);
  EXPECT_NEAR(u.dot(a), 1.0, 1e-14);
  EXPECT_NEAR(u.dot(b), -2.0, 1e-14);
  EXPECT_EQ(u[2], 0.0);
}

TEST(Constraints, ThreeObliqueConditionsSolveForTheDisplacement) {
  const Vector3 exact(0.1, -0.2, 0.3);
  std::vector<Support> supports;
  for (const Vector3& n : {Vector3(1, 2, 3), Vector3(-1, 1, 0.5), Vector3(0.3, 0.2, -2)})
    supports.push_back({"s", {1}, {n.normalized()}, n.normalized().dot(exact)});
  // a fourth that agrees
  supports.push_back({"agrees", {1}, {Vector3::UnitZ()}, 0.3});
  const Constraints constraints(two_nodes, supports);
  EXPECT_LT((prescribed_at(constraints, 1) - exact).norm(), 1e-14);
  EXPECT_EQ(constraints.free_index(1), (std::array<std::int64_t, 3>{-1, -1, -1}));
}

TEST(Constraints, ValuesFollowTimeAndPlaceAndTheDirectionOfEachNode) {
  const Constraints constraints(
      two_nodes, {{"a", {0, 1}, {Vector3::UnitX(), -Vector3::UnitY()}, Function::expression("t*(1 + z)", {"t", "z"})}});
  EXPECT_EQ(prescribed_at(constraints, 0, 2.0), Vector3(2, 0, 0));
  EXPECT_EQ(prescribed_at(constraints, 1, 2.0), Vector3(0, -8, 0));
  EXPECT_TRUE(constraints.has_nonzero_values());
  std::vector<double> full(6);
  EXPECT_FALSE(constraints.prescribed(0.0, full));
  EXPECT_TRUE(constraints.prescribed(1.0, full));
}

TEST(Constraints, TheSameConditionTwiceIsOne) {
  const Constraints constraints(two_nodes,
                                {{"a", {0, 0}, {Vector3::UnitX()}, 0.5}, {"b", {0}, {-Vector3::UnitX()}, -0.5}});
  EXPECT_EQ(constraints.n_held(0), 1);
  EXPECT_EQ(prescribed_at(constraints, 0), Vector3(0.5, 0, 0));
}

TEST(Constraints, ContradictionNamesBothSupports) {
  const std::string message =
      message_of({{"left", {1}, {Vector3::UnitX()}, 0.0}, {"clamp", {1}, {Vector3::UnitX()}, 0.1}});
  EXPECT_TRUE(says(message, {"supports 'left' and 'clamp'", "node (1, 2, 3)"}));
}

TEST(Constraints, ContradictionOfACombinationNamesAll) {
  const std::string message = message_of({{"a", {0}, {Vector3::UnitX()}, 0.1},
                                          {"b", {0}, {Vector3::UnitY()}, 0.1},
                                          {"slope", {0}, {Vector3(1, 1, 0).normalized()}, 0.1}});
  EXPECT_TRUE(says(message, {"supports 'a', 'b' and 'slope'"}));
}

TEST(Constraints, ContradictionOfRampsThatAgreeAtTheStart) {
  EXPECT_NE(message_of({{"a", {0}, {Vector3::UnitX()}, Function::expression("t", {"t"})},
                        {"b", {0}, {Vector3::UnitX()}, Function::expression("2*t", {"t"})}}),
            "");
  EXPECT_NE(message_of({{"a", {0}, {Vector3::UnitX()}, Function::table("t", {0, 10, 20}, {0, 0, 1})},
                        {"b", {0}, {Vector3::UnitX()}, 0.0}}),
            "");
}

/// One matrix with all kinds of supports: T from expand(), everything else against T.
class Reduction : public testing::Test {
 protected:
  mesh::Mesh mesh_ = box_mesh(CellType::hex8, {2, 2, 1});
  std::vector<Support> supports_{held("x0", {1, 1, 0.5}), held("y0", {0, 1, 0}), held("z1", {0, 0.6, 0.8}),
                                 held("x1", {0, 0, 1})};
  Constraints constraints_{mesh_.nodes, supports_};
  Index n_full_ = constraints_.n_full(), n_free_ = constraints_.n_free();

  /// The same displacement everywhere, so that the supports agree where they meet.
  Support held(const std::string& surface, const Vector3& direction) const {
    return support(mesh_, surface, direction.normalized(), direction.normalized().dot(Vector3(0.1, -0.2, 0.3)));
  }

  Eigen::MatrixXd columns_of_expand() const {
    Eigen::MatrixXd t(n_full_, n_free_);
    Eigen::VectorXd free = Eigen::VectorXd::Zero(n_free_), full(n_full_);
    for (Index j = 0; j < n_free_; ++j) {
      free[j] = 1;
      constraints_.expand({free.data(), static_cast<std::size_t>(n_free_)}, {},
                          {full.data(), static_cast<std::size_t>(n_full_)});
      t.col(j) = full;
      free[j] = 0;
    }
    return t;
  }
};

TEST_F(Reduction, FreeMotionsAreOrthonormalAndKeepTheSupports) {
  const Eigen::MatrixXd t = columns_of_expand();
  EXPECT_LT((t.transpose() * t - Eigen::MatrixXd::Identity(n_free_, n_free_)).norm(), 1e-13);
  for (const Support& s : supports_)
    for (const std::int64_t node : s.nodes)
      EXPECT_LT((s.directions[0].transpose() * t.middleRows<3>(3 * node)).norm(), 1e-14) << s.on;
}

TEST_F(Reduction, PrescribedDisplacementMeetsEverySupport) {
  for (const Support& s : supports_)
    for (const std::int64_t node : s.nodes)
      EXPECT_NEAR(s.directions[0].dot(prescribed_at(constraints_, node)), s.value({}), 1e-14);
}

TEST_F(Reduction, RestrictionIsTheTranspose) {
  const Eigen::VectorXd full = Eigen::VectorXd::LinSpaced(n_full_, -1, 2);
  Eigen::VectorXd free(n_free_);
  constraints_.restrict_to_free({full.data(), static_cast<std::size_t>(n_full_)},
                                {free.data(), static_cast<std::size_t>(n_free_)});
  EXPECT_LT((free - columns_of_expand().transpose() * full).norm(), 1e-13);
}

TEST_F(Reduction, StiffnessIsCongruent) {
  const std::array moduli{material::lame(10.0, 0.3)};
  const auto lower = mechanics::Discretization(mesh_).stiffness({moduli, {}});
  const auto reduced = constraints_.reduce(lower);
  const Eigen::MatrixXd full = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd t = columns_of_expand();
  const Eigen::MatrixXd expected = (t.transpose() * full * t).triangularView<Eigen::Lower>();
  EXPECT_LT((Eigen::MatrixXd(reduced) - expected).norm(), 1e-13 * expected.norm());
  for (std::int64_t j = 0; j < reduced.cols(); ++j)
    for (std::int64_t k = reduced.outerIndexPtr()[j] + 1; k < reduced.outerIndexPtr()[j + 1]; ++k)
      EXPECT_LT(reduced.innerIndexPtr()[k - 1], reduced.innerIndexPtr()[k]);
}

TEST_F(Reduction, RowsAreMultipliedByT) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows(2, static_cast<int>(n_full_));
  for (int j = 0; j < n_full_; j += 2) rows.insert(j % 4 / 2, j) = 1.0 + j;
  const Eigen::MatrixXd expected = Eigen::MatrixXd(rows) * columns_of_expand();
  EXPECT_LT((Eigen::MatrixXd(constraints_.reduce_rows(rows)) - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace creepcontact::test
