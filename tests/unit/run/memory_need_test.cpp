#include "../../../src/run/memory_need.hpp"

#include "creepcontact/base/error.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

TEST(Memory, IsComparedBeforeAnythingIsFactored) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe);
  const Model model = build_model(config);
  Stopwatch watch;
  double contact = 0, factors = 0;
  const EquilibriumSolver solver(
      model.assembly, model.solver, watch, [&](const contact::CondensedInterface& analyzed, double contact_bytes) {
        contact = contact_bytes;
        for (std::size_t b = 0; b < 2; ++b) {
          const linalg::StiffnessSolver& of_body = analyzed.factored(b).solver();
          EXPECT_EQ(of_body.rcond(), 0) << "it has been factored";
          factors += static_cast<double>(of_body.factor_bytes());
          EXPECT_GT(of_body.work_bytes(), 0);
        }
        const MemoryNeed need = memory_need(config, model.assembly, contact_bytes, [](std::size_t) { return 1e6; });
        EXPECT_EQ(memory_shortage(need), "");
      });
  EXPECT_EQ(contact, solver.interface().dense_bytes());
  for (std::size_t b = 0; b < 2; ++b)
    factors -= static_cast<double>(solver.interface().factored(b).solver().factor_bytes());
  EXPECT_EQ(factors, 0);
}

TEST(Memory, AModelBeyondAllMachinesIsRefusedWithNumbers) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe);
  const Model model = build_model(config);
  const std::string message =
      memory_shortage(memory_need(config, model.assembly, 1e18, [](std::size_t) { return 1e6; }));
  EXPECT_TRUE(says(message, {"1000000000.0 GB", "(factors ", "contact matrices 1000000000.0 GB", "mesh"}));
}

TEST(Memory, DerivativesTakeMore) {
  const Case blocks;
  const auto need = [&](const std::vector<std::string>& overrides) {
    const config::Config config = blocks.config(pressure_probe, overrides);
    return memory_need(config, build_model(config).assembly, 1e6, [](std::size_t) { return 1e6; });
  };
  const MemoryNeed plain = need({}), two = need({R"(sensitivity.keys=["contacts[0].gap", "time.end"])"});
  EXPECT_EQ(plain.derivatives, 0);
  EXPECT_EQ(two.derivatives, 2 * (plain.state + 2 * plain.points));
  EXPECT_EQ(two.total(), plain.total() + two.derivatives);
}

TEST(Memory, TangentsTakeMore) {
  const Case blocks;
  const auto need = [&](const std::vector<std::string>& overrides) {
    const config::Config config = blocks.config(pressure_probe, overrides);
    const Model model = build_model(config);
    return memory_need(config, model.assembly, 1e6, [](std::size_t) { return 1e6; });
  };
  const MemoryNeed plain = need({}), tangent = need({"time.linear_solver=tangent"});
  EXPECT_EQ(plain.factors, 2e6);
  EXPECT_EQ(tangent.factors, 4e6);
  EXPECT_EQ(plain.contact, 1e6);
  EXPECT_EQ(tangent.contact, 2e6);
  EXPECT_GT(tangent.points, plain.points);
  EXPECT_EQ(plain.total(), plain.factors + plain.contact + plain.points + plain.state);
}

}  // namespace
}  // namespace creepcontact::run::test
