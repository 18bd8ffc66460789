/// The point-wise elimination of the state from Newton systems, for laws with variables of their own too.
#include "creepcontact/creep/material_tangent.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "creepcontact/base/index.hpp"
#include "creepcontact/material/registry.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::creep::test {
namespace {

using creepcontact::test::box_mesh;
using creepcontact::test::elastic_material;
using material::PointChange;
using material::PointRate;
using material::PointState;

/// rate = 3/2 A q^2 k^-1 s, dk/dt = A q^3/k: hardens with its own measure of creep.
class Hardening final : public material::CreepLaw {
 public:
  Hardening() : CreepLaw({}) {}
  std::string name() const override { return "hardening"; }
  int n_internal() const override { return 1; }
  void rate(const PointState& at, PointRate into) const override {
    const Tensor6 s = tensor::deviator(at.stress);
    const double q = std::sqrt(1.5) * s.norm(), k = at.internal[0];
    into.creep_strain += 1.5 * A * q * q / k * s;
    into.internal[0] = A * q * q * q / k;
  }
  void derivative(const PointState& at, const PointChange& change, PointRate into) const override {
    const Tensor6 s = tensor::deviator(at.stress), ds = tensor::deviator(change.stress);
    const double q = std::sqrt(1.5) * s.norm(), dq = 1.5 * s.dot(ds) / q, k = at.internal[0], dk = change.internal[0];
    into.creep_strain += 1.5 * A * (q * q / k * ds + (2 * q * dq / k - q * q / k / k * dk) * s);
    into.internal[0] = A * (3 * q * q * dq / k - q * q * q / k / k * dk);
  }
  material::StressTangent stress_tangent(const PointState&) const override { return {}; }

 private:
  static constexpr double A = 0.02;
};

/// rate = (s - c e)/eta, e the creep strain: a Kelvin element.
class Kelvin final : public material::CreepLaw {
 public:
  Kelvin() : CreepLaw({}) {}
  std::string name() const override { return "kelvin"; }
  void rate(const PointState& at, PointRate into) const override {
    into.creep_strain += rate(at.stress, at.creep_strain);
  }
  void derivative(const PointState&, const PointChange& change, PointRate into) const override {
    into.creep_strain += rate(change.stress, change.creep_strain);
  }
  material::StressTangent stress_tangent(const PointState&) const override { return {}; }

 private:
  static Tensor6 rate(const Tensor6& stress, const Tensor6& strain) {
    return (tensor::deviator(stress) - 50 * strain) / 30;
  }
};

std::vector<double> random_numbers(std::size_t n, double least, double most, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(least, most);
  std::vector<double> values(n);
  for (double& value : values) value = number(generator);
  return values;
}

using Laws = std::vector<std::shared_ptr<const material::CreepLaw>>;

/// Two Kelvin elements and a dashpot; volume creeps too.
std::shared_ptr<const material::CreepLaw> chain() {
  return material::find_creep_law("hereditary")
      ->make_by_key({{"compliances", {0.02, 0.05}},
                     {"times", {0.3, 2.0}},
                     {"volumetric_compliances", {0.01, 0.0}},
                     {"fluidity", {0.04}}});
}

/// Each point gets constants of its own.
void scatter(LawParameters& laws, std::size_t n_points) {
  const std::vector<double> of_one = laws.values, factors = random_numbers(of_one.size() * n_points, 0.5, 2, 5);
  laws.values.clear();
  for (const double factor : factors) laws.values.push_back(factor * of_one[laws.values.size() % of_one.size()]);
  laws.uniform = false;
}

struct EliminationCase {
  std::string name;
  Laws laws;
  bool differs = false;  ///< constants differ among points
};
class StateElimination : public testing::TestWithParam<EliminationCase> {};

/// I - gamma (A - C H) of one point, from the law's derivative.
Eigen::MatrixXd newton_matrix(const MaterialPoints& points, std::size_t p, double gamma, const PointsState& at) {
  const Index n = points.stride();
  Eigen::MatrixXd matrix(n, n);
  for (Index j = 0; j < n; ++j) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, j);
    const Tensor6 d_stress = material::stress(at.elastic.at(p), -unit.head<6>());
    Eigen::VectorXd d_rate(n);
    points.derivative_at(p, at, {{d_stress.data(), 6}, {unit.data(), points.stride()}},
                         {d_rate.data(), points.stride()});
    matrix.col(j) = unit - gamma * d_rate;
  }
  return matrix;
}

