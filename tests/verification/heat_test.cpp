/// Computed temperatures in runs: what they do to bodies, contacts, sectors; against closed forms and given fields.

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "support/says.hpp"
#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/interrupted.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace heat_tests {
namespace {

using namespace test;

/// Two boxes of 1 x 1 x 1 above each other that do not match.
const std::string geo =
    boxes_geo({{"low", {0, 0, 0}, {1, 1, 1}, {2, 2, 4}}, {"high", {0, 0, 1}, {1, 1, 1}, {3, 3, 4}}});

std::string conducting(const std::string& name, double conductivity, double A = 0) {
  const std::string heat = fmt::format(
      "conductivity = {}\nheat_capacity = 1\ndensity = 1\nthermal_expansion = 1e-5\nreference_temperature = 0\n",
      conductivity);
  std::string toml = body(name, 1e5, 0.3, A, 5);
  const std::string before = "poisson_ratio = 0.3\n";
  return toml.insert(toml.find(before) + before.size(), heat);
}

std::string supports() {
  std::string toml;
  for (const std::string name : {"low", "high"}) toml += support(name + "_x0", "x") + support(name + "_y0", "y");
  return toml + support("low_z0", "z");
}

/// @param heat  keys of [heat] @param contact  of the contact @param rest  [time] and what follows
std::string stack(const std::string& heat, const std::string& contact, const std::string& rest, double A = 0) {
  return "[mesh]\nfile = \"case.geo\"\norder = 2\n" + conducting("low", 1, A) + conducting("high", 3, A) + "[heat]\n" +
         heat + "\n" + contact_table("low_z1", "high_z0", contact) + supports() + support("high_z1", "z") + rest;
}

std::string temperature(const std::string& name, double z, const std::string& body) {
  return probe(name, "temperature", fmt::format("at = [0, 0, {}]\nbody = \"{}\"", z, body));
}
const std::string probes = temperature("bottom", 0, "low") + temperature("below", 1, "low") +
                           temperature("above", 1, "high") + temperature("top", 2, "high");
const std::string ends = "temperatures = [{ on = \"low_z0\", value = 100 }, { on = \"high_z1\", value = \"10*t\" }]\n";
const std::string held =
    "start = \"steady\"\ntemperatures = [{ on = \"low_z0\", value = 100 }, { on = \"high_z1\", value = 0 }]\n";

TEST(Heat, CrossesAContactByItsConductance) {
  const Table history = run_case(stack(held, "conductance = 2", "[time]\nend = 1\n" + probes), geo).history;
  const double q = 100 / (1 + 0.5 + 1.0 / 3);
  EXPECT_NEAR(history.at("below", 0), 100 - q, 1e-9);
  EXPECT_NEAR(history.at("above", 0), q / 3, 1e-9);
  const Table tied = run_case(stack(held, "type = \"tied\"", "[time]\nend = 1\n" + probes), geo).history;
  EXPECT_NEAR(tied.at("below", 0), 25, 0.05);
  EXPECT_NEAR(tied.at("above", 0), 25, 0.05);
  const Table insulated =
      run_case(stack(held, "conductance = \"insulated\"", "[time]\nend = 1\n" + probes), geo).history;
  EXPECT_NEAR(insulated.at("below", 0), 100, 1e-9);
  EXPECT_NEAR(insulated.at("above", 0), 0, 1e-9);
}

/// The heated stack presses against the walls: in contact the stress is that of the mean temperature, and so is its
/// relaxation.
TEST(Heat, DrivesStressAndCreepAsTheSameFieldDoes) {
  const std::string rest = "[time]\nend = 100\noutput = [1, 10]\n" + probe("force", "reaction_z", "on = \"low_z0\"");
  const Table computed = run_case(stack(held, "conductance = 2", rest, 1e-14), geo).history;
  // low: 100 - q z; high: q/3 (2 - z), q = 54.545...
  std::string given = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + conducting("low", 1, 1e-14) +
                      conducting("high", 3, 1e-14) +
                      "[temperature]\nvalue = \"z < 1 ? 100 - 600/11*z : 200/11*(2 - z)\"\n" +
                      contact_table("low_z1", "high_z0") + supports() + support("high_z1", "z") + rest;
  const Table field = run_case(given, geo).history;
  for (const double t : {0.0, 1.0, 10.0, 100.0})
    EXPECT_NEAR(computed.at("force", t), field.at("force", t), 1e-4 * std::abs(field.at("force", 0))) << t;
}

/// A stiffness that changes by 2 % is solved with the factors of the start, as with a field that is given.
TEST(Heat, DoesNotFactorizeTheStiffnessInEveryStep) {
  std::string toml =
      stack("start = 100\ntime_unit = 1\n" + ends, "conductance = 2", "[time]\nend = 10\noutput = [1, 2, 5]\n", 1e-14);
  for (std::size_t at; (at = toml.find("young_modulus = 1e5")) != std::string::npos ||
                       (at = toml.find("young_modulus = 100000")) != std::string::npos;)
    toml.replace(at, toml.find('\n', at) - at, "young_modulus = { T = [0, 100], values = [1.02e5, 1e5] }");
  const Outcome outcome = run_case(toml, geo);
  EXPECT_GT(outcome.summary.number("elastic_solves"), 5);
  EXPECT_EQ(outcome.summary.number("factorizations"), 2) << "one per body";
}

/// A slab that a film heats from one side: the closed form at Bi = 0.5, Fo = 0.5, with t in hours and data per second.
TEST(Heat, OverTheTimeInHours) {
  const std::string slab = boxes_geo({{"slab", {0, 0, 0}, {1, 1, 1}, {2, 2, 6}}});
  std::string toml =
      "[mesh]\nfile = \"case.geo\"\norder = 2\n" + conducting("slab", 1) +
      "[heat]\nstart = 20\ntime_unit = 3600\nfilms = [{ on = \"slab_z0\", coefficient = 0.5, fluid = 120 }]\n" +
      support("slab_x0", "x") + support("slab_y0", "y") + support("slab_z0", "z");
  toml += fmt::format("[time]\nend = {:.17g}\n", 0.5 / 3600) + temperature("face", 0, "slab") +
          temperature("far", 1, "slab");
  const Table history = run_case(toml, slab).history;
  EXPECT_NEAR(history.at("face", 0.5 / 3600), 20 + 100 * 0.313118, 0.02);
  EXPECT_NEAR(history.at("far", 0.5 / 3600), 20 + 100 * 0.135886, 0.02);
}

TEST(Heat, ThroughSectors) {
  // A quarter of a tube with films inside and outside, per length: as the full circle.
  const std::vector<RingMesh> rings{{"tube", 0.05, 0.1, 8, 6}};
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\n" + conducting("tube", 30) +
                     "[heat]\nstart = \"steady\"\nfilms = [{ on = \"tube_inner\", coefficient = 2000, fluid = 560 }, "
                     "{ on = \"tube_outer\", coefficient = 50, fluid = 30 }]\n[time]\nend = 1\n" +
                     probe("inner", "temperature", "at = [0.05, 0, 0]") +
                     probe("outer", "temperature", "at = [0.1, 0, 0]");
  const Table quarter = run_case(toml + ring_supports(rings, true), rings_geo(rings, 0.01)).history;
  EXPECT_NEAR(quarter.at("inner", 0), 537.26346, 0.05);
  EXPECT_NEAR(quarter.at("outer", 0), 484.73088, 0.05);
  const std::string cyclic = "[[cyclic]]\nbetween = [\"symmetry_y\", \"symmetry_x\"]\naxis = [0, 0, 1]\nangle = 90\n" +
                             support("tube_low", "z") + support("tube_high", "z") + support("tube_inner", "tangential");
  const Table sector = run_case(toml + cyclic, rings_geo(rings, 0.01)).history;
  EXPECT_NEAR(sector.at("inner", 0), quarter.at("inner", 0), 1e-6);
}

TEST(Heat, ThroughSharedNodes) {
  const std::string shared = R"geo(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1}; Box(2) = {0, 0, 1, 1, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
MeshSize{:} = 0.5;
Physical Volume("low") = {1}; Physical Volume("high") = {2};
Physical Surface("low_z0") = Surface In BoundingBox {-0.1, -0.1, -0.1, 1.1, 1.1, 0.1};
Physical Surface("high_z1") = Surface In BoundingBox {-0.1, -0.1, 1.9, 1.1, 1.1, 2.1};
)geo";
  std::string toml = "[mesh]\nfile = \"case.geo\"\norder = 2\nshare_nodes = \"tie\"\n" + conducting("low", 1) +
                     conducting("high", 3) + "[heat]\n" + held;
  for (const char* component : {"x", "y", "z"}) toml += support("low_z0", component);
  const Table history = run_case(toml + "[time]\nend = 1\n" + probes, shared).history;
  EXPECT_NEAR(history.at("below", 0), 25, 1e-6);
  EXPECT_NEAR(history.at("above", 0), 25, 1e-6);
}

