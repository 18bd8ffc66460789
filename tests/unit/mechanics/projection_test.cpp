/// Projection of the volumetric strain and of the mean stress, and the inner displacements, for every element type.
#include "element_loops.hpp"

namespace creepcontact::test {
namespace {

class Projection : public ElementLoops {};
INSTANTIATE_TEST_SUITE_P(Types, Projection, testing::ValuesIn(mesh::volume_cell_types()),
                         [](const auto& type) { return std::string(mesh::name(type.param)); });

TEST_P(Projection, MeanStressIsThatOfTheProjectedVolumetricStrain) {
  if (fem::has_bubble(GetParam())) GTEST_SKIP() << "the inner displacement adds to the strain of the nodes";
  if (GetParam() == CellType::hex20) GTEST_SKIP() << "projects distorted elements only";
  const std::vector<double> u = noise(n_dofs_, 3), creep = noise(9 * body_.n_points(), 4);
  const std::vector<double> thermal = noise(body_.n_points(), 5);
  const std::vector<Moduli> moduli = varied_moduli();
  std::vector<double> stress(n_values_);
  body_.stress(u, {moduli, thermal}, {creep, 9}, stress);
  const auto strains = as_tensors(strain(u)), stresses = as_tensors(stress);
  for (std::size_t e = 0; e < body_.n_elements(); ++e) {
    const std::size_t first = body_.first_point(e), n = body_.first_point(e + 1) - first;
    Eigen::VectorXd traces(n);
    std::vector<Tensor6> elastic;
    for (std::size_t p = 0; p < n; ++p) {
      elastic.emplace_back(strains[first + p] - Tensor6::Map(&creep[9 * (first + p)]) -
                           thermal[first + p] * tensor::identity());
      traces[p] = tensor::trace(elastic.back());
    }
    const Eigen::VectorXd fit = projected(e, traces);
    for (std::size_t p = 0; p < n; ++p) {
      elastic[p].head<3>().array() += (fit - traces)[p] / 3;
      EXPECT_LT((stresses[first + p] - material::stress(moduli[first + p], elastic[p])).norm(), 1e-9);
    }
  }
}

TEST_P(Projection, FittedMeanStressIsItsProjection) {
  if (GetParam() == CellType::tet10 || mesh::order(GetParam()) == 1) GTEST_SKIP() << "smoothed over neighbours";
  std::vector<double> stress = noise(n_values_, 12);
  const std::vector<double> before = stress;
  body_.fit_mean_stress(stress);
  if (!body_.fits_mean_stress()) {
    EXPECT_EQ(stress, before);
    return;
  }
  const auto given = as_tensors(before), fitted = as_tensors(stress);
  for (std::size_t e = 0; e < body_.n_elements(); ++e) {
    const std::size_t first = body_.first_point(e), n = body_.first_point(e + 1) - first;
    Eigen::VectorXd traces(n);
    for (std::size_t p = 0; p < n; ++p) traces[p] = tensor::trace(given[first + p]);
    const Eigen::VectorXd fit = projected(e, traces);
    for (std::size_t p = 0; p < n; ++p) {
      EXPECT_NEAR(tensor::trace(fitted[first + p]), fit[p], 1e-12);
      EXPECT_LT((tensor::deviator(fitted[first + p]) - tensor::deviator(given[first + p])).norm(), 1e-12);
    }
  }
}

TEST_P(Projection, FittedMeanStressKeepsLinearFields) {
  std::vector<double> stress;
  for (const Vector3& x : body_.point_coordinates()) {
    const double mean = 1 + 2 * x[0] - 3 * x[1] + x[2];
    for (const double component : {mean + 1, mean - 2, mean + 1, x[0], 2.0, x[1]}) stress.push_back(component);
  }
  const std::vector<double> before = stress;
  body_.fit_mean_stress(stress);
  for (std::size_t i = 0; i < stress.size(); ++i) EXPECT_NEAR(stress[i], before[i], 1e-11);
}

TEST(Hex20, ProjectsTheVolumetricStrainOfDistortedElementsOnly) {
  const std::array moduli{Moduli{.lambda = 1, .mu = 0}};
  for (const bool distorted : {false, true}) {
    const double skew = distorted ? 2 : 0;
    const mesh::Mesh mesh = mapped(box_mesh(CellType::hex20, {2, 2, 2}), [&](const Vector3& x) {
      return Vector3(x[0] * (1 + skew * x[1]), x[1] * (1 + skew * x[2]), x[2] * (1 + skew * x[0]));
    });
    const Discretization body(mesh);
    const std::vector<double> u = noise(3 * body.n_nodes(), 13);
    std::vector<double> stress(6 * body.n_points());
    body.stress(u, {moduli}, {}, stress);
    std::vector<double> fitted = stress;
    body.fit_mean_stress(fitted);
    double change = 0;
    for (std::size_t i = 0; i < stress.size(); ++i) change = std::max(change, std::abs(fitted[i] - stress[i]));
    if (distorted) {
      EXPECT_LT(change, 1e-10 * largest(stress));
    } else {
      EXPECT_GT(change, 0.1 * largest(stress));
    }
  }
}

TEST_P(Projection, TangentStrainOfElasticModuliIsTheElasticOne) {
  const std::vector<double> u = noise(n_dofs_, 3);
  std::vector<double> creep = noise(n_values_, 4);
  for (std::size_t i = 0; i < n_values_; i += 6) {  // creep keeps the volume
    Eigen::Map<Tensor6> at(&creep[i]);
    at = tensor::deviator(at).eval();
  }
  const std::vector<Moduli> moduli = varied_moduli();
  std::vector<Matrix6> matrices;
  std::vector<double> stress(n_values_), initial_stress(n_values_), strain(n_values_);
  for (std::size_t p = 0; p < body_.n_points(); ++p) {
    Matrix6 h = 2 * moduli[p].mu * Matrix6::Identity();
    h.topLeftCorner<3, 3>().array() += moduli[p].lambda;
    matrices.push_back(h);
    Tensor6::Map(&initial_stress[6 * p]) = h * Tensor6::Map(&creep[6 * p]);
  }
  body_.stress(u, {moduli}, {creep, 6}, stress);
  body_.tangent_strain(u, matrices, initial_stress, strain);
  for (std::size_t p = 0; p < body_.n_points(); ++p) {
    const Tensor6 elastic = Tensor6::Map(&strain[6 * p]) - Tensor6::Map(&creep[6 * p]);
    EXPECT_LT((matrices[p] * elastic - Tensor6::Map(&stress[6 * p])).norm(), 1e-9);
  }
  std::vector<double> forces(n_dofs_, 0.0), expected(n_dofs_, 0.0);
  body_.add_initial_stress_force(matrices, initial_stress, forces);
  body_.add_initial_strain_force({moduli}, {creep, 6}, expected);
  for (std::size_t i = 0; i < n_dofs_; ++i) EXPECT_NEAR(forces[i], expected[i], 1e-10);
}

TEST_P(Projection, LinearTensorsReachTheNodesExactly) {
  const auto field = [](const Vector3& x) {
    return Tensor6((Tensor6() << 1 + x[0], 2 - x[1], x[2], 3, x[0] - x[2], x[1]).finished());
  };
  std::vector<double> values, nodal(6 * body_.n_nodes(), 7.0);
  for (const Vector3& x : body_.point_coordinates()) {
    const Tensor6 at = field(x);
    values.insert(values.end(), at.begin(), at.end());
  }
  body_.tensors_to_nodes(values, nodal);
  for (std::size_t i = 0; i < body_.n_nodes(); ++i)
    EXPECT_LT((Tensor6::Map(&nodal[6 * i]) - field(mesh_.nodes[i])).norm(), 1e-11);
}

TEST_P(Projection, BodyForceOnInnerDisplacementsIsThatOfTheirFunctions) {
  if (!fem::has_bubble(GetParam())) {
    EXPECT_EQ(body_.n_inner(), 0u);
    return;
  }
  ASSERT_EQ(body_.n_inner(), body_.n_elements());
  const std::vector<Vector3> density(body_.n_points(), {2, 0, -1});
  std::vector<double> forces(3 * (body_.n_nodes() + body_.n_inner()), 0.0);
  body_.add_body_force(density, forces);
  for (std::size_t e = 0; e < body_.n_elements(); ++e) {
    const Eigen::Map<const Vector3> force(&forces[3 * (body_.n_nodes() + e)]);
    EXPECT_GT(force[0], 0);
    EXPECT_NEAR(force[2], -force[0] / 2, 1e-15);
  }
}

}  // namespace
}  // namespace creepcontact::test
