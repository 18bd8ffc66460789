#include "config_fixture.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

const std::string full = R"toml(title = "Shrink fit"
units = "mm, N"
[mesh]
file = "/data/fit.geo"
order = 1
parameters = { h = 5, w = 2.5 }
[bodies.shaft]
region = "shaft"
material = "rotor"
[bodies.ring]
region = ["ring_a", "ring_b"]
material = "disc"
[materials.rotor]
young_modulus = { T = [20, 500], values = [2.1e5, 1.7e5] }
poisson_ratio = 0.3
thermal_expansion = "1e-5 + 1e-9*T"
reference_temperature = 20
[materials.disc]
young_modulus = 1.8e5
poisson_ratio = 0.3
[[materials.disc.creep]]
n = 7.0
law = "norton"
A = "1e-20*exp(T/100)"
[[materials.disc.creep]]
law = "hereditary"
compliances = [1, 2.5]
times = [10, 100]
[[materials.disc.creep]]
law = "expression"
rate = "q*eps + t + T"
[[supports]]
on = "symmetry"
body = "shaft"
displacement = { x = 0, normal = "0.1*t" }
[[loads]]
on = "bore"
pressure = "100*min(t/10, 1)"
[[loads]]
on = "end"
body = "ring"
traction = [0, "x", { t = [0, 1], values = [0, 5] }]
[[loads]]
at = [10.0, 0, 5]
tolerance = 0.5
force = [0, 0, -100]
[[loads]]
body = "ring"
body_force = [0, 0, -7.7e-5]
[[loads]]
body = "ring"
rotation = { axis = [1, 0, 0], angular_velocity = "314*t", density = 7.8e-9 }
[temperature]
value = "500 + 20*z"
[[contacts]]
name = "fit"
between = ["shaft_outer", "ring_bore"]
type = "tied"
slave = "ring_bore"
[[contacts]]
between = ["a", "b"]
gap = "geometric"
[[contacts]]
between = ["c", "d"]
gap = -0.05
[contact_solver]
method = "active_set"
alpha = 0.5
acceleration = "aitken"
[time]
end = 1e4
integrator = "beta_euler"
output = [100, 1, 10, 10]
step = 1
inner_anderson = 3
breakpoints = [100, 20]
[output]
directory = "../out"
fields = false
[[probes]]
name = "p"
quantity = "contact_pressure"
on = "shaft_outer"
reduce = "max"
[[probes]]
name = "area"
quantity = "contact_area"
on = "shaft_outer"
[[probes]]
name = "s"
quantity = "stress_xx"
at = [0, 120, 0]
body = "ring"
)toml";

TEST(ConfigReading, MeshAndBodiesInTheOrderOfTheFile) {
  const Config config = parse_text(full);
  EXPECT_EQ(config.title, "Shrink fit");
  EXPECT_EQ(config.units, "mm, N");
  EXPECT_EQ(config.mesh.file, "/data/fit.geo");
  EXPECT_EQ(config.mesh.order, 1);
  EXPECT_EQ(config.mesh.parameters.at("h"), 5.0);
  ASSERT_EQ(config.bodies.size(), 2u);
  EXPECT_EQ(config.bodies[0].name, "shaft");
  EXPECT_EQ(config.bodies[1].region[1].name, "ring_b");
  EXPECT_EQ(config.bodies[1].region[1].location.prefix(), "cases/block.toml:11:21: bodies.ring.region[1]: ");
  EXPECT_EQ(config.materials[0].name, "rotor");
}

TEST(ConfigReading, MaterialsAndLawsInTheOrderOfTheVocabulary) {
  const Config config = parse_text(full);
  const Material& rotor = config.material("rotor");
  EXPECT_DOUBLE_EQ(rotor.young_modulus({.T = 260}), 1.9e5);
  EXPECT_DOUBLE_EQ(rotor.thermal_expansion.at(0)({.T = 100}), 1.01e-5);
  EXPECT_EQ(rotor.reference_temperature, 20.0);
  const Material& disc = config.material("disc");
  ASSERT_EQ(disc.creep.size(), 3u);
  ASSERT_EQ(disc.creep[0].parameters.size(), 2u);
  EXPECT_EQ(disc.creep[0].parameters[0].key, "A");
  EXPECT_EQ(disc.creep[0].parameters[1].key, "n");
  EXPECT_EQ(disc.creep[0].parameters[1].values.at(0)({}), 7.0);
  EXPECT_EQ(disc.creep[1].parameters[0].values.at(1)({}), 2.5);
  EXPECT_EQ(disc.creep[2].parameters[0].values.at(0)({.t = 1, .T = 10, .q = 100, .eps = 10}), 1011.0);
}

