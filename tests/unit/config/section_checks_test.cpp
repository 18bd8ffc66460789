/// Keys that a section gives another meaning, or none.
#include "support/says.hpp"
#include "unit/config/config_fixture.hpp"

namespace creepcontact::config {
namespace {

std::string with(const std::string& analysis, const std::string& more = "") {
  return "analysis = \"" + analysis + "\"\n" + minimal + more;
}

/// The only mistake names the place and then the fact.
void expect_fact(const std::string& text, const std::string& place, const std::string& fact) {
  const std::vector<std::string> lines = mistakes(text);
  ASSERT_EQ(lines.size(), 1u) << text;
  EXPECT_TRUE(test::says(lines[0], {": " + place + ": ", fact}));
}

TEST(SectionChecks, EveryAnalysisIsRead) {
  for (const auto& [name, value] : names_of(settings::Analysis{}))
    EXPECT_EQ(parse_text(with(std::string(name))).analysis, value);
  EXPECT_EQ(parse_text(minimal).analysis, settings::Analysis::solid);
}

TEST(SectionChecks, KeysWithoutMeaning) {
  const auto thickness = [](const std::string& analysis) {
    std::string text = with(analysis);
    text.insert(text.find("region"), "thickness = 2\n");
    return text;
  };
  const auto mesh_thickness = [](const std::string& analysis) {
    std::string text = with(analysis);
    text.insert(text.find("file"), "thickness = 2\n");
    return text;
  };
  EXPECT_EQ(parse_text(mesh_thickness("plane_strain")).mesh.thickness, 2);
  expect_fact(mesh_thickness("axisymmetric"), "mesh.thickness", "axisymmetric");
  expect_fact(mesh_thickness("solid"), "mesh.thickness", "solid");
  EXPECT_EQ(parse_text(thickness("plane_stress")).bodies[0].thickness, 2);
  expect_fact(thickness("plane_strain"), "bodies.block.thickness", "mesh.thickness");
  expect_fact(with("plane_strain", "[generalized_plane_strain]\nforce = 1\n"), "generalized_plane_strain",
              "generalized_plane_strain");
  expect_fact(with("generalized_plane_strain", "[generalized_plane_strain]\nforce = 1\nstrain = 0\n"),
              "generalized_plane_strain", "'strain' and 'force'");
  expect_fact(with("generalized_plane_strain", "[generalized_plane_strain]\nforce = 1\nper_body = true\n"),
              "generalized_plane_strain.force", "'per_body = true'");
  expect_fact(with("generalized_plane_strain", "[generalized_plane_strain]\nstrain = 1\nper_body = true\n"),
              "generalized_plane_strain.per_body", "'per_body' with a 'strain'");
  const auto axial_force = [](const std::string& analysis, const std::string& more) {
    std::string text = with(analysis, more);
    text.insert(text.find("region"), "axial_force = 2\n");
    return text;
  };
  EXPECT_TRUE(parse_text(axial_force("generalized_plane_strain", "[generalized_plane_strain]\nper_body = true\n"))
                  .bodies[0]
                  .axial_force);
  expect_fact(axial_force("generalized_plane_strain", ""), "bodies.block.axial_force",
              "generalized_plane_strain.per_body = true");
  expect_fact(axial_force("plane_stress", ""), "bodies.block.axial_force", "generalized_plane_strain.per_body = true");
}

TEST(SectionChecks, OnlyRingsAreRevolved) {
  EXPECT_EQ(parse_text(with("axisymmetric", "[output]\nrevolve = 24\n")).output.revolve, 24);
  expect_fact(with("plane_strain", "[output]\nrevolve = 24\n"), "output.revolve", "axisymmetric");
}

TEST(SectionChecks, ComponentsOutOfThePlane) {
  expect_fact(with("axisymmetric", "[[supports]]\non = \"a\"\ndisplacement = { z = 0 }\n"),
              "supports[0].displacement.z", "axisymmetric");
  expect_fact(with("plane_strain", "[[loads]]\non = \"a\"\ntraction = [0, 1, 2]\n"), "loads[0].traction", "z = 0");
  expect_fact(with("plane_strain", "[[loads]]\nat = [0, 1, 2]\nforce = [0, 1, 0]\n"), "loads[0].at", "z = 0");
  expect_fact(with("plane_strain", "[[loads]]\nbody = \"block\"\nbody_force = [0, 1, \"t\"]\n"), "loads[0].body_force",
              "z = 0");
}

TEST(SectionChecks, AxesOfRevolution) {
  const std::string load = "[[loads]]\nbody = \"block\"\nrotation = { angular_velocity = 1, density = 1";
  expect_fact(with("axisymmetric", load + ", axis = [1, 0, 0] }\n"), "loads[0].rotation.axis", "[0, 1, 0]");
  expect_fact(with("axisymmetric", load + ", origin = [1, 0, 0] }\n"), "loads[0].rotation.origin", "x = 0");
  expect_fact(with("plane_stress", load + ", axis = [0, 1, 1] }\n"), "loads[0].rotation.axis", "[0, 0, 1]");
  const Config ring = parse_text(with("axisymmetric", load + " }\n"));
  EXPECT_EQ(std::get<Rotation>(ring.loads[0].kind).axis, (std::array<double, 3>{0, 1, 0}));
  const Config plate = parse_text(with("plane_stress", load + " }\n"));
  EXPECT_EQ(std::get<Rotation>(plate.loads[0].kind).axis, (std::array<double, 3>{0, 0, 1}));
}

}  // namespace
}  // namespace creepcontact::config
