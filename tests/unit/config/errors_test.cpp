#include "config_fixture.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

const std::string at_12 = "cases/block.toml:12:";

TEST(ConfigMistakes, Syntax) {
  const std::vector<std::string> lines = mistakes(minimal + "step = = 1\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].rfind(at_12, 0), 0u) << lines[0];
}

TEST(ConfigMistakes, OddDocuments) {
  EXPECT_EQ(mistakes("").size(), 4u);
  EXPECT_EQ(mistakes("mesh = 1979-05-27\nbodies = 1\nmaterials = []\ntime = {}\n").size(), 4u);
  EXPECT_EQ(mistakes("\xff\xfe").size(), 1u);
  expect_mistake(minimal + "[bodies.\"\"]\n", {at_12}, {"bodies.\"\".region=x"});
}

TEST(ConfigMistakes, UnknownKeyNamesTheNearest) {
  expect_mistake(minimal + "  integrater = \"cvode_bdf\"\n",
                 {at_12 + "3: time.integrater: ", "'integrator'", "end, integrator"});
  expect_mistake(minimal + "[contact]\n", {at_12 + "2: contact: ", "'contacts'"});
  expect_mistake(minimal + "[[materials.steel.creep]]\n  exponent = 7\n  law = \"norton\"\n  A = 1e-20\n  n = 7\n",
                 {"cases/block.toml:13:3: materials.steel.creep[0].exponent: ", "'n'"});
}

TEST(ConfigMistakes, MissingKey) {
  expect_mistake(
      "[time]\nend = 1\n" + minimal.substr(0, minimal.find("[time]")) + "[materials.gold]\nyoung_modulus = 1\n",
      {"cases/block.toml:12:1: materials.gold.poisson_ratio: ", "missing", "(-1, 0.5)"});
  EXPECT_EQ(mistakes("title = 'x'").size(), 4u);
  const std::string orthotropic =
      "[materials.gold.orthotropic]\nyoung_moduli = [1, 1, 1]\npoisson_ratios = [0, 0, 0]\nshear_moduli = [1, 1, 1]\n";
  EXPECT_TRUE(mistakes(minimal + orthotropic).empty());
  expect_mistake(minimal + "[materials.gold]\nyoung_modulus = 1\n" + orthotropic,
                 {"cases/block.toml:13:17: materials.gold.young_modulus: ", "'orthotropic'"});
  const std::string axes = orthotropic + "[bodies.bar]\nregion = \"bar\"\nmaterial = \"gold\"\nmaterial_axes";
  EXPECT_TRUE(mistakes(minimal + axes + ".cylindrical = { axis = [0, 1, 0] }\n").empty());
  expect_mistake(minimal + axes + " = { first = [1, 0, 0] }\n",
                 {"cases/block.toml:19:17: bodies.bar.material_axes.second: ", "missing", "[x, y, z]"});
  expect_mistake(minimal + axes + " = { first = [1, 0, 0], cylindrical = {} }\n",
                 {"cases/block.toml:19:27: bodies.bar.material_axes.first: ", "'cylindrical'", "'first'", "'second'",
                  "'cylindrical'"});
  expect_mistake(minimal + axes + ".cylindrical = { axis = [0, 0, 0] }\n",
                 {"cases/block.toml:19:38: bodies.bar.material_axes.cylindrical.axis: ", "[0, 0, 0]"});
  expect_mistake(minimal + "[[loads]]\non = \"a\"\n", {at_12 + "1: loads[0]: ", "pressure"});
}

TEST(ConfigMistakes, CoefficientsAlongAxes) {
  const std::string key = "materials.steel.thermal_expansion";
  EXPECT_TRUE(mistakes(minimal, {key + "=[1e-5, '1e-5 + 1e-9*T', 2e-5]"}).empty());
  expect_mistake(minimal, {"--set " + key + "=[1, 2]: " + key + ": ", "list of 2"}, {key + "=[1, 2]"});
  expect_mistake(minimal, {"--set " + key + "=[1, true, 2]: " + key + "[1]: ", "true"}, {key + "=[1, true, 2]"});
}

TEST(ConfigMistakes, WrongType) {
  expect_mistake(minimal + "tolerance = \"small\"\n", {at_12 + "13: time.tolerance: ", "'small'", "(0, 0.5]"});
  expect_mistake(minimal + "output = 5\n", {at_12 + "10: time.output: ", "5"});
  expect_mistake(minimal + "output = [1, \"x\"]\n", {at_12 + "14: time.output[1]: ", "'x'", ">= 0"});
  expect_mistake(minimal + "[output]\nfields = 1\n", {"cases/block.toml:13:10: output.fields: ", "1", "true"});
  expect_mistake(minimal + "[contact_solver]\nmax_iterations = 1.5\n",
                 {"cases/block.toml:13:18: contact_solver.max_iterations: ", "1.5", "[1, 1000000]"});
  expect_mistake(minimal + "[loads]\non = \"a\"\n", {at_12 + "1: loads: ", "[loads]", "[[loads]]"});
  expect_mistake(minimal + "tolerance = nan\n", {at_12 + "13: time.tolerance: ", "nan", "(0, 0.5]"});
}

TEST(ConfigMistakes, ButcherTables) {
  const std::string erk = minimal + "integrator = \"arkode_erk\"\n";
  expect_mistake(erk + "table = \"heun_euler\"\n", {"cases/block.toml:13:9: time.table: ", "arkode_erk", "'heun_euler'",
                                                    "'heun_euler_2_1_2'", "heun_euler_2_1_2, bogacki_shampine_4_2_3"});
  expect_mistake(minimal + "table = \"heun_euler_2_1_2\"\n",
                 {at_12 + "9: time.table: ", "\"auto\"", "'table'", "arkode_erk"});
}

TEST(ConfigMistakes, DirectionsAndTimesOfSupports) {
  const auto support = [](const std::string& keys) { return minimal + "[[supports]]\non = \"a\"\n" + keys; };
  expect_mistake(support("displacement = { x = 0 }\naxis = [0, 0, 1]\n"),
                 {"cases/block.toml:15:8: supports[0].axis: ", "displacement.radial", "tangential", "axial"});
  expect_mistake(support("displacement = { along = 0 }\n"),
                 {"cases/block.toml:14:26: supports[0].displacement.along: ", "'direction'", "[x, y, z]"});
  expect_mistake(support("displacement = { radial = 0 }\naxis = [0, 0, 0]\n"),
                 {"cases/block.toml:15:8: supports[0].axis: ", "[0, 0, 0]"});
  expect_mistake(support("displacement = { x = 0 }\nfrom = 2\nuntil = 1\n"),
                 {"cases/block.toml:16:9: supports[0].until: ", "1", "'from' = 2"});
}

TEST(ConfigMistakes, TermsOfEquations) {
  const auto equation = [](const std::string& terms) { return minimal + "[[equations]]\nterms = " + terms + "\n"; };
  expect_mistake(equation("[]"), {"cases/block.toml:13:9: equations[0].terms: ", "empty"});
  expect_mistake(equation("[{ node = 1 }]"), {"cases/block.toml:13:10: equations[0].terms[0]: ", "coefficient"});
  expect_mistake(equation("[{ node = 1, x = 1 }, { node = 1, y = 1 }]"),
                 {"cases/block.toml:13:9: equations[0].terms: ", "node 1"});
}

TEST(ConfigMistakes, OutOfRange) {
  expect_mistake(minimal + "cycle = 0\n", {at_12 + "9: time.cycle: ", "0", "> 0"});
  expect_mistake(minimal + "stop_when_steady = 1e-3\n", {at_12 + "20: time.stop_when_steady: ", "time.cycle"});
  expect_mistake(minimal + "cycle = 1e9\n", {at_12 + "9: time.cycle: ", "1000000000", "time.end"});
  expect_mistake(minimal + "beta = 0.4\n", {at_12 + "8: time.beta: ", "0.4", "[0.5, 1]"});
  expect_mistake(minimal + "step = 0\n", {at_12 + "8: time.step: ", "0", "> 0", "\"stable\"", "\"adaptive\""});
  expect_mistake(minimal + "step = \"stabel\"\n", {at_12 + "8: time.step: ", "'stabel'", "'stable'", "> 0"});
  expect_mistake(minimal + "[contact_solver]\nalpha = 1.5\n",
                 {"cases/block.toml:13:9: contact_solver.alpha: ", "1.5", "(0, 1]"});
  expect_mistake(minimal + "[contact_solver]\nalpha = { block = 2 }\n",
                 {"cases/block.toml:13:19: contact_solver.alpha.block: ", "2", "(0, 1]"});
  expect_mistake(minimal + "[contact_solver]\nalpha = { blok = 0.5 }\n",
                 {"cases/block.toml:13:18: contact_solver.alpha.blok: ", "'blok'", "'block'"});
  expect_mistake(minimal + "[contact_solver]\ndamping = 0\n",
                 {"cases/block.toml:13:11: contact_solver.damping: ", "0", "(0, 1]"});
  expect_mistake(minimal + "[temperature]\nvalue = 1\nrefactor_change = 0.6\n",
                 {"cases/block.toml:14:19: temperature.refactor_change: ", "0.6", "[0, 0.5]"});
  expect_mistake(minimal, {"--set time.end=-1: time.end: ", "-1", ">= 0"}, {"time.end=-1"});
  for (const char* wrong : {"0.5", "-1", "'0.25*2'", "{ T = [0, 1], values = [0.3, 0.5] }"}) {
    const std::vector<std::string> lines = mistakes(
        minimal, {std::string("materials.steel.poisson_ratio=") + wrong, "materials.steel.reference_temperature=20"});
    ASSERT_EQ(lines.size(), 1u) << wrong;
    EXPECT_TRUE(creepcontact::test::says(lines[0], {"materials.steel.poisson_ratio", "(-1, 0.5)"}));
  }
  EXPECT_EQ(mistakes(minimal, {"materials.steel.young_modulus=0"}).size(), 1u);
}

TEST(ConfigMistakes, UnknownWord) {
  expect_mistake(minimal + "integrator = \"cvode_bfd\"\n",
                 {at_12 + "14: time.integrator: ", "'cvode_bfd'", "'cvode_bdf'",
                  "explicit_euler, beta_euler, cvode_bdf, arkode_erk"});
  expect_mistake(minimal + "[[materials.steel.creep]]\nlaw = \"nortan\"\nA = 1\n",
                 {"cases/block.toml:13:7: materials.steel.creep[0].law: ", "'nortan'", "'norton'"});
  expect_mistake(minimal + "[[probes]]\nname = \"a\"\nquantity = \"mises\"\non = \"s\"\n",
                 {"cases/block.toml:14:12: probes[0].quantity: ", "'mises'", "'von_mises'"});
}

TEST(ConfigMistakes, Functions) {
  const std::string loads = minimal + "[[loads]]\non = \"a\"\n";
  expect_mistake(loads + "pressure = \"100*(t\"\n", {"cases/block.toml:14:12: loads[0].pressure: ", "'100*(t'"});
  expect_mistake(loads + "pressure = \"q\"\n", {"cases/block.toml:14:12: loads[0].pressure: ", "'q'"});
  expect_mistake(loads + "pressure = { t = [0, 5, 5, 5], values = [1, 2, 3, 4] }\n",
                 {"cases/block.toml:14:28: loads[0].pressure.t[3]: ", "5", "5"});
  expect_mistake(
      minimal + "[materials.other]\nyoung_modulus = { T = [0, 5, 5], values = [1, 2, 3] }\npoisson_ratio = 0\n",
      {"cases/block.toml:13:30: materials.other.young_modulus.T[2]: ", "5", "5"});
  expect_mistake(loads + "pressure = { t = [0, 5], values = [1, 2, 3] }\n",
                 {"cases/block.toml:14:12: loads[0].pressure: ", "2 points", "3 values"});
  expect_mistake(loads + "pressure = { t = [0, 5], value = [1, 2] }\n",
                 {"cases/block.toml:14:26: loads[0].pressure.value: ", "'values'"});
  expect_mistake(loads + "pressure = { t = [0, 5] }\n", {"cases/block.toml:14:12: loads[0].pressure: ", "points"});
  expect_mistake(loads + "pressure = { t = [0, 5], values = [1, 2], period = 4 }\n",
                 {"cases/block.toml:14:52: loads[0].pressure.period: ", "point 5", "period 4"});
  expect_mistake(loads + "pressure = { t = [1, 5], values = [1, 2], period = 6 }\n",
                 {"cases/block.toml:14:52: loads[0].pressure.period: ", "1", "t = 0"});
  expect_mistake(loads + "pressure = { t = [0, 5], values = [1, 2], period = 0 }\n",
                 {"cases/block.toml:14:52: loads[0].pressure.period: ", "0", "> 0"});
  expect_mistake(loads + "pressure = true\n", {"cases/block.toml:14:12: loads[0].pressure: ", "true"});
  expect_mistake(loads + "traction = [1, 2]\n", {"cases/block.toml:14:12: loads[0].traction: ", "list of 2"});
}

TEST(ConfigMistakes, TemperatureThatIsNotKnown) {
  const std::string table = "materials.steel.young_modulus={ T = [0, 1], values = [1, 2] }";
  EXPECT_EQ(mistakes(minimal, {table}).size(), 1u);
  EXPECT_TRUE(mistakes(minimal, {table, "materials.steel.reference_temperature=0"}).empty());
  EXPECT_TRUE(mistakes(minimal + "[temperature]\nvalue = 1\n", {table}).empty());
}

TEST(ConfigMistakes, Loads) {
  expect_mistake(minimal + "[[loads]]\non = \"a\"\npressure = 1\ntraction = [1, 0, 0]\n",
                 {at_12 + "1: loads[0]: ", "pressure, traction"});
  expect_mistake(minimal + "[[loads]]\nbody = \"block\"\npressure = 1\n",
                 {at_12 + "1: loads[0]: ", "'pressure'", "'on'"});
  expect_mistake(minimal + "[[loads]]\non = \"a\"\nbody = \"block\"\nbody_force = [0, 0, 1]\n",
                 {"cases/block.toml:13:6: loads[0].on: "});
  expect_mistake(minimal + "[[loads]]\nat = [0, 0, 0]\non = \"a\"\nforce = [0, 0, 1]\n",
                 {"cases/block.toml:14:6: loads[0].on: "});
  expect_mistake(minimal + "[[loads]]\nbody = \"blok\"\nbody_force = [0, 0, 1]\n",
                 {"cases/block.toml:13:8: loads[0].body: ", "'blok'", "'block'", "block"});
  expect_mistake(
      minimal + "[[loads]]\nbody = \"block\"\nrotation = { axis = [0, 0, 0], density = 1, angular_velocity = 1 }\n",
      {"cases/block.toml:14:21: loads[0].rotation.axis: ", "[0, 0, 0]"});
}

TEST(ConfigMistakes, Supports) {
  expect_mistake(minimal + "[[supports]]\non = \"a\"\ndisplacement = {}\n",
                 {"cases/block.toml:14:16: supports[0].displacement: ", "empty"});
  expect_mistake(minimal + "[[supports]]\non = \"\"\ndisplacement = { x = 0 }\n",
                 {"cases/block.toml:13:6: supports[0].on: ", "empty"});
}

TEST(ConfigMistakes, Bodies) {
  expect_mistake(minimal, {"--set bodies.block.material=stel: bodies.block.material: ", "'stel'", "'steel'"},
                 {"bodies.block.material=stel"});
  expect_mistake(minimal + "[bodies.second]\nregion = [\"b\", \"all\"]\nmaterial = \"steel\"\n",
                 {"cases/block.toml:13:16: bodies.second.region[1]: ", "'all'", "'block'"});
}

TEST(ConfigMistakes, Mesh) {
  expect_mistake(minimal,
                 {"--set mesh.file=block.stl: mesh.file: ", "'block.stl'", ".geo, .step", ".med, .inp, .unv, .bdf"},
                 {"mesh.file=block.stl"});
  expect_mistake(minimal, {"--set mesh.order=2: mesh.order: ", ".geo"}, {"mesh.order=2"});
}

TEST(ConfigMistakes, Contacts) {
  expect_mistake(minimal + "[[contacts]]\nbetween = [\"a\", \"b\"]\nslave = \"c\"\n",
                 {"cases/block.toml:14:9: contacts[0].slave: ", "'c'", "auto, a, b"});
  expect_mistake(minimal + "[[contacts]]\nbetween = [\"a\"]\n",
                 {"cases/block.toml:13:11: contacts[0].between: ", "list of 1"});
  expect_mistake(minimal + "[[contacts]]\nbetween = [\"a\", \"a\"]\n",
                 {"cases/block.toml:13:11: contacts[0].between: ", "'a'"});
  expect_mistake(minimal + "[[contacts]]\nbetween = [\"a\", \"b\"]\n[[contacts]]\nbetween = [\"a\", \"b\"]\n",
                 {"cases/block.toml:14:1: contacts[1]: ", "'a-b'", "contacts[0]"});
  expect_mistake(minimal + "[[contacts]]\nbetween = [\"a\", \"b\"]\n[[contacts]]\nbetween = [\"b\", \"a\"]\n",
                 {"cases/block.toml:14:1: contacts[1]: ", "'b'", "'a'", "contacts[0]"});
  expect_mistake(minimal + "[[contacts]]\nbetween = [\"a\", \"b\"]\ngap = \"geometrical\"\n",
                 {"cases/block.toml:14:7: contacts[0].gap: ", "'geometrical'"});
}

TEST(ConfigMistakes, Preloads) {
  const std::string contact = minimal + "[[contacts]]\nname = \"c\"\nbetween = [\"a\", \"b\"]\n";
  const auto expect = [&](const std::string& keys, std::initializer_list<std::string_view> facts) {
    const std::vector<std::string> lines = mistakes(contact + keys + '\n');
    ASSERT_EQ(lines.size(), 1u) << keys;
    EXPECT_TRUE(creepcontact::test::says(lines[0], facts)) << keys;
  };
  expect("gap = -0.1\npreload = { force = 1 }", {"contacts[0].gap: ", "'preload'"});
  expect("preload = { force = 0 }", {"contacts[0].preload.force: ", "0", "> 0"});
  expect("preload = { }", {"contacts[0].preload"});
  expect("preload = { force = 1, at = 1e9 }", {"contacts[0]", "t = 1e+09", "end"});
}

TEST(ConfigMistakes, Creep) {
  const std::string creep = minimal + "[[materials.steel.creep]]\n";
  expect_mistake(creep + "law = \"norton\"\nA = 1\n", {at_12 + "1: materials.steel.creep[0].n: ", "missing", "> 0"});
  expect_mistake(creep + "law = \"norton\"\nA = 1\nn = -1\n",
                 {"cases/block.toml:15:5: materials.steel.creep[0].n: ", "-1", "> 0"});
  expect_mistake(creep + "law = \"hereditary\"\ncompliances = [1, 2]\ntimes = [1]\n",
                 {"cases/block.toml:15:9: materials.steel.creep[0].times: ", "list of 1"});
  expect_mistake(creep + "A = 1\n", {at_12 + "1: materials.steel.creep[0].law: ", "missing"});
}

TEST(ConfigMistakes, Time) {
  expect_mistake(minimal + "output = [1, 200]\n", {at_12 + "14: time.output[1]: ", "200", "time.end", "[0, 100]"});
  expect_mistake(minimal + "output = [-1]\n", {at_12 + "11: time.output[0]: ", "-1", ">= 0"});
  expect_mistake(minimal + "output = { count = 3, spacing = \"log\" }\n",
                 {at_12 + "10: time.output: ", "\"log\"", "'first'"});
  expect_mistake(minimal + "output = { first = 100, count = 3 }\n",
                 {at_12 + "10: time.output.first: ", "100", "time.end"});
  expect_mistake(minimal + "output = { first = 1 }\n", {at_12 + "10: time.output.count: ", "missing"});
}

TEST(ConfigMistakes, Probes) {
  const std::string probe = minimal + "[[probes]]\nname = \"p\"\n";
  expect_mistake(probe + "quantity = \"von_mises\"\n", {at_12 + "1: probes[0]: ", "'on'", "'at'", "'body'"});
  expect_mistake(probe + "quantity = \"von_mises\"\non = \"a\"\nat = [0, 0, 0]\n",
                 {at_12 + "1: probes[0]: ", "both", "'on'", "'at'"});
  expect_mistake(probe + "quantity = \"von_mises\"\nat = [0, 0, 0]\nreduce = \"max\"\n",
                 {"cases/block.toml:16:10: probes[0].reduce: ", "'on'", "'body'"});
  expect_mistake(probe + "quantity = \"contact_pressure\"\nbody = \"block\"\n",
                 {"cases/block.toml:14:12: probes[0].quantity: ", "'contact_pressure'"});
  expect_mistake(probe + "quantity = \"contact_area\"\non = \"a\"\nreduce = \"mean\"\n",
                 {"cases/block.toml:16:10: probes[0].reduce: ", "'mean'", "\"sum\"", "'contact_area'"});
  expect_mistake(
      probe + "quantity = \"von_mises\"\non = \"a\"\n[[probes]]\nname = \"p\"\nquantity = \"von_mises\"\non = \"b\"\n",
      {"cases/block.toml:16:1: probes[1]: ", "'p'", "probes[0]"});
  expect_mistake(minimal + "[[probes]]\nname = \"a,b\"\nquantity = \"von_mises\"\non = \"a\"\n",
                 {"cases/block.toml:13:8: probes[0].name: ", "'a,b'"});
}

TEST(ConfigMistakes, AllInOneGoInTheOrderOfTheFile) {
  const std::vector<std::string> lines = mistakes(
      minimal +
          "beta = 0\nbeat = 1\n[[loads]]\nbody = \"no\"\nbody_force = [0, 0, 1]\n[[loads]]\n[[probes]]\nname = 1\n",
      {"contact_solver.alpha=x", "mesh.file=3"});
  const std::vector<std::string> begins = {"cases/block.toml:12:8: time.beta: ",
                                           "cases/block.toml:13:1: time.beat: ",
                                           "cases/block.toml:15:8: loads[0].body: ",
                                           "cases/block.toml:17:1: loads[1]: ",
                                           "cases/block.toml:18:1: probes[0].quantity: ",
                                           "cases/block.toml:18:1: probes[0]: ",
                                           "cases/block.toml:19:8: probes[0].name: ",
                                           "--set mesh.file=3: mesh.file: ",
                                           "--set contact_solver.alpha=x: contact_solver.alpha: "};
  ASSERT_EQ(lines.size(), begins.size());
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].substr(0, begins[i].size()), begins[i]);
}

}  // namespace
TEST(ConfigMistakes, ValuesThatALawCannotHave) {
  const std::string picky = minimal + "[[materials.steel.creep]]\nlaw = \"picky\"\n";
  expect_mistake(picky + "m = 1.5\n", {"cases/block.toml:14:5: materials.steel.creep[0].m: ", "1.5", "(0, 1]"});
  expect_mistake(picky + "m = \"0.3*T\"\n", {"cases/block.toml:14:5: materials.steel.creep[0].m: ", "'0.3*T'"});
  expect_mistake(picky + "m = 0.5\n", {"cases/block.toml:14:5: materials.steel.creep[0].m: ", "0.5"});
}

