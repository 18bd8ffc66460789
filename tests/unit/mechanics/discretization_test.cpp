/// Element loops and stiffness, for every element type.
#include <omp.h>

#include <Eigen/Geometry>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "element_loops.hpp"

namespace creepcontact::test {
namespace {

INSTANTIATE_TEST_SUITE_P(Types, ElementLoops, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& type) { return std::string(mesh::name(type.param)); });

TEST_P(ElementLoops, WeightsFillTheVolume) {
  EXPECT_NEAR(std::accumulate(body_.weights().begin(), body_.weights().end(), 0.0), 1.0 * 1.5 * 0.8, 1e-13);
  EXPECT_EQ(body_.first_point(body_.n_elements()), body_.n_points());
  Vector3 moment = Vector3::Zero();
  for (std::size_t p = 0; p < body_.n_points(); ++p) moment += body_.weights()[p] * body_.point_coordinates()[p];
  EXPECT_LT((moment / 1.2 - Vector3(0.6, 0.95, 0.7)).norm(), 1e-13);
}

TEST_P(ElementLoops, RigidMotionGivesNoStrain) {
  const std::vector<double> u = nodal_field(
      mesh_, [](const Vector3& x) { return Vector3(Vector3(1, -2, 3) + Vector3(0.3, 0.5, -0.7).cross(x)); });
  EXPECT_LT(largest(strain(u)), 1e-13);
}

TEST_P(ElementLoops, LinearDisplacementGivesItsGradient) {
  Matrix3 gradient;
  gradient << 1, 2, 3, -4, 5, 6, 0.5, -1, 2;
  const std::vector<double> u = nodal_field(mesh_, [&](const Vector3& x) { return Vector3(gradient * x); });
  for (const Tensor6& e : as_tensors(strain(u))) EXPECT_LT((e - tensor::from_matrix(gradient)).norm(), 1e-12);
}

TEST_P(ElementLoops, InternalForceDoesTheWorkOfTheStress) {
  const std::vector<double> u = noise(n_dofs_, 1), v = noise(n_dofs_, 2);
  const std::vector<Moduli> moduli = varied_moduli();
  std::vector<double> of_u(n_values_), of_v(n_values_), forces(n_dofs_, 0.0);
  body_.stress(u, {moduli}, {}, of_u);
  body_.stress(v, {moduli}, {}, of_v);
  body_.add_internal_force(of_v, forces);
  double work = 0, size = 0;
  for (std::size_t p = 0; p < body_.n_points(); ++p) {
    const Tensor6 strain = material::elastic_strain(moduli[p], Tensor6::Map(&of_u[6 * p]));
    work += body_.weights()[p] * strain.dot(Tensor6::Map(&of_v[6 * p]));
    size += body_.weights()[p] * strain.norm() * Tensor6::Map(&of_v[6 * p]).norm();
  }
  EXPECT_NEAR(dot(forces, u), work, 1e-12 * size);
}

TEST_P(ElementLoops, InitialStrainForceIsThatOfItsStress) {
  const std::vector<double> creep = noise(n_values_, 6), thermal = noise(body_.n_points(), 7);
  const std::vector<Moduli> moduli = varied_moduli();
  const ElasticState elastic{moduli, thermal};
  const std::vector<double> zero(n_dofs_, 0.0);
  std::vector<double> stress(n_values_), expected(n_dofs_, 1.0), forces(n_dofs_, 1.0);
  body_.stress(zero, elastic, {creep, 6}, stress);
  for (double& s : stress) s = -s;
  body_.add_internal_force(stress, expected);
  body_.add_initial_strain_force(elastic, {creep, 6}, forces);
  for (std::size_t i = 0; i < n_dofs_; ++i) EXPECT_NEAR(forces[i], expected[i], 1e-11);
}

TEST_P(ElementLoops, StiffnessIsTheElementLoop) {
  const std::vector<Moduli> moduli = varied_moduli();
  const auto lower = body_.stiffness({moduli, {}});
  const std::vector<double> u = noise(n_dofs_, 8);
  std::vector<double> stress(n_values_), forces(n_dofs_, 0.0);
  body_.stress(u, {moduli, {}}, {}, stress);
  body_.add_internal_force(stress, forces);
  const Eigen::VectorXd product = lower.selfadjointView<Eigen::Lower>() * Eigen::VectorXd::Map(u.data(), n_dofs_);
  for (std::size_t i = 0; i < n_dofs_; ++i) EXPECT_NEAR(product[i], forces[i], 1e-10);
}

TEST_P(ElementLoops, StiffnessOfAnyModuliIsTheElementLoop) {
  std::vector<Matrix6> moduli;
  for (std::size_t p = 0; p < body_.n_points(); ++p) {
    const std::vector<double> entries = noise(36, 20 + static_cast<unsigned>(p));
    const Matrix6 root = Matrix6::Map(entries.data());
    moduli.emplace_back(root * root.transpose());
  }
  const auto lower = body_.stiffness(moduli);
  const std::vector<double> u = noise(n_dofs_, 8), no_stress(n_values_, 0.0);
  std::vector<double> at_points(n_values_), stress(n_values_), forces(n_dofs_, 0.0);
  body_.tangent_strain(u, moduli, no_stress, at_points);
  for (std::size_t p = 0; p < moduli.size(); ++p)
    Tensor6::Map(&stress[6 * p]) = moduli[p] * Tensor6::Map(&at_points[6 * p]);
  body_.add_internal_force(stress, forces);
  const Eigen::VectorXd product = lower.selfadjointView<Eigen::Lower>() * Eigen::VectorXd::Map(u.data(), n_dofs_);
  for (std::size_t i = 0; i < n_dofs_; ++i) EXPECT_NEAR(product[i], forces[i], 1e-11);
}

TEST_P(ElementLoops, StiffnessIsSortedLowerAndHasSixZeroModes) {
  const mesh::Mesh small = box_mesh(GetParam(), {2, 2, 1}, Vector3::Ones(), Vector3::Zero(), 0.0);
  const Discretization body(small);
  const std::array moduli{material::lame(1.0, 0.3)};
  const auto lower = body.stiffness({moduli, {}});
  for (std::int64_t j = 0; j < lower.cols(); ++j) {
    std::int64_t previous = j - 1;
    for (linalg::SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      EXPECT_GT(it.row(), previous);
      previous = it.row();
    }
    EXPECT_EQ(lower.innerIndexPtr()[lower.outerIndexPtr()[j]], j);
  }
  const Eigen::MatrixXd full = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd values = linalg::symmetric_eigen(full).values;
  EXPECT_LT(std::abs(values[5]), 1e-12 * values[values.size() - 1]);
  EXPECT_LT(std::abs(values[0]), 1e-12 * values[values.size() - 1]);
  EXPECT_GT(values[6], 1e-5 * values[values.size() - 1]);
}

TEST_P(ElementLoops, ResultsDoNotDependOnTheNumberOfThreads) {
  const mesh::Mesh mesh = box_mesh(GetParam(), {6, 6, 6}, Vector3::Ones(), Vector3::Zero(), 0.2);
  const Discretization body(mesh);
  const std::array moduli{material::lame(3.0, 0.3)};
  const std::vector<double> creep = noise(6 * body.n_points(), 9);
  const auto compute = [&](int threads) {
    omp_set_num_threads(threads);
    std::vector<double> forces(3 * body.n_nodes(), 0.0);
    body.add_initial_strain_force({moduli, {}}, {creep, 6}, forces);
    const auto matrix = body.stiffness({moduli, {}});
    forces.insert(forces.end(), matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros());
    return forces;
  };
  const int threads = omp_get_max_threads();
  const std::vector<double> one = compute(1), three = compute(3);
  omp_set_num_threads(threads);
  EXPECT_TRUE(one == three);
}

TEST_P(ElementLoops, LinearPointValuesReachTheNodesExactly) {
  std::vector<double> values;
  const auto field = [](const Vector3& x) { return std::array{1 + x[0] - 2 * x[1] + 3 * x[2], 5.0}; };
  for (const Vector3& x : body_.point_coordinates()) values.insert(values.end(), {field(x)[0], field(x)[1]});
  std::vector<double> nodal(2 * body_.n_nodes(), 7.0);
  body_.to_nodes(values, 2, nodal);
  for (std::size_t i = 0; i < body_.n_nodes(); ++i) {
    // Distorted linear shape functions reproduce a linear field; the middle nodes lie in the middle of corners.
    EXPECT_NEAR(nodal[2 * i], field(mesh_.nodes[i])[0], 1e-12);
    EXPECT_NEAR(nodal[2 * i + 1], 5.0, 1e-12);
  }
}

TEST_P(ElementLoops, ElementValuesAreMeans) {
  std::vector<double> values(body_.n_points()), means(body_.n_elements());
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = body_.point_coordinates()[p][0];
  body_.to_elements(values, 1, means);
  double moment = 0;
  for (std::size_t e = 0; e < body_.n_elements(); ++e) {
    double volume = 0;
    for (std::size_t p = body_.first_point(e); p < body_.first_point(e + 1); ++p) volume += body_.weights()[p];
    moment += volume * means[e];
  }
  EXPECT_NEAR(moment, 1.2 * 0.6, 1e-13);
}

TEST(Discretization, TetrahedraCarryTheirConstantToTheNodes) {
  const mesh::Mesh mesh = box_mesh(CellType::tet4, {1, 1, 1});
  const Discretization body(mesh);
  std::vector<double> nodal(body.n_nodes());
  body.to_nodes(std::vector<double>(body.n_points(), 4.0), 1, nodal);
  for (const double value : nodal) EXPECT_NEAR(value, 4.0, 1e-14);
}

TEST(Discretization, NumbersTheElementsOfSeveralBlocksOneAfterTheOther) {
  mesh::Mesh mesh = box_mesh(CellType::hex8, {2, 1, 1});
  const auto last = std::vector<std::int64_t>(mesh.blocks[0].cell(1).begin(), mesh.blocks[0].cell(1).end());
  mesh.blocks[0].connectivity.resize(8);
  mesh.blocks.push_back({CellType::wedge6,
                         {last[0], last[1], last[2], last[4], last[5], last[6],  //
                          last[0], last[2], last[3], last[4], last[6], last[7]}});
  const Discretization body(mesh);
  EXPECT_EQ(body.n_elements(), 3u);
  EXPECT_EQ(body.n_points(), 20u);
  EXPECT_EQ(body.first_point(1), 8u);
  EXPECT_EQ(body.first_point(2), 14u);
  EXPECT_EQ(body.element_type(0), CellType::hex8);
  EXPECT_EQ(body.element_type(2), CellType::wedge6);
  EXPECT_EQ(body.element_nodes(2)[1], last[2]);
  const std::array moduli{material::lame(1.0, 0.3)};
  const std::vector<double> u = noise(3 * body.n_nodes(), 10);
  std::vector<double> stress(6 * body.n_points()), forces(u.size(), 0.0);
  body.stress(u, {moduli, {}}, {}, stress);
  body.add_internal_force(stress, forces);
  const Eigen::VectorXd product =
      body.stiffness({moduli, {}}).selfadjointView<Eigen::Lower>() * Eigen::VectorXd::Map(u.data(), u.size());
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(product[i], forces[i], 1e-12);
}

TEST(Discretization, NamesAnInvertedElementAndItsPlace) {
  mesh::Mesh mesh = box_mesh(CellType::hex8, {2, 1, 1}, Vector3::Ones(), {10, 0, 0});
  auto& cell = mesh.blocks[0].connectivity;
  std::swap_ranges(cell.begin() + 8, cell.begin() + 12, cell.begin() + 12);
  try {
    const Discretization body(mesh);
    FAIL() << "no error";
  } catch (const ModelError& error) {
    EXPECT_NE(std::string(error.what()).find("element 1 (hex8) at (10.6"), std::string::npos) << error.what();
  }
}

TEST(Discretization, RefusesAMeshWithoutVolume) {
  mesh::Mesh mesh = box_mesh(CellType::hex8, {1, 1, 1});
  mesh.blocks.erase(mesh.blocks.begin());
  EXPECT_THROW(Discretization{mesh}, ModelError);
}

}  // namespace
}  // namespace creepcontact::test
