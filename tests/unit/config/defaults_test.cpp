#include <fmt/format.h>

#include <algorithm>

#include "config_fixture.hpp"
#include "creepcontact/config/schema.hpp"

namespace creepcontact::config {
namespace {

TEST(ConfigDefaults, MinimalConfiguration) {
  const Config config = parse_text(minimal);
  EXPECT_EQ(config.file, "cases/block.toml");
  EXPECT_EQ(config.mesh.file, "cases/block.msh");
  ASSERT_EQ(config.bodies.size(), 1u);
  EXPECT_EQ(config.bodies[0].name, "block");
  ASSERT_EQ(config.bodies[0].region.size(), 1u);
  EXPECT_EQ(config.bodies[0].region[0].name, "all");
  const Material& steel = config.material(config.bodies[0].material.name);
  EXPECT_EQ(steel.young_modulus({}), 2e5);
  EXPECT_TRUE(steel.thermal_expansion.at(0).is_zero());
  EXPECT_FALSE(steel.reference_temperature);
  EXPECT_TRUE(steel.creep.empty());
  EXPECT_FALSE(config.temperature.has_value());
  EXPECT_EQ(config.contact_solver.method, ContactMethod::schwarz);
  EXPECT_FALSE(config.contact_solver.alpha.all.has_value());
  EXPECT_TRUE(config.contact_solver.alpha.of_body.empty());
  EXPECT_EQ(config.contact_solver.damping, 1.0);
  EXPECT_EQ(config.contact_solver.acceleration, Acceleration::cg);
  EXPECT_EQ(config.contact_solver.tolerance, 1e-10);
  EXPECT_EQ(config.contact_solver.max_iterations, 200);
  EXPECT_EQ(config.time.integrator, "auto");
  EXPECT_EQ(config.time.tolerance, 1e-4);
  EXPECT_EQ(config.time.output, (std::vector<double>{0, 100}));
  EXPECT_EQ(config.time.step.mode, StepMode::stable);
  EXPECT_EQ(config.time.beta, 1.0);
  EXPECT_EQ(config.time.inner_anderson, 0);
  EXPECT_EQ(config.output.directory, "cases/results/block");
  EXPECT_TRUE(config.output.fields);
}

TEST(ConfigDefaults, UnknownMaterialIsOutOfRange) {
  EXPECT_THROW(parse_text(minimal).material("gold"), std::out_of_range);
}

/// What the schema tells of a key must be what the reader does.
TEST(ConfigDefaults, SchemaListsEveryKeyWithItsDefault) {
  const std::vector<KeyInfo> keys = schema(test_vocabulary());
  const auto find = [&](const std::string& path) -> const KeyInfo& {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyInfo& key) { return key.path == path; });
    if (found == keys.end()) throw std::out_of_range(path);
    return *found;
  };
  EXPECT_EQ(find("time.integrator").default_value, "\"auto\"");
  EXPECT_EQ(find("time.step").default_value, "\"stable\"");
  EXPECT_EQ(find("time.tolerance").default_value, "0.0001");
  EXPECT_EQ(find("time.output.count").type, "an integer in [2, 100000]");
  EXPECT_EQ(find("time.inner_anderson").type, "an integer in [0, 100]");
  EXPECT_EQ(find("time.inner_anderson").default_value, "0");
  EXPECT_EQ(find("contact_solver.alpha").default_value, "\"diagonal\"");
  EXPECT_EQ(find("contact_solver.acceleration").default_value, "\"cg\"");
  EXPECT_EQ(find("contacts[].gap").default_value, "0");
  EXPECT_EQ(find("contacts[].slave").default_value, "\"auto\"");
  EXPECT_TRUE(find("bodies.<name>.region").required);
  EXPECT_TRUE(find("materials.<name>.creep[].n").required);
  EXPECT_EQ(find("materials.<name>.young_modulus").default_value, "");
  EXPECT_EQ(find("loads[].rotation.axis").default_value, "[0, 0, 1]");
  EXPECT_EQ(find("probes[].reduce").default_value, "\"mean\"");
  for (const KeyInfo& key : keys) {
    EXPECT_FALSE(key.type.empty()) << key.path;
    EXPECT_FALSE(key.description.empty()) << key.path;
  }
}

}  // namespace
}  // namespace creepcontact::config