TEST(Heat, AsksAboutUnitsOfTimeAndCoarseElements) {
  const std::string slab = boxes_geo({{"slab", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});
  const auto warnings = [&](double unit, double coefficient) {
    std::string all;
    for (const std::string& one :
         run_case("[mesh]\nfile = \"case.geo\"\norder = 2\n" + conducting("slab", 1) +
                      fmt::format("[heat]\nstart = 20\ntime_unit = {}\nfilms = [{{ on = \"slab_z0\", coefficient = {}, "
                                  "fluid = 120 }}]\n",
                                  unit, coefficient) +
                      support("slab_x0", "x") + support("slab_y0", "y") + support("slab_z0", "z") + "[time]\nend = 2\n",
                  slab)
             .summary.texts("warnings"))
      all += one + "\n";
    return all;
  };
  EXPECT_EQ(warnings(1, 0.1), "");
  EXPECT_TRUE(says(warnings(1e-3, 0.1), {"body 'slab'", "heat through", "heat.time_unit = 0.001"}));
  EXPECT_TRUE(says(warnings(1, 10), {"body 'slab'", "element Biot number 5", "jumps by 100"}));
}

TEST(Heat, ResumesExactly) {
  const std::string toml = stack("start = 0\ntime_unit = 1\n" + ends, "conductance = 2",
                                 "[time]\nend = 10\nintegrator = \"log_adams\"\n" + probes, 1e-14);
  const CaseDirectory directory(geo);
  expect_same_when_resumed(directory.config(toml, {}), directory.path(), {3, 7});
}

TEST(Heat, SaysWhatIsMissing) {
  const auto message = [](const std::string& heat, const std::string& contact, const std::string& time) {
    return message_of<Error>([&] { run_case(stack(heat, contact, "[time]\nend = " + time + "\n"), geo); });
  };
  EXPECT_TRUE(says(message("start = 0\n" + ends, "conductance = 1", "1"), {"heat", "time_unit"}));
  EXPECT_TRUE(says(message(held, "", "1"), {"contacts[0]", "conductance"}));
  EXPECT_TRUE(says(message(held, "conductance = \"3*p^0.95\"", "1"), {"heat", "time_unit"}));
  EXPECT_TRUE(says(
      message("start = \"steady\"\nfilms = [{ on = \"nowhere\", coefficient = 1, fluid = 0 }]", "conductance = 1", "1"),
      {"films[0]", "nowhere"}));
  EXPECT_TRUE(says(message("start = \"steady\"\ntemperatures = [{ on = \"low_z0\", value = 1 }]",
                           "conductance = \"insulated\"", "1"),
                   {"body 'high'", "film"}));
  EXPECT_TRUE(says(message("start = \"steady\"\nradiation = [{ on = \"low_z0\", emissivity = 1, ambient = 0 }]",
                           "conductance = 1", "1"),
                   {"radiation", "stefan_boltzmann"}));
}

}  // namespace
}  // namespace heat_tests
}  // namespace creepcontact