TEST_P(StateElimination, SolvesThePointsOwnPartOfTheNewtonSystem) {
  material::Material material = elastic_material();
  material.creep = GetParam().laws;
  mechanics::Body body("body", box_mesh(mesh::CellType::hex8, {1, 1, 1}), material, {}, std::nullopt);
  const MaterialPoints points(body);
  const mechanics::BodyConditions conditions = body.at(0);
  LawParameters laws;
  points.update(conditions, laws);
  if (GetParam().differs) scatter(laws, points.size());
  const std::size_t n = points.size(), stride = points.stride();
  const std::vector<double> stress = random_numbers(6 * n, -3, 3, 1), state = random_numbers(stride * n, 0.5, 2, 2),
                            r = random_numbers(stride * n, -1, 1, 3), strain = random_numbers(6 * n, -1, 1, 4);
  const std::vector<double> no_state_change(stride, 0.0);
  const PointsState at{laws, conditions.elastic(), stress, state};
  for (const double gamma : {1e-3, 1.0, 1e2}) {
    MaterialTangent tangent(points);
    tangent.prepare(gamma, at);
    std::vector<double> z_alone(stride * n);
    tangent.solve_points(gamma, at, r, z_alone);
    std::vector<double> z(stride * n), initial(6 * n);
    tangent.solution(r, strain, z);
    tangent.initial_stress(r, initial);
    for (std::size_t p = 0; p < n; ++p) {
      const auto solution = Eigen::VectorXd::Map(&z[stride * p], stride);
      // What the strain of the body adds to the right-hand side: gamma C H B du
      const Tensor6 imposed = material::stress(at.elastic.at(p), Tensor6::Map(&strain[6 * p]));
      Eigen::VectorXd right(solution.size());
      points.derivative_at(p, at, {{imposed.data(), 6}, no_state_change}, {right.data(), stride});
      right = gamma * right + Eigen::VectorXd::Map(&r[stride * p], solution.size());
      const Eigen::VectorXd exact = newton_matrix(points, p, gamma, at).partialPivLu().solve(right);
      EXPECT_LT((solution - exact).norm(), 1e-10 * (1 + exact.norm())) << gamma;
      // The same change of stress by the modulus, D (B du - e), and by Hooke's law.
      const Tensor6 by_modulus = tangent.moduli()[p] * Tensor6::Map(&strain[6 * p]) - Tensor6::Map(&initial[6 * p]);
      const Tensor6 elastic = Tensor6::Map(&strain[6 * p]) - exact.head<6>();
      EXPECT_LT((by_modulus - material::stress(at.elastic.at(p), elastic)).norm(), 1e-10 * 200) << gamma;
      const Eigen::VectorXd alone = newton_matrix(points, p, gamma, at)
                                        .partialPivLu()
                                        .solve(Eigen::VectorXd::Map(&r[stride * p], solution.size()));
      EXPECT_LT((Eigen::VectorXd::Map(&z_alone[stride * p], solution.size()) - alone).norm(),
                1e-10 * (1 + alone.norm()))
          << gamma;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Laws, StateElimination,
    testing::Values(EliminationCase{"hardening", {std::make_shared<Hardening>()}},
                    EliminationCase{"kelvin", {std::make_shared<Kelvin>()}},
                    EliminationCase{"kelvin_and_hardening",
                                    {std::make_shared<Kelvin>(), std::make_shared<Hardening>()}},
                    EliminationCase{"chain", {chain()}}, EliminationCase{"two_chains", {chain(), chain()}},
                    EliminationCase{"chain_that_differs", {chain()}, true},
                    EliminationCase{"chain_and_hardening", {chain(), std::make_shared<Hardening>()}, true}),
    [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace creepcontact::creep::test
