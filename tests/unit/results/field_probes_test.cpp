#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/results/quantities.hpp"
#include "support/run/probing.hpp"

namespace creepcontact::run::test {
namespace {

/// Linear in the place, 20 at the origin.
const std::string linear_temperature = "temperature.value=20+3*x+5*y-2*z";

class LinearField : public testing::TestWithParam<int> {
 protected:
  std::map<std::string, double> temperatures(const std::vector<ProbeTable>& probes) const {
    const Case blocks;
    return probe(blocks, probes, {linear_temperature, "mesh.order=" + std::to_string(GetParam())});
  }
  static std::vector<ProbeTable> all_reductions(const std::string& position) {
    std::vector<ProbeTable> probes;
    for (const char* reduce : {"mean", "max", "min", "sum"})
      probes.push_back({reduce, "temperature", position, reduce});
    return probes;
  }
};

TEST_P(LinearField, OnASurface) {
  expect_values(temperatures(all_reductions("on = 'top'")), {{"mean", 23.5}, {"max", 29}, {"min", 18}, {"sum", 47}},
                1e-10);
}

TEST_P(LinearField, OnASurfaceOfBothBodies) {
  // Means over x = 0: 24.5 in the lower block, of area 2, and 21.5 in the upper one, of area 1.
  expect_values(temperatures(all_reductions("on = 'symmetry_x'")),
                {{"mean", 23.5}, {"max", 29}, {"min", 18}, {"sum", 70.5}}, 1e-10);
  expect_values(temperatures(all_reductions("on = 'symmetry_x', body = 'upper'")),
                {{"mean", 21.5}, {"max", 25}, {"min", 18}, {"sum", 21.5}}, 1e-10);
}

TEST_P(LinearField, OnACurve) {
  const double n_nodes = 4.0 * GetParam() + 1;
  expect_values(temperatures(all_reductions("on = 'top_edge'")),
                {{"mean", 21}, {"max", 24}, {"min", 18}, {"sum", 21 * n_nodes}}, 1e-9);
}

TEST_P(LinearField, OnAPointGroup) {
  expect_values(temperatures(all_reductions("on = 'corner'")), {{"mean", 29}, {"max", 29}, {"min", 29}, {"sum", 29}},
                1e-10);
}

TEST_P(LinearField, OverABody) {
  // From the integration points; of the elements' size 1/2 the outermost lie this part inside:
  const double inside = 0.5 * (1 - 1 / std::sqrt(3.0));
  const double margin = inside * (3 * 0.5 + 5 * 0.5 + 2 * 0.5);
  expect_values(temperatures(all_reductions("body = 'upper'")),
                {{"mean", 24.5}, {"sum", 49}, {"max", 31 - margin}, {"min", 18 + margin}}, 1e-10);
}

TEST_P(LinearField, AtAPoint) {
  const std::map<std::string, double> found =
      temperatures({{"inside", "temperature", "at = [0.3, 0.9, -1.7]"},
                    {"on_a_node", "temperature", "at = [2, 1, 1]"},
                    {"joint_below", "temperature", "at = [0.7, 0.2, 0.0], body = 'lower'"},
                    {"joint_above", "temperature", "at = [0.7, 0.2, 0.0], body = 'upper'"}});
  expect_values(found, {{"inside", 28.8}, {"on_a_node", 29}, {"joint_below", 23.1}, {"joint_above", 23.1}}, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Order, LinearField, testing::Values(1, 2), testing::PrintToStringParamName());

TEST(FieldProbes, UniaxialCompression) {
  // A stress of -1 along z: strains -1/E and 0.3/E
  const std::string at = "at = [0.7, 0.6, -0.9]", body = "body = 'lower'";
  const auto found = probe(Case(), {{"sxx", "stress_xx", at},
                                    {"szz", "stress_zz", at},
                                    {"szx", "stress_zx", at},
                                    {"szz_mean", "stress_zz", body},
                                    {"szz_sum", "stress_zz", body, "sum"},
                                    {"q", "von_mises", at},
                                    {"first", "principal_1", at},
                                    {"second", "principal_2", at},
                                    {"third", "principal_3", at},
                                    {"mean_stress", "hydrostatic", at},
                                    {"exx", "strain_xx", at},
                                    {"eyy", "strain_yy", "on = 'side_y', body = 'lower'"},
                                    {"ezz", "strain_zz", body},
                                    {"cold", "creep_strain_zz", at},
                                    {"cold_q", "creep_strain_equivalent", body}});
  expect_values(found,
                {{"sxx", 0},
                 {"szz", -1},
                 {"szx", 0},
                 {"szz_mean", -1},
                 {"szz_sum", -4},
                 {"q", 1},
                 {"first", 0},
                 {"second", 0},
                 {"third", -1},
                 {"mean_stress", -1.0 / 3},
                 {"exx", 0.003},
                 {"eyy", 0.003},
                 {"ezz", -0.01},
                 {"cold", 0},
                 {"cold_q", 0}},
                1e-9);
}

TEST(FieldProbes, Displacements) {
  const auto found = probe(Case(), {{"x", "displacement_x", "on = 'side_x', body = 'lower'"},
                                    {"y", "displacement_y", "at = [2, 1, 1]"},
                                    {"z", "displacement_z", "at = [0.4, 0.6, -0.5]"},
                                    {"length", "displacement_magnitude", "on = 'corner'"},
                                    {"highest", "displacement_z", "body = 'lower'", "max"},
                                    {"lowest", "displacement_z", "body = 'lower'", "min"},
                                    {"mean", "displacement_z", "body = 'lower'", "mean"}});
  // Over a body, displacements are those of the nodes: here the mean of three layers of them.
  expect_values(found,
                {{"x", 2 * 0.003},
                 {"y", 0.0015},
                 {"z", -1.5 * 0.01},
                 {"length", std::hypot(2 * 0.0015, 0.0015, 0.025)},
                 {"highest", 0},
                 {"lowest", -0.02},
                 {"mean", -0.01}},
                1e-11);
}

TEST(FieldProbes, CylindricalStress) {
  // The blocks apart, sides pressed: stress_xx = -2 and nothing else, seen under the angle of the point.
  const std::string pressed = "[[loads]]\non = 'side_x'\npressure = 2\n";
  std::vector<ProbeTable> probes;
  for (const auto& [name, at] : {std::pair("45", "at = [1, 1, 0.5]"), std::pair("flat", "at = [2, 1, 0.3]"),
                                 std::pair("axis", "at = [0, 0, 0.5]"), std::pair("y", "at = [0, 1, -1]")})
    for (const char* component : {"r", "theta", "rtheta"})
      probes.push_back({std::string(component) + "_" + name, std::string("stress_") + component, at});
  const auto found = probe(Case(), probes, {"contacts.0.gap=1", "supports.3.displacement.z=0"}, pressed);
  expect_values(found,
                {{"r_45", -1},
                 {"theta_45", -1},
                 {"rtheta_45", 1},
                 {"r_flat", -1.6},
                 {"theta_flat", -0.4},
                 {"rtheta_flat", 0.8},
                 {"r_axis", -2},  // on the axis the radial direction is taken along x
                 {"theta_axis", 0},
                 {"rtheta_axis", 0},
                 {"r_y", 0},
                 {"theta_y", -2},
                 {"rtheta_y", 0}},
                1e-10);
}

TEST(FieldProbes, CylindricalStressAboutAnyAxis) {
  // As before, stress_xx = -2 alone; now about axes along y, along x, and inclined.
  const std::string pressed = "[[loads]]\non = 'side_x'\npressure = 2\n";
  std::vector<ProbeTable> probes;
  const auto add = [&](const std::string& name, const std::string& position) {
    for (const char* component : {"r", "theta", "rtheta"})
      probes.push_back({std::string(component) + '_' + name, std::string("stress_") + component, position});
  };
  add("y", "at = [1, 0.5, 0.5], axis = [0, 3, 0], origin = [0, -7, -0.5]");   // r along (1, 0, 1), theta (1, 0, -1)
  add("x", "at = [1, 0.5, 0.5], axis = [1, 0, 0]");                           // no part along r and theta
  add("45", "at = [1, 0.5, 0.5], axis = [1, 1, 0], origin = [0, 0.5, 0.5]");  // r along (1, -1, 0), theta along -z
  add("top", "on = 'corner', axis = [0, 0, -1], origin = [1, 0, 5]");         // r along (1, 1, 0), theta (1, -1, 0)
  add("body", "body = 'lower', axis = [0, 0, 1], origin = [0, 1e9, 0]");      // r along -y, theta along x
  const auto found = probe(Case(), probes, {"contacts.0.gap=1", "supports.3.displacement.z=0"}, pressed);
  expect_values(found,
                {{"r_y", -1},
                 {"theta_y", -1},
                 {"rtheta_y", -1},
                 {"r_x", 0},
                 {"theta_x", 0},
                 {"rtheta_x", 0},
                 {"r_45", -1},
                 {"theta_45", 0},
                 {"rtheta_45", 0},
                 {"r_top", -1},
                 {"theta_top", -1},
                 {"rtheta_top", -1},
                 {"r_body", 0},
                 {"theta_body", -2},
                 {"rtheta_body", 0}},
                1e-8);
}

TEST(FieldProbes, APointInTwoBodies) {
  const Case blocks;
  const auto message = [&](const std::string& position) {
    const config::Config config = blocks.parse(probe_tables({{"p", "von_mises", position}}) + case_text);
    const Model model = build_model(config);
    return message_of<ModelError>([&] { make_probes(config, model); });
  };
  EXPECT_TRUE(says(message("at = [0.7, 0.2, 0]"),
                   {"probes[0]: ", "(0.7, 0.2, 0)", "body 'lower'", "body 'upper'", "body = \"lower\""}));
  EXPECT_TRUE(says(message("at = [0.7, 0.2, 1e-5]"), {"probes[0]: ", "body 'lower'", "body 'upper'", "body = "}));
  EXPECT_EQ(message("at = [0.7, 0.2, 0], body = 'upper'"), "nothing was thrown");
  EXPECT_EQ(message("at = [0.7, 0.2, 0.01]"), "nothing was thrown");  // near the lower one, but in the upper one alone
}

TEST(FieldProbes, CreepStrainsOfTheState) {
  const Case blocks;
  const config::Config config = blocks.parse(probe_tables({{"exy", "creep_strain_xy", "body = 'lower'"},
                                                           {"ezx", "creep_strain_zx", "at = [1, 0.5, -1]"},
                                                           {"q", "creep_strain_equivalent", "on = 'bottom'"},
                                                           {"elsewhere", "creep_strain_xy", "body = 'upper'"}}) +
                                             case_text);
  System system(config);
  const auto probes = make_probes(config, system.model);
  std::vector<double> y(system.rate.size());
  Matrix3 strain;
  strain << 2, 0.5, 0.25, 0.5, -1, 0, 0.25, 0, -1;
  strain *= 1e-3;
  for (std::size_t i = 0; i < system.rate.layout().offset(1); i += 6)
    Eigen::Map<Tensor6>(y.data() + i) = tensor::from_matrix(strain);
  Snapshot snapshot(system.rate, 0, system.rate.evaluate_output(0, y));
  const double equivalent = std::sqrt(2.0 / 3.0) * strain.norm();
  const double expected[] = {0.5e-3, 0.25e-3, equivalent, 0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(probes[i]->value(snapshot), expected[i], 1e-14) << i;
}

TEST(FieldProbes, EveryQuantityHasAValueWhereItMayStand) {
  std::vector<ProbeTable> probes;
  for (const Quantity& info : quantities()) {
    const auto* multipliers = std::get_if<AtMultipliers>(&info.variable->support);
    if (multipliers != nullptr && multipliers->models == AtMultipliers::In::with_gaskets) continue;
    if (info.variable->needs_heat) continue;
    if (info.variable->is<OnCrossSection>() || info.variable->is<OnPlane>() || info.variable->is<OnSpring>())
      continue;  // need more than a place
    probes.push_back({"on_" + info.name, info.name, "on = 'lower_top'"});
    if (!info.variable->is_field()) continue;
    probes.push_back({"at_" + info.name, info.name, "at = [1, 0.5, 0.5]"});
    probes.push_back({"in_" + info.name, info.name, "body = 'upper'"});
  }
  for (const auto& [name, value] : probe(Case(), probes)) EXPECT_TRUE(std::isfinite(value)) << name;
}

TEST(FieldProbes, EveryMistakeWithItsPlace) {
  const Case blocks;
  const std::string text = probe_tables({{"a", "von_mises", "on = 'topp'"},
                                         {"b", "von_mises", "at = [1, 0.5, 9]"},
                                         {"c", "von_mises", "at = [1, 0.5, -1.9], body = 'upper'"},
                                         {"d", "contact_pressure", "on = 'side_y'"},
                                         {"e", "von_mises", "on = 'top', body = 'lower'"},
                                         {"f", "reaction_x", "on = 'bottm'"},
                                         {"g", "von_mises", "at = [1, 0.5, 0.5]"}});
  const config::Config config = blocks.parse(text + case_text);
  const Model model = build_model(config);
  const std::string message = message_of<ModelError>([&] { make_probes(config, model); });
  const std::string file = (blocks / "case.toml").string();
  EXPECT_TRUE(says(
      message, {file + ":2:3: probes[0]: ", "'topp'", "'bottom', 'lower_top', ",
                file + ":3:3: probes[1]: ", "(1, 0.5, 9)", "all bodies", file + ":4:3: probes[2]: ", "(1, 0.5, -1.9)",
                "body 'upper'", file + ":5:3: probes[3]: ", "'side_y'", "'lower_top', 'upper_bottom'",
                file + ":6:3: probes[4]: ", "'top'", "body 'lower'", file + ":7:3: probes[5]: ", "'bottm'"}));
  EXPECT_FALSE(contains(message, "probes[6]"));
}

}  // namespace
}  // namespace creepcontact::run::test
