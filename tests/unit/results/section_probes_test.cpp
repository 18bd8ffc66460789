/// Forces and moments on planes through bodies, against statics. Section of the blocks: 2 x 1, z from -2 to 1.

#include <cmath>
#include <numbers>

#include "creepcontact/base/error.hpp"
#include "support/run/probing.hpp"

namespace creepcontact::run::test {
namespace {

using std::numbers::pi;

std::string plane(const std::string& body, double z, int normal = 1) {
  return "body = '" + body + "', section = { origin = [0, 0, " + std::to_string(z) + "], normal = [0, 0, " +
         std::to_string(normal) + "] }";
}

/// On element faces, through elements, and at the ends of the bodies.
const std::vector<std::pair<std::string, double>> heights{{"lower", -2},   {"lower", -1.7}, {"lower", -1},
                                                          {"lower", -0.2}, {"lower", 0},    {"upper", 0},
                                                          {"upper", 0.31}, {"upper", 0.5},  {"upper", 1}};

/// The bottom is held in all directions, and the blocks are tied; what loads them is given by `more`.
std::string clamped(const std::string& more) {
  std::string text = case_text;
  text.erase(text.find("[[supports]]"), text.find("[[contacts]]") - text.find("[[supports]]"));
  text.insert(text.find("gap = 0"), "type = 'tied'\n");
  return text + "[[supports]]\non = 'bottom'\ndisplacement = { x = 0, y = 0, z = 0 }\n" + more;
}

std::map<std::string, double> values_of(const std::string& text, const std::vector<ProbeTable>& probes, int order,
                                        double t = 0) {
  const Case blocks;
  const config::Config config = blocks.parse(probe_tables(probes) + text, {"mesh.order=" + std::to_string(order)});
  System system(config);
  const auto made = make_probes(config, system.model);
  const std::vector<double> y(system.rate.size());
  Snapshot snapshot(system.rate, t, system.rate.evaluate_output(t, y));
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < made.size(); ++i) values[config.probes[i].name] = made[i]->value(snapshot);
  return values;
}

class SectionProbes : public testing::TestWithParam<int> {
 protected:
  /// The quantity at all heights, on both sides; @param expected  of the height
  template <typename Expected>
  void expect(const std::string& text, const std::string& quantity, double tolerance, const Expected& expected) const {
    const std::string about = quantity.find("moment") == std::string::npos ? "" : ", origin = [0, 0, 0]";
    std::vector<ProbeTable> probes;
    for (const auto& [body, z] : heights)
      for (const int normal : {1, -1})
        probes.push_back(
            {body + std::to_string(z) + "/" + std::to_string(normal), quantity, plane(body, z, normal) + about});
    const auto found = values_of(text, probes, GetParam());
    for (const auto& [body, z] : heights)
      for (const int normal : {1, -1}) {
        const std::string name = body + std::to_string(z) + "/" + std::to_string(normal);
        EXPECT_NEAR(found.at(name), normal * expected(z), tolerance) << quantity << " " << name;
      }
  }
};

TEST_P(SectionProbes, PressedBlocks) {
  // Pressure 1 on the area 2, through contact between meshes that do not match.
  expect(case_text, "section_force_z", 1e-9, [](double) { return -2; });
  expect(case_text, "section_force_x", 1e-9, [](double) { return 0; });
  expect(case_text, "section_moment_y", 1e-9, [](double) { return 2; });   // -x F_z at x = 1
  expect(case_text, "section_moment_x", 1e-9, [](double) { return -1; });  // y F_z at y = 1/2
}

TEST_P(SectionProbes, Cantilever) {
  const std::string text = clamped("[[loads]]\non = 'top'\ntraction = [0.5, 0, 0.25]\n");
  // Forces 1 and 0.5 act at (1, 0.5, 1).
  expect(text, "section_force_x", 1e-9, [](double) { return 1; });
  expect(text, "section_force_z", 1e-9, [](double) { return 0.5; });
  expect(text, "section_moment_x", 1e-9, [](double) { return 0.25; });
  expect(text, "section_moment_y", 1e-9, [](double) { return 1.0 - 0.5; });
  expect(text, "section_moment_z", 1e-9, [](double) { return -0.5; });
}

TEST_P(SectionProbes, BendingMomentAboutTheSection) {
  std::vector<ProbeTable> probes;
  for (const auto& [body, z] : heights)
    probes.push_back({body + std::to_string(z), "section_moment_y", plane(body, z)});
  const auto found = values_of(clamped("[[loads]]\non = 'top'\ntraction = [0.5, 0, 0]\n"), probes, GetParam());
  for (const auto& [body, z] : heights) EXPECT_NEAR(found.at(body + std::to_string(z)), 1 - z, 1e-9) << z;
}

TEST_P(SectionProbes, RotatingBar) {
  // About an axis through the clamped end: rho omega^2 A (L^2 - r^2) / 2 with r = z + 2, L = 3, A = 2.
  std::string loads;
  for (const char* body : {"lower", "upper"})
    loads += std::string("[[loads]]\nbody = '") + body +
             "'\nrotation = { axis = [0, 1, 0], origin = [1, 0, -2], angular_velocity = 3, density = 0.01 }\n";
  expect(clamped(loads), "section_force_z", 1e-9, [](double z) { return 0.01 * 9 * 2 * (9 - (z + 2) * (z + 2)) / 2; });
}

TEST_P(SectionProbes, LoadsOnCutSurfaces) {
  // Pressure that grows along the side of the blocks, and gravity.
  const std::string text = clamped(
      "[[loads]]\non = 'side_x'\npressure = '0.1*(z + 2)'\n[[loads]]\nbody = 'lower'\nbody_force = [0, 0, -0.2]\n"
      "[[loads]]\nbody = 'upper'\nbody_force = [0, 0, -0.2]\n");
  expect(text, "section_force_x", 1e-9, [](double z) { return -0.05 * (9 - (z + 2) * (z + 2)); });
  expect(text, "section_force_z", 1e-9, [](double z) { return -0.2 * 2 * (1 - z); });
}

TEST_P(SectionProbes, PointForceAndObliquePlane) {
  const std::string text = clamped("[[loads]]\nat = [2, 1, 1]\nforce = [0.1, 0.2, 0.3]\n");
  std::vector<ProbeTable> probes;
  for (const char* component : {"x", "y", "z"})
    probes.push_back({component, std::string("section_force_") + component,
                      "body = 'lower', section = { origin = [1, 0.5, -1], normal = [0.2, 0.1, 0.9] }"});
  expect_values(values_of(text, probes, GetParam()), {{"x", 0.1}, {"y", 0.2}, {"z", 0.3}}, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Order, SectionProbes, testing::Values(1, 2), testing::PrintToStringParamName());

const std::string rectangle = R"(SetFactory("OpenCASCADE");
Rectangle(1) = {1, 0, 0, 1, 3};
Transfinite Curve{:} = 4;
Transfinite Surface{1};
Recombine Surface{1};
Physical Surface("ring") = {1};
Physical Curve("bottom") = {1};
Physical Curve("inside") = {4};
Physical Curve("top") = {3};
)";

std::string section_case(const std::string& analysis, const std::string& mesh, const std::string& more) {
  return "analysis = '" + analysis + "'\n[mesh]\nfile = 'blocks.geo'\norder = 2\n" + mesh +
         "[bodies.ring]\nregion = 'ring'\nmaterial = 'steel'\n[materials.steel]\nyoung_modulus = 100\npoisson_ratio = "
         "0.3\n[time]\nend = 1\n[[supports]]\non = 'bottom'\ndisplacement = { x = 0, y = 0 }\n" +
         more;
}

std::map<std::string, double> section_values(const std::string& text, const std::vector<ProbeTable>& probes) {
  const Case files(rectangle);
  const config::Config config = files.parse(probe_tables(probes) + text);
  System system(config);
  const auto made = make_probes(config, system.model);
  Snapshot snapshot(system.rate, 0, system.rate.evaluate_output(0, {}));
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < made.size(); ++i) values[config.probes[i].name] = made[i]->value(snapshot);
  return values;
}