TEST(ConfigMistakes, WordsOfALaw) {
  const std::string law = minimal + "[[materials.steel.creep]]\nlaw = \"hardening\"\nA = 1\n";
  expect_mistake(law + "by = \"strian\"\n",
                 {"cases/block.toml:15:6: materials.steel.creep[0].by: ", "'strian'", "'strain'", "strain, time"});
  expect_mistake(law + "by = 1\n",
                 {"cases/block.toml:15:6: materials.steel.creep[0].by: ", "1", "\"strain\"", "\"time\""});
}

TEST(ConfigMistakes, RangesOfALaw) {
  const std::string law = minimal + "[[materials.steel.creep]]\nlaw = \"norton\"\nA = 1\nn = 3\n";
  const std::string at = "cases/block.toml:16:16: materials.steel.creep[0].stress_range: ";
  expect_mistake(law + "stress_range = [200, 20]\n", {at, "[200, 20]", "[low, high]"});
  expect_mistake(law + "stress_range = [200]\n", {at, "[200]", "[low, high]"});
  expect_mistake(law + "stress_range = 200\n", {at, "200", "[low, high]"});
}

TEST(ConfigMistakes, Sources) {
  const std::string gold = "[materials.gold]\nyoung_modulus = 1\npoisson_ratio = 0\n";
  const auto with = [&](const std::string& sources) { return minimal + gold + "sources = " + sources + "\n"; };
  const std::string place = "cases/block.toml:15:11: materials.gold.sources";
  expect_mistake(with("3"), {place + ": ", "3"});
  expect_mistake(with("[]"), {place + ": "});
  expect_mistake(with("\"\""), {place + ": "});
}