TEST(ConfigReading, WordsAndRangesOfALaw) {
  const std::string law = minimal + "[[materials.steel.creep]]\nlaw = \"hardening\"\nA = 1\n";
  const CreepMechanism of_default = parse_text(law).material("steel").creep.at(0);
  EXPECT_EQ(of_default.parameters.at(1).values.at(0)({}), 0.0);
  EXPECT_FALSE(of_default.parameters.at(1).given);
  EXPECT_FALSE(of_default.stress_range || of_default.temperature_range);
  const std::string more = "by = \"time\"\nstress_range = [20, 200]\ntemperature_range = [450, 600]\n";
  const CreepMechanism given = parse_text(law + more).material("steel").creep.at(0);
  EXPECT_EQ(given.parameters.at(1).values.at(0)({}), 1.0);
  EXPECT_EQ(given.parameters.at(1).word, "time");
  EXPECT_EQ(given.stress_range->high, 200);
  EXPECT_EQ(given.temperature_range->low, 450);
}

TEST(ConfigReading, SourcesAreATextOrSeveral) {
  const std::string gold = minimal + "[materials.gold]\nyoung_modulus = 1\npoisson_ratio = 0\n";
  EXPECT_TRUE(parse_text(gold).material("gold").sources.empty());
  EXPECT_EQ(parse_text(gold + "sources = \"a\"\n").material("gold").sources, std::vector<std::string>{"a"});
  EXPECT_EQ(parse_text(gold + "sources = [\"a\", \"b\"]\n").material("gold").sources,
            (std::vector<std::string>{"a", "b"}));
}

TEST(ConfigReading, SupportsAndLoads) {
  const Config config = parse_text(full);
  const Support& support = config.supports.at(0);
  EXPECT_EQ(support.on.name, "symmetry");
  EXPECT_EQ(support.body.name, "shaft");
  EXPECT_TRUE(support.displacement[0].has_value());
  EXPECT_FALSE(support.displacement[1].has_value());
  EXPECT_DOUBLE_EQ((*support.normal)({.t = 2}), 0.2);
  ASSERT_EQ(config.loads.size(), 5u);
  EXPECT_DOUBLE_EQ(std::get<Pressure>(config.loads[0].kind).value({.t = 5}), 50.0);
  EXPECT_EQ(config.loads[1].body.name, "ring");
  EXPECT_DOUBLE_EQ(std::get<Traction>(config.loads[1].kind).value[2]({.t = 0.5}), 2.5);
  EXPECT_EQ(std::get<PointForce>(config.loads[2].kind).at->at(2), 5.0);
  EXPECT_EQ(std::get<PointForce>(config.loads[2].kind).tolerance, 0.5);
  EXPECT_EQ(std::get<BodyForce>(config.loads[3].kind).value[2]({}), -7.7e-5);
  const Rotation& rotation = std::get<Rotation>(config.loads[4].kind);
  EXPECT_EQ(rotation.axis[0], 1.0);
  EXPECT_EQ(rotation.origin[2], 0.0);
  EXPECT_DOUBLE_EQ(rotation.angular_velocity({.t = 2}), 628.0);
  EXPECT_DOUBLE_EQ(config.temperature->value({.z = 5}), 600.0);
}

TEST(ConfigReading, ContactTimeAndOutput) {
  const Config config = parse_text(full);
  EXPECT_EQ(config.contacts[0].type, ContactType::tied);
  EXPECT_EQ(config.contacts[0].slave, 1);
  EXPECT_EQ(config.contacts[2].gap({}), -0.05);
  EXPECT_EQ(config.contacts[1].name, "a-b");
  EXPECT_EQ(config.contacts[1].slave, -1);
  EXPECT_TRUE(config.contacts[1].geometric_gap);
  EXPECT_EQ(config.contact_solver.alpha.all, 0.5);
  EXPECT_EQ(config.contact_solver.acceleration, Acceleration::aitken);
  EXPECT_EQ(config.time.output, (std::vector<double>{0, 1, 10, 100, 1e4}));
  EXPECT_EQ(config.time.step.mode, StepMode::fixed);
  EXPECT_EQ(config.time.step.length, 1.0);
  EXPECT_EQ(config.time.inner_anderson, 3);
  EXPECT_EQ(config.time.breakpoints, (std::vector<double>{20, 100}));
  EXPECT_EQ(config.output.directory, "out");
  EXPECT_FALSE(config.output.fields);
  EXPECT_EQ(config.probes[0].reduce, Reduce::max);
  EXPECT_EQ(config.probes[1].reduce, Reduce::sum);
  EXPECT_EQ((*config.probes[2].at)[1], 120.0);
}

