/// The direct solver of the Newton systems of the creep rate.

#include <cmath>
#include <random>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/run/run.hpp"
#include "support/run/blocks.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace tangent_tests {
namespace {

constexpr const char* direct_contact = "contact_solver.method=active_set";

Eigen::VectorXd random_vector(const System& system, double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-size, size);
  Eigen::VectorXd result(system.rate.size());
  for (Index i = 0; i < result.size(); ++i) result[i] = number(generator) * system.rate.scale()[i];
  return result;
}

std::span<double> span(Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// The upper block has no supports of its own; a pressure holds it on the lower one.
const std::string floating_text = [] {
  std::string text = case_text;
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error(from);
    text.replace(at, from.size(), to);
  };
  replace("on = \"symmetry_x\"", "on = \"symmetry_x\"\nbody = \"lower\"");
  replace("on = \"symmetry_y\"", "on = \"symmetry_y\"\nbody = \"lower\"");
  replace("[[supports]]\non = \"top\"\ndisplacement = { z = -0.025 }", "[[loads]]\non = \"top\"\npressure = 1");
  return text;
}();

struct TangentCase {
  const char* name;
  std::vector<std::string> overrides;
  bool floating = false;
};

class TangentSolve : public testing::TestWithParam<TangentCase> {
 protected:
  std::vector<std::string> overrides() const {
    std::vector<std::string> all = GetParam().overrides;
    all.emplace_back(direct_contact);
    return all;
  }
  config::Config config() const {
    return GetParam().floating ? blocks_.parse(floating_text, overrides()) : blocks_.config("", overrides());
  }
  Case blocks_;
};

TEST_P(TangentSolve, SolvesTheNewtonSystem) {
  System system(config());
  Eigen::VectorXd y = random_vector(system, 0.3, 1), r = random_vector(system, 1, 2);
  Eigen::VectorXd z(y.size()), product(y.size());
  const double stiffest = 2 / system.rate.stable_step(0, span(y));
  // Far below and far above the relaxation time; the product multiplies the rounding of du by gamma J.
  for (const double gamma : {1e-3, 1.0, 1e3}) {
    system.rate.prepare_tangent(0, span(y), gamma);
    system.rate.solve_tangent(span(r), span(z));
    system.rate.jacobian_times(0, span(y), span(z), span(product));
    EXPECT_LT((z - gamma * product - r).norm(), 1e-12 * (1 + gamma * stiffest) * (r.norm() + z.norm())) << gamma;
  }
}

TEST_P(TangentSolve, IsTheInverseMatrix) {
  System system(config());
  constexpr double gamma = 10;
  Eigen::VectorXd y = random_vector(system, 0.3, 1), r = random_vector(system, 1, 2);
  const Index n = y.size();
  Eigen::MatrixXd matrix(n, n);
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(n), product(n);
  for (Index j = 0; j < n; ++j) {
    unit[j] = 1;
    system.rate.jacobian_times(0, span(y), span(unit), span(product));
    unit[j] = 0;
    matrix.col(j) = -gamma * product;
  }
  matrix.diagonal().array() += 1;
  Eigen::VectorXd z(n);
  system.rate.prepare_tangent(0, span(y), gamma);
  system.rate.solve_tangent(span(r), span(z));
  const Eigen::VectorXd exact = matrix.partialPivLu().solve(r);
  EXPECT_LT((z - exact).norm(), 1e-9 * exact.norm());
  EXPECT_GT((exact - r).norm(), 0.1 * r.norm()) << "creep matters";
}