TEST(SectionsOfSections, FullCircumference) {
  const auto found = section_values(
      section_case("axisymmetric", "",
                   "[[loads]]\non = 'top'\ntraction = [0, 10, 0]\n[[loads]]\nbody = 'ring'\nbody_force = [0, -0.5, "
                   "0]\n[[loads]]\non = 'inside'\npressure = 3\n"),
      {{"through", "section_force_y", "body = 'ring', section = { origin = [0, 1.3, 0], normal = [0, 1, 0] }"},
       {"back", "section_force_y", "body = 'ring', section = { origin = [0, 1.3, 0], normal = [0, -2, 0] }"},
       {"between", "section_force_y", "body = 'ring', section = { origin = [0, 1, 0], normal = [0, 1, 0] }"},
       {"bottom", "section_force_y", "body = 'ring', section = { origin = [0, 0, 0], normal = [0, 1, 0] }"}});
  const double area = 3 * pi;
  expect_values(found,
                {{"through", area * (10 - 0.5 * 1.7)},
                 {"back", -area * (10 - 0.5 * 1.7)},
                 {"between", area * (10 - 0.5 * 2)},
                 {"bottom", area * (10 - 0.5 * 3)}},
                1e-8);
}

TEST(SectionsOfSections, PlanesOfAThickness) {
  for (const char* analysis : {"plane_strain", "plane_stress", "generalized_plane_strain"}) {
    const std::string at = "body = 'ring', section = { origin = [1.5, 1.3, 0], normal = [0, 1, 0] }";
    const auto found = section_values(
        section_case(analysis, "thickness = 4\n",
                     "[[loads]]\non = 'top'\ntraction = [1, 10, 0]\n[[loads]]\non = 'inside'\npressure = 3\n"),
        {{"x", "section_force_x", at}, {"y", "section_force_y", at}, {"moment", "section_moment_z", at}});
    expect_values(found, {{"x", 4 * (1 + 3 * 1.7)}, {"y", 40}, {"moment", 4 * (-1 * 1.7 - 3 * 1.7 * 0.85)}}, 1e-8);
  }
}

