#include "../../../src/simulation/memory_need.hpp"

#include "creepcontact/base/error.hpp"
#include "running.hpp"

namespace creepcontact::simulation::test {
namespace {

TEST(Memory, IsComparedBeforeAnythingIsFactored) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe);
  Model model = build_model(config);
  Stopwatch watch;
  double contact = 0, factors = 0;
  const ContactElasticity elasticity(model, watch, [&](double contact_bytes) {
    contact = contact_bytes;
    for (const auto& body : model.bodies) {
      EXPECT_EQ(body->factor().rcond(), 0) << "it has been factored";
      factors += static_cast<double>(body->factor().factor_bytes());
      EXPECT_GT(body->factor().work_bytes(), 0);
    }
    EXPECT_NO_THROW(require_memory(config, model, contact_bytes));
  });
  EXPECT_EQ(contact, elasticity.interface().dense_bytes());
  for (const auto& body : model.bodies) factors -= static_cast<double>(body->factor().factor_bytes());
  EXPECT_EQ(factors, 0);
}

TEST(Memory, AModelBeyondAllMachinesIsRefusedWithNumbers) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe);
  Model model = build_model(config);
  Stopwatch watch;
  const auto refused = [&] {
    const ContactElasticity elasticity(model, watch, [&](double) { require_memory(config, model, 1e18); });
  };
  const std::string message = message_of<ModelError>(refused);
  EXPECT_TRUE(contains(message, "blocks.geo: the model needs about 1000000000.0 GB of memory more (factors "))
      << message;
  EXPECT_TRUE(contains(message, "contact matrices 1000000000.0 GB")) << message;
  EXPECT_TRUE(contains(message, "; make the mesh coarser, or allow the program more memory")) << message;
}

TEST(Memory, TangentsTakeMore) {
  const Case blocks;
  const auto need = [&](const std::vector<std::string>& overrides) {
    const config::Config config = blocks.config(pressure_probe, overrides);
    const Model model = build_model(config);
    return memory_need(config, model, 1e6, [](mechanics::Body&) { return 1e6; });
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
}  // namespace creepcontact::simulation::test