INSTANTIATE_TEST_SUITE_P(
    Contacts, TangentSolve,
    testing::Values(TangentCase{"closed", {}},
                    TangentCase{"partly_open", {"contacts.0.gap=0.03*x-0.01", "supports.3.displacement.z=-0.01"}},
                    TangentCase{"open",
                                {"contacts.0.gap=1", "temperature.value=10*z*x^2",
                                 "materials.soft.thermal_expansion=1e-3", "materials.hard.thermal_expansion=1e-3",
                                 "materials.soft.reference_temperature=0", "materials.hard.reference_temperature=0"}},
                    TangentCase{"tied", {"contacts.0.type=tied"}},
                    TangentCase{"one_elastic_body", {"materials.hard.creep=[]"}},
                    TangentCase{"other_elastic_body", {"materials.soft.creep=[]"}}, TangentCase{"floating", {}, true},
                    TangentCase{"floating_tied", {"contacts.0.type=tied"}, true},
                    TangentCase{"floating_elastic", {"materials.hard.creep=[]"}, true},
                    TangentCase{"quadratic", {"mesh.order=2", "materials.hard.creep.0.n=1"}},
                    TangentCase{"hot", {"temperature.value=100+10*z", "materials.soft.creep.0.A=1e-5*T"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Tangent, WithoutCreepItIsTheElasticStiffness) {
  const Case blocks;
  System system(blocks.config("", {direct_contact}));
  Eigen::VectorXd y = random_vector(system, 0.3, 1), r = random_vector(system, 1, 2), z(y.size()), product(y.size());
  constexpr double gamma = 1e-9;
  system.rate.prepare_tangent(0, span(y), gamma);
  system.rate.solve_tangent(span(r), span(z));
  system.rate.jacobian_times(0, span(y), span(r), span(product));
  // To first order (I - gamma J)^-1 r = r + gamma J r, and J r is made with the elastic factors.
  EXPECT_LT((z - r - gamma * product).norm(), 1e-5 * gamma * product.norm() + 1e-14 * r.norm());
}

TEST(Tangent, LeavesTheRateAsItIs) {
  const Case blocks;
  System system(blocks.config());
  Eigen::VectorXd y = random_vector(system, 0.3, 1), other = random_vector(system, 0.3, 3);
  Eigen::VectorXd before(y.size()), after(y.size()), z(y.size());
  system.rate.rate(0, span(y), span(before));
  system.rate.prepare_tangent(0, span(other), 1.0);
  system.rate.solve_tangent(span(y), span(z));
  system.rate.rate(0, span(y), span(after));
  EXPECT_EQ(before, after);
}

TEST(Tangent, CountsWhatItCosts) {
  const Case blocks;
  System system(blocks.config("", {"materials.hard.creep=[]"}));
  Eigen::VectorXd y = random_vector(system, 0.3, 1), z(y.size());
  system.rate.rate(0, span(y), span(z));
  const RunCounters before = system.rate.run_counters();
  EXPECT_EQ(before.factorizations, 2);
  system.rate.prepare_tangent(0, span(y), 1.0);
  system.rate.solve_tangent(span(y), span(z));
  system.rate.solve_tangent(span(y), span(z));
  const RunCounters after = system.rate.run_counters();
  EXPECT_EQ(after.factorizations, 3) << "the elastic body keeps its factor";
  EXPECT_EQ(after.elastic_solves - before.elastic_solves, 2);
  EXPECT_EQ(after.rhs_evaluations, before.rhs_evaluations);
}

TEST(Tangent, RelaxesTheBlocksLikeTheClosedForm) {
  for (const char* integrator : {"cvode_bdf", "arkode_dirk"}) {
    const Case blocks;
    const config::Config config =
        blocks.config(pressure_probe, {"time.linear_solver=tangent", std::string("time.integrator=") + integrator,
                                       "time.end=100", "time.tolerance=1e-5", "time.output=[1,10]"});
    ASSERT_EQ(run(config, {.output = (blocks / "results").string()}).exit_status, 0);
    const Table history(blocks / "results" / "history.csv");
    expect_relaxed_pressure(history, 1e-4, integrator);
    const SummaryFile summary(blocks / "results" / "summary.json");
    EXPECT_EQ(summary.number("jacobian_products"), 0);
    EXPECT_GT(summary.number("factorizations"), 4);
    EXPECT_LT(summary.number("factorizations"), 2 + 2 * summary.number("steps"));
  }
}

TEST(Tangent, NeedsTheMatricesOfTheContactZones) {
  const Case blocks;
  const config::Config config = blocks.config("", {"time.linear_solver=tangent", "contact_solver.dense_limit_mb=1e-6"});
  const RunOptions options{.output = (blocks / "results").string()};
  const std::string message = message_of<ConfigError>([&] { run(config, options); });
  EXPECT_TRUE(contains(message, "contact_solver.dense_limit_mb = 1e-06")) << message;
  EXPECT_TRUE(contains(message, "or use \"krylov\"")) << message;
}

}  // namespace
}  // namespace tangent_tests
}  // namespace creepcontact::run::test