TEST(ConfigReading, StepOfTheEulerSchemes) {
  EXPECT_EQ(parse_text(minimal + "step = 2\n").time.step.length, 2);
  EXPECT_EQ(parse_text(minimal + "step = \"stable\"\n").time.step.mode, StepMode::stable);
  EXPECT_EQ(parse_text(minimal + "step = \"adaptive\"\n").time.step.mode, StepMode::adaptive);
}

TEST(ConfigReading, InnerIterationOfBetaEuler) {
  EXPECT_EQ(parse_text(minimal).time.inner, InnerIteration::fixed_point);
  EXPECT_EQ(parse_text(minimal + "inner = \"newton\"\n").time.inner, InnerIteration::newton);
}

TEST(ConfigReading, ButcherTableInAnySpelling) {
  for (const char* name :
       {"heun_euler_2_1_2", "HEUN_EULER_2_1_2", "ARKODE_HEUN_EULER_2_1_2", "arkode_heun_euler_2_1_2"})
    EXPECT_EQ(parse_text(minimal + "integrator = \"arkode_erk\"\ntable = \"" + name + "\"\n").time.table, name);
}

TEST(ConfigReading, OutputTimeSeries) {
  const std::vector<double> log =
      parse_text(minimal + "output = { first = 1, count = 3, spacing = \"log\" }").time.output;
  EXPECT_EQ(log, (std::vector<double>{0, 1, 10, 100}));
  EXPECT_EQ(parse_text(minimal + "output = { first = 20, count = 3 }").time.output,
            (std::vector<double>{0, 20, 60, 100}));
  EXPECT_EQ(parse_text(minimal + "output = { count = 4, spacing = \"linear\" }").time.output,
            (std::vector<double>{0, 25, 50, 75, 100}));
}

TEST(ConfigReading, FileThatIsNotThere) {
  try {
    read("no_such.toml", test_vocabulary());
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.exit_status(), 2);
    EXPECT_TRUE(creepcontact::test::says(error.what(), {"no_such.toml: ", "No such file or directory"}));
  }
}

TEST(ConfigReading, AlphaBodyByBody) {
  const Config config = parse_text(minimal + "[contact_solver]\nalpha = { block = 0.3 }\ndamping = 0.7\n");
  EXPECT_FALSE(config.contact_solver.alpha.all.has_value());
  ASSERT_EQ(config.contact_solver.alpha.of_body.size(), 1u);
  EXPECT_EQ(config.contact_solver.alpha.of_body[0].body.name, "block");
  EXPECT_EQ(config.contact_solver.alpha.of_body[0].value, 0.3);
  EXPECT_EQ(config.contact_solver.damping, 0.7);
}

TEST(ReadingReport, TextsAndPictures) {
  const Report report = parse_text(minimal + R"toml([report]
title = "Tightness"
project = "P 1"
purpose = "Is it **tight**?"
appendix = false
pictures = [
  { field = "stress_theta", time = 10, section = { normal = [0, 0, 2] }, view = "-x", range = [0, 100] },
  { field = "mesh" },
]
)toml")
                            .report;
  EXPECT_EQ(report.title, "Tightness");
  EXPECT_EQ(report.project, "P 1");
  EXPECT_EQ(report.purpose, "Is it **tight**?");
  EXPECT_FALSE(report.appendix);
  ASSERT_EQ(report.pictures.size(), 2U);
  EXPECT_EQ(report.pictures[0].time, 10);
  EXPECT_EQ(report.pictures[0].view, "-x");
  EXPECT_EQ(report.pictures[0].range->high, 100);
  EXPECT_EQ(report.pictures[0].section->normal, (std::array<double, 3>{0, 0, 2}));
  EXPECT_FALSE(report.pictures[1].time || report.pictures[1].section || report.pictures[1].range);
  EXPECT_TRUE(parse_text(minimal).report.appendix);
}

