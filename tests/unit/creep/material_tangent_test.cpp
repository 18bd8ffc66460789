/// The point-wise elimination of the state from Newton systems, for laws with variables of their own too.
#include "creepcontact/creep/material_tangent.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::creep::test {
namespace {

using creepcontact::test::box_mesh;
using creepcontact::test::elastic_material;
using material::Point;

/// rate = 3/2 A q^2 k^-1 s, dk/dt = A q^3/k: hardens with its own measure of creep.
class Hardening final : public material::CreepLaw {
 public:
  Hardening() : CreepLaw({}) {}
  std::string name() const override { return "hardening"; }
  int n_internal() const override { return 1; }
  void rate(const Point& at, double* strain_rate, double* internal_rate) const override {
    const Tensor6 s = tensor::deviator(Eigen::Map<const Tensor6>(at.stress));
    const double q = std::sqrt(1.5) * s.norm(), k = at.internal[0];
    Eigen::Map<Tensor6>(strain_rate) += 1.5 * A * q * q / k * s;
    internal_rate[0] = A * q * q * q / k;
  }
  void derivative(const Point& at, const double* d_stress, const double*, const double* d_internal,
                  double* d_strain_rate, double* d_internal_rate) const override {
    const Tensor6 s = tensor::deviator(Eigen::Map<const Tensor6>(at.stress));
    const Tensor6 ds = tensor::deviator(Eigen::Map<const Tensor6>(d_stress));
    const double q = std::sqrt(1.5) * s.norm(), dq = 1.5 * s.dot(ds) / q, k = at.internal[0], dk = d_internal[0];
    Eigen::Map<Tensor6>(d_strain_rate) += 1.5 * A * (q * q / k * ds + (2 * q * dq / k - q * q / k / k * dk) * s);
    d_internal_rate[0] = A * (3 * q * q * dq / k - q * q * q / k / k * dk);
  }
  material::StressTangent stress_tangent(const Point&) const override { return {}; }

 private:
  static constexpr double A = 0.02;
};

/// rate = (s - c e)/eta, e the creep strain: a Kelvin element.
class Kelvin final : public material::CreepLaw {
 public:
  Kelvin() : CreepLaw({}) {}
  std::string name() const override { return "kelvin"; }
  void rate(const Point& at, double* strain_rate, double*) const override { add(at.stress, at.state, strain_rate); }
  void derivative(const Point&, const double* d_stress, const double* d_state, const double*, double* d_strain_rate,
                  double*) const override {
    add(d_stress, d_state, d_strain_rate);
  }
  material::StressTangent stress_tangent(const Point&) const override { return {}; }

 private:
  static void add(const double* stress, const double* strain, double* rate) {
    Eigen::Map<Tensor6>(rate) +=
        (tensor::deviator(Eigen::Map<const Tensor6>(stress)) - 50 * Eigen::Map<const Tensor6>(strain)) / 30;
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
class StateElimination : public testing::TestWithParam<Laws> {};

/// I - gamma (A - C H) of one point, from the law's derivative.
Eigen::MatrixXd newton_matrix(const MaterialPoints& points, std::size_t p, double gamma, const PointsState& at) {
  const auto n = static_cast<Eigen::Index>(points.stride());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, j);
    const Tensor6 d_stress = material::stress(at.elastic.at(p), -unit.head<6>());
    Eigen::VectorXd d_rate(n);
    points.derivative_at(p, at, d_stress.data(), unit.data(), d_rate.data());
    matrix.col(j) = unit - gamma * d_rate;
  }
  return matrix;
}

TEST_P(StateElimination, SolvesThePointsOwnPartOfTheNewtonSystem) {
  material::Material material = elastic_material();
  material.creep = GetParam();
  mechanics::Body body("body", box_mesh(mesh::CellType::hex8, {1, 1, 1}), material, {}, std::nullopt);
  const MaterialPoints points(body);
  const mechanics::BodyConditions conditions = body.at(0);
  LawParameters laws;
  points.update(conditions, laws);
  const std::size_t n = points.size(), stride = points.stride();
  const std::vector<double> stress = random_numbers(6 * n, -3, 3, 1), state = random_numbers(stride * n, 0.5, 2, 2),
                            r = random_numbers(stride * n, -1, 1, 3), strain = random_numbers(6 * n, -1, 1, 4);
  const std::vector<double> no_state_change(stride, 0.0);
  const PointsState at{laws, conditions.elastic(), stress, state.data()};
  for (const double gamma : {1e-3, 1.0, 1e2}) {
    MaterialTangent tangent(points);
    tangent.prepare(gamma, at);
    std::vector<double> z(stride * n), initial(6 * n);
    tangent.solution(r.data(), strain, z.data());
    tangent.initial_stress(r.data(), initial);
    for (std::size_t p = 0; p < n; ++p) {
      const auto solution = Eigen::VectorXd::Map(&z[stride * p], static_cast<Eigen::Index>(stride));
      // What the strain of the body adds to the right-hand side: gamma C H B du
      const Tensor6 imposed = material::stress(at.elastic.at(p), Tensor6::Map(&strain[6 * p]));
      Eigen::VectorXd right(solution.size());
      points.derivative_at(p, at, imposed.data(), no_state_change.data(), right.data());
      right = gamma * right + Eigen::VectorXd::Map(&r[stride * p], solution.size());
      const Eigen::VectorXd exact = newton_matrix(points, p, gamma, at).partialPivLu().solve(right);
      EXPECT_LT((solution - exact).norm(), 1e-10 * (1 + exact.norm())) << gamma;
      // The same change of stress by the modulus, D (B du - e), and by Hooke's law.
      const Tensor6 by_modulus = tangent.moduli()[p] * Tensor6::Map(&strain[6 * p]) - Tensor6::Map(&initial[6 * p]);
      const Tensor6 elastic = Tensor6::Map(&strain[6 * p]) - exact.head<6>();
      EXPECT_LT((by_modulus - material::stress(at.elastic.at(p), elastic)).norm(), 1e-10 * 200) << gamma;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, StateElimination,
                         testing::Values(Laws{std::make_shared<Hardening>()}, Laws{std::make_shared<Kelvin>()},
                                         Laws{std::make_shared<Kelvin>(), std::make_shared<Hardening>()}),
                         [](const auto& tested) {
                           std::string names;
                           for (const auto& law : tested.param) names += law->name();
                           return names;
                         });

}  // namespace
}  // namespace creepcontact::creep::test