TEST(ConfigMistakes, ALawThatDependsOnTheTemperatureByItselfNeedsOne) {
  const std::string picky = minimal + "[[materials.steel.creep]]\nlaw = \"picky\"\nm = 1\n";
  EXPECT_TRUE(mistakes(picky).empty());
  expect_mistake(picky + "Q = 3e5\n", {"cases/block.toml:12:1: materials.steel.creep[0]: ", "[temperature]"});
  EXPECT_TRUE(mistakes(picky + "Q = 3e5\n[temperature]\nvalue = 500\n").empty());
}

TEST(ConfigMistakes, RuptureData) {
  const std::string rupture = minimal + "[materials.steel.rupture]\n", heading = at_12 + "1: ";
  const std::string at = "cases/block.toml:13:", key = "materials.steel.rupture.";
  expect_mistake(rupture, {heading + "materials.steel.rupture: ", "rupture_time"});
  expect_mistake(rupture + "rupture_time = \"1e20*q^-5*t\"\n", {at + "16: " + key + "rupture_time: ", "'1e20*q^-5*t'"});
  const std::string miller = rupture + "stress = [1, 2]\nparameter = [3, 2]\n[temperature]\nvalue = 500\n";
  EXPECT_TRUE(mistakes(miller).empty());
  expect_mistake(miller, {at + "10: " + key + "stress: ", "2 values"}, {"materials.steel.rupture.parameter=[7, 8]"});
  expect_mistake(rupture + "stress = [1, 2]\n", {heading + "materials.steel.rupture.parameter: ", "missing"});
  expect_mistake(rupture + "stress = [1, 2]\nparameter = [3, 2]\n",
                 {heading + "materials.steel.rupture: ", "[temperature]"});
  const std::string time = rupture + "rupture_time = \"1e20*q^-5\"\n";
  EXPECT_TRUE(mistakes(time).empty());
  expect_mistake(time + "stress = [1, 2]\n", {"cases/block.toml:14:10: " + key + "stress: ", "rupture_time"});
  expect_mistake(time + "stress_measure = \"mixed\"\n",
                 {heading + key + "alpha: ", "missing", "[0, 1]", "stress_measure = \"mixed\""});
  expect_mistake(time + "alpha = 0.5\n", {"cases/block.toml:14:9: " + key + "alpha: ", "stress_measure = \"mixed\""});
}

}  // namespace creepcontact::config