TEST(ReadingReport, Mistakes) {
  const auto mistake = [](const std::string& line, std::initializer_list<std::string_view> facts) {
    expect_mistake(minimal + "[report]\n" + line + "\n", facts);
  };
  mistake("logo = \"missing.png\"", {"cases/block.toml:13:", "report.logo", "missing.png"});
  mistake("pictures = [{ field = \"stress_thets\" }]",
          {"cases/block.toml:13:", "report.pictures", "stress_thets", "stress_theta"});
  mistake("pictures = [{ field = \"mesh\", view = \"top\" }]", {"cases/block.toml:13:", "view", "top", "iso"});
  mistake("pictures = [{ field = \"mesh\", range = [2, 1] }]", {"cases/block.toml:13:", "range"});
  mistake("pictures = [{ field = \"mesh\", section = { normal = [0, 0, 0] } }]", {"cases/block.toml:13:", "normal"});
}

}  // namespace
TEST(ConfigReading, RuptureData) {
  const Config config = parse_text(minimal + R"([materials.steel.rupture]
larson_miller_constant = 19.5
stress = [10, 100]
parameter = [25e3, 20e3]
absolute_zero = 0
time_unit = 2.7778e-4
stress_measure = "mixed"
alpha = 0.3
[temperature]
value = 800
)");
  const Rupture& rupture = config.materials[0].rupture.value();
  EXPECT_FALSE(rupture.rupture_time.has_value());
  EXPECT_EQ(rupture.larson_miller_constant, 19.5);
  EXPECT_EQ(rupture.stress, (std::vector<double>{10, 100}));
  EXPECT_EQ(rupture.parameter, (std::vector<double>{25e3, 20e3}));
  EXPECT_EQ(rupture.absolute_zero, 0.0);
  EXPECT_EQ(rupture.time_unit, 2.7778e-4);
  EXPECT_EQ(rupture.stress_measure, StressMeasure::mixed);
  EXPECT_EQ(rupture.alpha, 0.3);

  const Config other = parse_text(minimal + "[materials.steel.rupture]\nrupture_time = \"1e10/q\"\n");
  EXPECT_EQ((*other.materials[0].rupture->rupture_time)({.q = 100}), 1e8);
  EXPECT_EQ(other.materials[0].rupture->absolute_zero, -273.15);
}

TEST(ReadingOutput, FieldTimesAreOutputTimes) {
  const std::string text = minimal + "output = [2, 5]\n[output]\n";
  EXPECT_FALSE(parse_text(text).output.field_times);
  EXPECT_FALSE(parse_text(text + "fields = []").output.fields);
  const Config config = parse_text(text + "fields = [5, 0, 3, 5]");
  EXPECT_TRUE(config.output.fields);
  EXPECT_EQ(config.output.field_times, (std::vector<double>{0, 3, 5}));
  EXPECT_EQ(config.time.output, (std::vector<double>{0, 2, 3, 5, config.time.end}));
  expect_mistake(minimal + "[output]\nfields = [1, 1e9]",
                 {"cases/block.toml:13:14: output.fields[1]: ", "1000000000", "time.end", "[0, "});
  expect_mistake(minimal + "[output]\nfields = [-1]", {"cases/block.toml:13:11: output.fields[0]: ", "-1", ">= 0"});
}

TEST(ReadingOutput, FormatOfTables) {
  const std::string output = minimal + "[output]\n";
  EXPECT_EQ(parse_text(output).output.csv, CsvFormat{});
  EXPECT_EQ(parse_text(output + "separator = ';'\ndecimal = ','").output.csv, (CsvFormat{';', ','}));
  EXPECT_EQ(parse_text(output + "separator = 'tab'").output.csv, (CsvFormat{'\t', '.'}));
  EXPECT_EQ(parse_text(output + "decimal = ','").output.csv, (CsvFormat{';', ','}));
  expect_mistake(output + "decimal = ','\nseparator = ','",
                 {"cases/block.toml:13:11: output.decimal: ", "\";\"", "\"tab\""});
  expect_mistake(output + "separator = '|'", {"cases/block.toml:13:13: output.separator: ", "'|'"});
}

}  // namespace creepcontact::config
