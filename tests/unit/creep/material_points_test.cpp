#include "creepcontact/creep/material_points.hpp"

#include <numeric>
#include <random>

#include "support/mechanics/meshes.hpp"
#include "support/run/blocks.hpp"

namespace creepcontact::run::test {
namespace {

/// The point-wise part of the Jacobian, -C H, column by column from the laws' own derivative.
std::vector<Matrix6> local_jacobians(const System& system, const MaterialPoints& points, std::span<const double> y) {
  const mechanics::Body& body = system.model.bodies()[0];
  const Evaluation& at = system.rate.step_evaluation();
  const mechanics::ElasticState elastic = at.equilibrium.conditions[0].elastic();
  const std::size_t n = body.discretization().n_points();
  std::vector<Matrix6> result(n, Matrix6::Zero());
  std::vector<double> d_stress(6 * n), d_state(6 * n), d_rate(6 * n);
  for (int j = 0; j < 6; ++j) {
    std::fill(d_state.begin(), d_state.end(), 0.0);
    for (std::size_t p = 0; p < n; ++p) {
      const Tensor6 unit = Tensor6::Unit(j);
      tensor::writable(d_state, p) = unit;
      tensor::writable(d_stress, p) = material::stress(elastic.at(p), -unit);
    }
    points.derivative({at.laws[0], elastic, at.equilibrium.bodies[0].stress, y}, {d_stress, d_state}, d_rate);
    for (std::size_t p = 0; p < n; ++p) result[p].col(j) = tensor::view(d_rate, p);
  }
  return result;
}

struct PreconditionerCase {
  const char* name;
  std::vector<std::string> overrides;
};

class Preconditioner : public testing::TestWithParam<PreconditionerCase> {};

TEST_P(Preconditioner, IsTheInverseOfTheLocalPart) {
  const Case blocks;
  System system(blocks.config("", GetParam().overrides));
  std::mt19937 generator(3);
  std::normal_distribution<double> number;
  std::vector<double> y(system.rate.size()), r(y.size()), z(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    y[i] = 0.3 * number(generator) * system.rate.scale()[i];
    r[i] = number(generator);
  }
  system.rate.prepare_preconditioner(0, y);
  const MaterialPoints points(system.model.bodies()[0]);
  const std::vector<Matrix6> jacobians = local_jacobians(system, points, y);

  // Steps far below and far above the stable one.
  for (const double gamma : {1e-3, 1.0, 1e3}) {
    system.rate.precondition(gamma, r, z);
    for (std::size_t p = 0; p < jacobians.size(); ++p) {
      const tensor::ConstMap right = tensor::view(r, p), solution = tensor::view(z, p);
      const Tensor6 image = solution - gamma * (jacobians[p] * solution);
      ASSERT_LT((image - right).norm(), 1e-11 * right.norm() * (1 + gamma * jacobians[p].norm())) << p;
      const Tensor6 exact = (Matrix6::Identity() - gamma * jacobians[p]).partialPivLu().solve(right);
      ASSERT_LT((solution - exact).norm(), 1e-11 * right.norm()) << p;
    }
  }
}

TEST_P(Preconditioner, IsMadeOfTangentsThatGiveTheDerivative) {
  const Case blocks;
  System system(blocks.config("", GetParam().overrides));
  const std::vector<double> y(system.rate.size(), 0.0);
  std::vector<double> rate(y.size());
  system.rate.rate(0, y, rate);
  const Evaluation& at = system.rate.step_evaluation();
  const MaterialPoints points(system.model.bodies()[0]);
  ASSERT_TRUE(points.has_closed_form());
  std::mt19937 generator(4);
  std::normal_distribution<double> number;
  std::vector<double> stress(6 * points.size()), change(stress.size()), none(stress.size(), 0.0), exact(stress.size()),
      found(stress.size());
  for (double& component : stress) component = number(generator);
  for (double& component : change) component = number(generator);
  std::fill_n(stress.begin(), 6, 0.0);  // a point without stress
  const PointsState state{at.laws[0], at.equilibrium.conditions[0].elastic(), stress, none};
  std::vector<material::StressTangent> tangents(points.size());
  points.tangents(state, tangents);
  points.derivative(state, {change, none}, exact);
  points.derivative_by_tangents(state, tangents, change, found);
  for (std::size_t p = 0; p < points.size(); ++p)
    ASSERT_LE((tensor::view(found, p) - tensor::view(exact, p)).norm(), 1e-14 * tensor::view(exact, p).norm()) << p;
}

INSTANTIATE_TEST_SUITE_P(
    Laws, Preconditioner,
    testing::Values(PreconditionerCase{"norton", {}}, PreconditionerCase{"linear", {"materials.soft.creep.0.n=1"}},
                    PreconditionerCase{
                        "two_mechanisms",
                        {"materials.soft.creep=[{law='norton',A=1e-3,n=4},{law='garofalo',A=1e-2,alpha=0.5,n=3}]"}},
                    PreconditionerCase{"hot",
                                       {"temperature.value=100+10*z", "materials.soft.creep.0.A=1e-5*T",
                                        "materials.soft.young_modulus=100-T/10"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(MaterialPoints, ParametersFollowTheTemperature) {
  const Case blocks;
  const System system(
      blocks.config("", {"temperature.value=100*(1+t)", "materials.soft.creep.0.A={T=[100,200],values=[1e-3,5e-3]}"}));
  const MaterialPoints points(system.model.bodies()[0]);
  const std::size_t n = system.model.bodies()[0].discretization().n_points();
  std::vector<double> stress(6 * n), y(6 * n), rate(6 * n);
  for (std::size_t p = 0; p < n; ++p) stress[6 * p + 2] = -2;
  LawParameters laws;
  for (const auto& [t, A] : {std::pair(0.0, 1e-3), std::pair(1.0, 5e-3), std::pair(0.5, 3e-3), std::pair(0.0, 1e-3)}) {
    const mechanics::BodyConditions at = system.model.bodies()[0].at(t);
    points.update(at, laws);
    points.rate({laws, at.elastic(), stress, y}, rate);
    for (std::size_t p = 0; p < n; ++p) {
      ASSERT_NEAR(rate[6 * p + 2], -A * 16, 1e-12);
      ASSERT_NEAR(rate[6 * p], A * 8, 1e-12);
    }
  }
}

/// Creeps by its parameters in xx, by its variables in yy, and its variables grow by twice what they are.
class Witness final : public material::CreepLaw {
 public:
  Witness(std::vector<Function> parameters, int n_internal) : CreepLaw({std::move(parameters)}), n_(n_internal) {}
  std::string name() const override { return "witness"; }
  int n_internal() const override { return n_; }
  void rate(const material::PointState& at, material::PointRate into) const override {
    EXPECT_EQ(at.parameters.size(), n_parameters());
    for (const double parameter : at.parameters) into.creep_strain[0] += parameter;
    add(at.internal, into.creep_strain, into.internal);
  }
  void derivative(const material::PointState&, const material::PointChange& change,
                  material::PointRate into) const override {
    add(change.internal, into.creep_strain, into.internal);
  }
  material::StressTangent stress_tangent(const material::PointState&) const override { return {}; }

 private:
  void add(std::span<const double> own, tensor::Map creep_strain, std::span<double> rate) const {
    ASSERT_EQ(own.size(), n_);
    ASSERT_EQ(rate.size(), n_);
    for (int i = 0; i < n_; ++i) creep_strain[1] += own[i];
    for (int i = 0; i < n_; ++i) rate[i] = 2 * own[i];
  }
  int n_;
};

TEST(MaterialPoints, EveryLawSeesWhatBelongsToIt) {
  using creepcontact::test::box_mesh;
  const auto by_temperature = [](const char* text) { return Function::expression(text, {"T"}); };
  material::Material material;
  material.young_modulus = 100.0;
  material.creep = {std::make_shared<Witness>(std::vector<Function>{by_temperature("T"), 100.0}, 1),
                    std::make_shared<Witness>(std::vector<Function>{by_temperature("10*T")}, 3)};
  const mechanics::Body body("body", box_mesh(mesh::CellType::hex8, {1, 1, 1}), material, {},
                             Function::expression("1 + x", {"x"}));
  const MaterialPoints points(body);
  ASSERT_EQ(points.stride(), 10);
  const mechanics::BodyConditions conditions = body.at(0);
  LawParameters laws;
  points.update(conditions, laws);
  const std::size_t n = points.size();
  std::vector<double> stress(6 * n), state(10 * n), rate(10 * n), change(10 * n);
  std::iota(state.begin(), state.end(), 1.0);
  const PointsState at{laws, conditions.elastic(), stress, state};
  points.rate(at, rate);
  points.derivative(at, {stress, state}, change);
  for (std::size_t p = 0; p < n; ++p) {
    const double* own = &state[10 * p];
    std::vector<double> expected{0, own[6] + own[7] + own[8] + own[9], 0, 0, 0, 0};
    for (int i = 6; i < 10; ++i) expected.push_back(2 * own[i]);
    EXPECT_EQ(std::vector(&change[10 * p], &change[10 * p] + 10), expected) << p;
    EXPECT_NEAR(rate[10 * p], 11 * conditions.temperature[p] + 100, 1e-12) << p;
    EXPECT_EQ(std::vector(&rate[10 * p + 1], &rate[10 * p] + 10), std::vector(expected.begin() + 1, expected.end()));
  }
}

TEST(MaterialPoints, ElasticMaterialHasNone) {
  const Case blocks;
  const System system(blocks.config("", {"materials.soft.creep=[]"}));
  EXPECT_TRUE(MaterialPoints(system.model.bodies()[0]).empty());
  EXPECT_FALSE(MaterialPoints(system.model.bodies()[1]).empty());
}

}  // namespace
}  // namespace creepcontact::run::test
