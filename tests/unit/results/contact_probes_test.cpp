#include "support/run/probing.hpp"

namespace creepcontact::run::test {
namespace {

class ContactSides : public testing::TestWithParam<const char*> {
 protected:
  std::vector<std::string> with_slave(std::vector<std::string> overrides = {}) const {
    overrides.push_back(std::string("contacts.0.slave=") + GetParam());
    return overrides;
  }
  static std::vector<ProbeTable> probes() {
    std::vector<ProbeTable> list;
    for (const auto& [side, surface] : {std::pair("low_", "lower_top"), std::pair("up_", "upper_bottom")}) {
      const std::string on = "on = '" + std::string(surface) + "'", name = side;
      for (const char* reduce : {"mean", "max", "min", "sum"})
        list.push_back({name + reduce, "contact_pressure", on, reduce});
      list.push_back({name + "gap", "gap", on, "max"});
      list.push_back({name + "area", "contact_area", on});
      list.push_back({name + "force_x", "contact_force_x", on});
      list.push_back({name + "force_z", "contact_force_z", on});
    }
    for (const char* held : {"bottom", "top"})
      list.push_back({std::string("reaction_") + held, "reaction_z", "on = '" + std::string(held) + "'"});
    list.push_back({"reaction_side", "reaction_x", "on = 'symmetry_x'"});
    return list;
  }
  /// Pressure p on the area 2, or a gap.
  static std::map<std::string, double> expected(double p, double gap) {
    std::map<std::string, double> values{{"reaction_bottom", 2 * p}, {"reaction_top", -2 * p}, {"reaction_side", 0}};
    for (const std::string side : {"low_", "up_"}) {
      for (const char* reduce : {"mean", "max", "min"}) values[side + reduce] = p;
      values[side + "sum"] = 2 * p;
      values[side + "gap"] = gap;
      values[side + "area"] = gap > 0 ? 0 : 2;
      values[side + "force_x"] = 0;
      values[side + "force_z"] = side == "low_" ? -2 * p : 2 * p;
    }
    return values;
  }
};

TEST_P(ContactSides, Pressed) {
  expect_values(probe(Case(), probes(), with_slave()), expected(1, 0), 1e-9);
}

TEST_P(ContactSides, PressedByInterference) {
  expect_values(probe(Case(), probes(), with_slave({"contacts.0.gap=-0.05", "supports.3.displacement.z=0"})),
                expected(2, 0), 1e-9);
}

TEST_P(ContactSides, Open) {
  expect_values(probe(Case(), probes(), with_slave({"contacts.0.gap=0.003", "supports.3.displacement.z=0.005"}),
                      // something that keeps the model from being without any load
                      "[[loads]]\nbody = 'lower'\nbody_force = ['t > 1 ? 1 : 0', 0, 0]\n"),
                expected(0, 0.008), 1e-9);
}

TEST_P(ContactSides, TiedInTension) {
  // One material: else the ties would keep the blocks from contracting alike.
  expect_values(
      probe(Case(), probes(),
            with_slave({"contacts.0.type=tied", "bodies.upper.material=soft", "supports.3.displacement.z=0.03"})),
      expected(-1, 0), 1e-9);
}

TEST_P(ContactSides, SharedNodes) {
  expect_values(probe(Case(joined_blocks()), probes(), with_slave()), expected(1, 0), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Slave, ContactSides, testing::Values("lower_top", "upper_bottom"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(ContactProbes, PartlyOpen) {
  const auto found = probe(Case(),
                           {{"area", "contact_area", "on = 'lower_top'"},
                            {"force", "contact_force_z", "on = 'upper_bottom'"},
                            {"sum", "contact_pressure", "on = 'lower_top'", "sum"},
                            {"most", "contact_pressure", "on = 'lower_top'", "max"},
                            {"least", "contact_pressure", "on = 'upper_bottom'", "min"},
                            {"widest", "gap", "on = 'upper_bottom'", "max"},
                            {"closest", "gap", "on = 'lower_top'", "min"},
                            {"reaction", "reaction_z", "on = 'bottom'"}},
                           {"contacts.0.gap=0.03*x-0.01", "supports.3.displacement.z=-0.01"});
  EXPECT_GT(found.at("area"), 0.2);
  EXPECT_LT(found.at("area"), 1.8);
  EXPECT_EQ(found.at("least"), 0);
  EXPECT_GT(found.at("most"), 0.1);
  EXPECT_NEAR(found.at("closest"), 0, 1e-12);
  EXPECT_GT(found.at("widest"), 0.02);
  EXPECT_GT(found.at("force"), 0.05);
  EXPECT_NEAR(found.at("sum"), found.at("force"), 1e-9);
  EXPECT_NEAR(found.at("reaction"), found.at("force"), 1e-9);
}

TEST(ContactProbes, ReactionsBalanceTheLoads) {
  const std::string loads =
      "[[loads]]\non = 'side_x'\npressure = '1+z*z'\n"
      "[[loads]]\nat = [2, 1, 1]\nforce = [0, 0.5, 0]\n"
      "[[loads]]\nbody = 'upper'\nbody_force = [0, 0, -0.25]\n";
  const auto found = probe(Case(),
                           {{"x", "reaction_x", "on = 'symmetry_x'"},
                            {"y", "reaction_y", "on = 'symmetry_y'"},
                            {"bottom", "reaction_z", "on = 'bottom'"},
                            {"top", "reaction_z", "on = 'top'"}},
                           {"mesh.order=2"}, loads);
  // integral of 1 + z^2 over -2 < z < 1, the width is 1
  EXPECT_NEAR(found.at("x"), 3 + 9.0 / 3, 1e-9);
  EXPECT_NEAR(found.at("y"), -0.5, 1e-9);
  EXPECT_NEAR(found.at("bottom") + found.at("top"), 0.25 * 2, 1e-9);
}

}  // namespace
}  // namespace creepcontact::run::test