std::string section_mistake(const std::string& text, const std::string& probe, const std::string& geometry) {
  const Case files(geometry);
  return message_of<Error>([&] {
    const config::Config config = files.parse("probes = [{ name = 'a', " + probe + " }]\n" + text);
    make_probes(config, build_model(config));
  });
}

TEST(SectionProbeMistakes, APlaneThatMisses) {
  const std::string message =
      section_mistake(case_text, "quantity = 'section_force_z', " + plane("lower", 0.2), separate_blocks());
  EXPECT_TRUE(
      says(message, {"case.toml:1:11: probes[0]: section: ", "(0, 0, 0.2)", "(0, 0, 1)", "(0, 0, -2)", "(2, 1, 0)"}));
}

TEST(SectionProbeMistakes, InTheConfiguration) {
  const std::string ring = section_case("axisymmetric", "", "");
  struct Mistake {
    std::string text, probe;
    std::vector<std::string_view> facts;
  };
  const std::vector<Mistake> mistakes{
      {case_text, "quantity = 'section_force_z', body = 'lower'", {"probes[0]: ", "'section_force_z'", "'section'"}},
      {case_text,
       "quantity = 'section_force_z', section = { origin = [0, 0, 0], normal = [0, 0, 1] }",
       {"probes[0]: ", "'on'", "'at'", "'body'"}},
      {case_text, "quantity = 'von_mises', " + plane("lower", -1), {"probes[0].section: ", "'von_mises'"}},
      {case_text,
       "quantity = 'section_force_z', body = 'lower', section = { origin = [0, 0, -1], normal = [0, 0, 0] }",
       {"probes[0].section.normal: ", "[0, 0, 0]"}},
      {case_text,
       "quantity = 'section_force_z', where = 'x > 1', " + plane("lower", -1),
       {"probes[0].where: ", "'section_force_z'"}},
      {ring,
       "quantity = 'section_force_y', body = 'ring', section = { origin = [0, 1, 0], normal = [1, 0, 0] }",
       {"probes[0].section.normal: ", "[0, 1, 0]"}},
      {ring,
       "quantity = 'section_force_x', body = 'ring', section = { origin = [0, 1, 0], normal = [0, 1, 0] }",
       {"probes[0].quantity: ", "'section_force_x'", "section_force_y"}}};
  for (const auto& [text, probe, facts] : mistakes) {
    const std::string message = section_mistake(text, probe, text == ring ? rectangle : separate_blocks());
    EXPECT_TRUE(says(message, facts)) << probe;
  }
}

}  // namespace
}  // namespace creepcontact::run::test
