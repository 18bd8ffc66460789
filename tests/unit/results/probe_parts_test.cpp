/// Probes on parts of groups and bodies: `where`, and surfaces that are part of a contact surface.

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/run/probing.hpp"

namespace creepcontact::run::test {
namespace {

/// As separate_blocks(), but the lower block consists of two halves, and the upper one is 0.1 above. The groups "left"
/// and "right" are the halves of the lower top, "upper_wide" the upper bottom and the top together.
std::string halved_blocks() {
  std::string own = groups;
  own.replace(own.find("{1}"), 3, "{1, 3}");
  for (const char* from : {"1 - e, 9, 9, 1 + e", "-e, -e, 1 - e, 9, e, 1 + e", "2 - e, 1 - e, 1 - e"})
    while (own.find(from) != std::string::npos) {
      std::string to = from;
      const std::size_t z = to.rfind("1 - e");
      to.replace(z, 5, "1.1 - e");
      if (to.find("1 + e") != std::string::npos) to.replace(to.rfind("1 + e"), 5, "1.1 + e");
      own.replace(own.find(from), std::string(from).size(), to);
    }
  return R"(SetFactory("OpenCASCADE");
e = 1e-3;
Box(1) = {0, 0, -2, 1, 1, 2};
Box(3) = {1, 0, -2, 1, 1, 2};
BooleanFragments{ Volume{1}; Delete; }{ Volume{3}; Delete; }
Box(2) = {0, 0, 0.1, 2, 1, 1};
Transfinite Curve{:} = 3;
Transfinite Surface{:};
Recombine Surface{:};
Transfinite Volume{:};
Physical Surface("lower_top") = Surface In BoundingBox{-e, -e, -e, 9, 9, e};
Physical Surface("left") = Surface In BoundingBox{-e, -e, -e, 1 + e, 9, e};
Physical Surface("right") = Surface In BoundingBox{1 - e, -e, -e, 9, 9, e};
Physical Surface("upper_bottom") = Surface In BoundingBox{-e, -e, 0.1 - e, 9, 9, 0.1 + e};
)" + own;
}

class ContactParts : public testing::TestWithParam<const char*> {
 protected:
  std::map<std::string, double> values(const std::vector<ProbeTable>& probes, const std::string& gap = "0") const {
    return probe(Case(halved_blocks()), probes,
                 {std::string("contacts.0.slave=") + GetParam(), "contacts.0.gap='" + gap + "'"});
  }
};

TEST_P(ContactParts, OfUniformPressure) {
  // Pressure 1 / 1: each half of area 1 carries 1.
  std::map<std::string, double> expected;
  std::vector<ProbeTable> probes;
  const std::vector<std::pair<std::string, std::string>> places{{"right", "on = 'right'"},
                                                                {"left", "on = 'left'"},
                                                                {"where_low", "on = 'lower_top', where = 'x > 1'"},
                                                                {"where_up", "on = 'upper_bottom', where = 'x > 1'"}};
  for (const auto& [name, position] : places) {
    const double sign = name == "where_up" ? 1 : -1;
    for (const auto& [quantity, reduce, value] :
         {std::tuple("contact_pressure", "mean", 1.0), std::tuple("contact_pressure", "max", 1.0),
          std::tuple("contact_pressure", "min", 1.0), std::tuple("contact_pressure", "sum", 1.0),
          std::tuple("contact_area", "sum", 1.0), std::tuple("contact_force_z", "sum", sign)}) {
      const std::string key = name + "_" + quantity + "_" + reduce;
      probes.push_back({key, quantity, position, reduce});
      expected[key] = value;
    }
  }
  expect_values(values(probes), expected, 1e-9);
}

TEST_P(ContactParts, AddUpToTheWhole) {
  std::vector<ProbeTable> probes;
  for (const auto& [name, position] :
       std::vector<std::pair<std::string, std::string>>{{"whole", "on = 'lower_top'"},
                                                        {"left", "on = 'left'"},
                                                        {"right", "on = 'right'"},
                                                        {"near", "on = 'upper_bottom', where = 'x < 0.7'"},
                                                        {"far", "on = 'upper_bottom', where = 'x >= 0.7'"},
                                                        {"up", "on = 'upper_bottom'"}}) {
    probes.push_back({name + "_force", "contact_force_z", position});
    probes.push_back({name + "_moment", "contact_moment_y", position});
    probes.push_back({name + "_pressure", "contact_pressure", position, "sum"});
  }
  const auto found = values(probes, "0.01*x");
  for (const std::string quantity : {"_force", "_moment", "_pressure"}) {
    const double whole = found.at("whole" + quantity), up = found.at("up" + quantity);
    EXPECT_GT(std::abs(whole), 0.1) << quantity;
    EXPECT_NEAR(found.at("left" + quantity) + found.at("right" + quantity), whole, 1e-12 * std::abs(whole)) << quantity;
    EXPECT_NEAR(found.at("near" + quantity) + found.at("far" + quantity), up, 1e-12 * std::abs(up)) << quantity;
    EXPECT_GT(std::abs(found.at("left" + quantity) / found.at("right" + quantity) - 1), 0.2) << quantity;
  }
}

INSTANTIATE_TEST_SUITE_P(Slave, ContactParts, testing::Values("lower_top", "upper_bottom"),
                         [](const auto& tested) { return std::string(tested.param); });

const std::string linear_field = "temperature.value=20+3*x+5*y-2*z";

TEST(ProbeParts, OfASurfaceACurveAndABody) {
  // The planes x = 1 and z = -1 lie between elements of the blocks, of 4 and of 2.
  const auto found = probe(Case(),
                           {{"mean", "temperature", "on = 'top', where = 'x > 1'", "mean"},
                            {"sum", "temperature", "on = 'top', where = 'x > 1'", "sum"},
                            {"max", "temperature", "on = 'top', where = 'x < 1.1'", "max"},
                            {"min", "temperature", "on = 'top', where = 'x*x + y*y > 3.9'", "min"},
                            {"curve", "temperature", "on = 'top_edge', where = 'x >= 1'", "min"},
                            {"body", "temperature", "body = 'upper', where = 'x > 1'", "mean"},
                            {"volume", "temperature", "body = 'upper', where = 'x > 1 && y < 0.5'", "sum"},
                            {"reaction", "reaction_z", "on = 'top', where = 'x > 5 || y >= 0'"}},
                           {linear_field, "mesh.order=2"});
  expect_values(found,
                {{"mean", 25},
                 {"sum", 25},
                 {"max", 26},
                 {"min", 24},
                 {"curve", 21},
                 {"body", 26},
                 {"volume", 0.5 * 24.75},
                 {"reaction", -2}},
                1e-9);
}

TEST(ProbeParts, ThatAreEmptyAreErrors) {
  const Case blocks;
  for (const char* place :
       {"quantity = 'temperature', on = 'top'", "quantity = 'von_mises', body = 'lower'",
        "quantity = 'contact_pressure', on = 'lower_top'", "quantity = 'contact_area', on = 'upper_bottom'",
        "quantity = 'contact_pressure', reduce = 'min', on = 'lower_top'", "quantity = 'reaction_z', on = 'top'",
        "quantity = 'displacement_x', body = 'upper'"}) {
    const std::string table = std::string("probes = [{ name = 'a', where = 'x > 7', ") + place + " }]\n";
    const config::Config config = blocks.parse(table + case_text);
    const Model model = build_model(config);
    const std::string message = message_of<ModelError>([&] { make_probes(config, model); });
    EXPECT_TRUE(says(message, {"case.toml:1:11: probes[0]: where: 'x > 7'"}));
  }
}

TEST(ProbeParts, ASurfaceThatTouchesNoContact) {
  const Case blocks;
  const config::Config config =
      blocks.parse("probes = [{ name = 'a', quantity = 'contact_area', on = 'top' }]\n" + case_text);
  const Model model = build_model(config);
  EXPECT_TRUE(says(message_of<ModelError>([&] { make_probes(config, model); }),
                   {"probes[0]: ", "surface 'top'", "contact", "'lower_top', 'upper_bottom'"}));
}

TEST(ProbeExpressions, OfOtherProbesInAnyOrder) {
  const Case blocks;
  const config::Config config = blocks.parse(R"(probes = [
  { name = "torque", expression = "0.12*force*0.06 + 0*t", unit = "N mm" },
  { name = "twice", expression = "2*torque + t", scale = 10 },
  { name = "force", quantity = "contact_force_z", on = "upper_bottom", scale = 1e3 },
  { name = "holds", expression = "force > 1999 && torque < 1000" },
]
)" + case_text);
  System system(config);
  const auto made = make_probes(config, system.model);
  const std::vector<double> y(system.rate.size());
  Snapshot snapshot(system.rate, 0.5, system.rate.evaluate_output(0.5, y));
  const double torque = 0.12 * 2000 * 0.06;
  EXPECT_NEAR(made[0]->value(snapshot), torque, 1e-9);
  EXPECT_NEAR(made[1]->value(snapshot), 10 * (2 * torque + 0.5), 1e-8);
  EXPECT_NEAR(made[2]->value(snapshot), 2000, 1e-7);
  EXPECT_EQ(made[3]->value(snapshot), 1);
}

}  // namespace
}  // namespace creepcontact::run::test
