/// A configuration that is written reads back as an equal one; one that is made in code is complete.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/configured.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/writer.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

using Lines = std::vector<std::string>;

Lines lines(const std::vector<config::ConfiguredValue>& values) {
  Lines result;
  for (const config::ConfiguredValue& value : values) result.push_back(value.key + " = " + value.text);
  return result;
}

/// Keys, texts, variables and breakpoints.
Lines lines(const std::vector<config::ConfiguredFunction>& functions) {
  Lines result;
  for (const config::ConfiguredFunction& function : functions) {
    std::string& line = result.emplace_back(function.key + " = " + function.value.text());
    for (const std::string& variable : function.variables) line += ' ' + variable;
    for (const double time : function.value.breakpoints()) line += fmt::format(" {}", time);
  }
  return result;
}

void expect_equal(const config::Config& one, const config::Config& other) {
  EXPECT_EQ(lines(config::all_values(one)), lines(config::all_values(other)));
  EXPECT_EQ(lines(config::identifying_values(one)), lines(config::identifying_values(other)));
  EXPECT_EQ(lines(config::functions(one)), lines(config::functions(other)));
}

config::Config read_again(const config::Config& config) {
  return config::parse(config::to_toml(config, vocabulary()), config.file, vocabulary());
}

TEST(WrittenConfig, OfEveryExampleAndTemplateReadsBackAsAnEqualOne) {
  std::size_t n = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(CREEPCONTACT_CONFIGS)) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    const config::Config config = config::read(entry.path(), vocabulary());
    const config::Config again = read_again(config);
    expect_equal(config, again);
    EXPECT_EQ(config::to_toml(config, vocabulary()), config::to_toml(again, vocabulary()));
    config::Config completed = config;
    config::complete(completed, vocabulary());
    expect_equal(config, completed);
    ++n;
  }
  EXPECT_GE(n, 25U);
}

/// Every kind of load, and values that are written in several ways.
config::Config made_in_code(settings::Analysis analysis) {
  config::Config made;
  made.file = "cases/made.toml";
  made.title = "a \"title\"\nof two lines";
  made.analysis = analysis;
  made.mesh.file = "meshes/made.geo";
  made.mesh.parameters = {{"length", 1e-3}, {"n", 4}};
  made.bodies.push_back({.name = "the disc",
                         .region = {{"a"}, {"b"}},
                         .material = {"steel"},
                         .thickness = {},
                         .axial_force = {},
                         .material_axes = {},
                         .location = {}});
  config::Material& steel = made.materials.emplace_back();
  steel.name = "steel";
  steel.young_modulus = Function::table("T", {20, 600}, {2e5, 1.5e5});
  steel.poisson_ratio = 0.0;
  steel.reference_temperature = 20;
  steel.creep.push_back({.law = "expression", .parameters = {}, .location = {}});
  steel.creep[0].parameters.push_back(
      {.key = "rate", .values = {Function::expression("1e-9*q^3*(1 + t)", {"q", "t"})}, .location = {}});
  config::Support support;
  support.on = {"foot"};
  support.displacement[1] = Function::expression("-0.1*t", {"t"});
  support.until = 3;
  made.supports.push_back(support);
  const Function ramp = Function::table("t", {0, 1, 1, 2}, {0, 1, 3, 3}, 2.5);
  made.loads.push_back({{"top"}, {}, config::Pressure{ramp}, {}});
  made.loads.push_back({{"top"}, {}, config::Traction{{ramp, -0.0, 0.0}}, {}});
  made.loads.push_back({{}, {}, config::PointForce{{{1, 2, 0}}, 1e-3, 0, {1.0, 2.0, 0.0}}, {}});
  made.loads.push_back({{}, {}, config::PointForce{{}, {}, 12, {1.0, 2.0, 0.0}}, {}});
  made.loads.push_back({{}, {"the disc"}, config::BodyForce{{1.0, 0.0, 0.0}}, {}});
  made.loads.push_back({{}, {"the disc"}, config::Rotation{{0, 0, 1}, {}, 300.0, 7.8e-9}, {}});
  made.contacts.push_back({});
  made.contacts[0].between = {{{"inner"}, {"outer"}}};
  made.contacts[0].slave = 1;
  made.contacts[0].geometric_gap = true;
  made.contact_solver.alpha.of_body = {{{"the disc"}, 0.3}};
  made.time.end = 10;
  made.time.output = {2.5};
  made.output.field_times = {5};
  made.output.csv = {.separator = ';', .decimal = ','};
  made.probes.push_back({});
  made.probes[0].name = "area";
  made.probes[0].quantity = "contact_area";
  made.probes[0].on = {"inner"};
  made.probes.push_back({});
  made.probes[1].name = "hoop";
  made.probes[1].quantity = "stress_theta";
  made.probes[1].body = {"the disc"};
  made.probes[1].reduce = config::Reduce::max;
  config::complete(made, vocabulary());
  return made;
}

TEST(WrittenConfig, MadeInCodeReadsBackAsAnEqualOne) {
  for (const auto analysis : {settings::Analysis::solid, settings::Analysis::axisymmetric}) {
    const config::Config made = made_in_code(analysis);
    expect_equal(made, read_again(made));
  }
}

TEST(WrittenConfig, MadeInCodeHasItsFunctionsAndValues) {
  const config::Config made = made_in_code(settings::Analysis::axisymmetric);
  EXPECT_EQ(std::get<config::Rotation>(made.loads[5].kind).axis, (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(made.probes[1].axis, (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(made.probes[0].reduce, config::Reduce::sum);
  EXPECT_EQ(made.contacts[0].name, "inner-outer");
  EXPECT_EQ(made.time.output, (std::vector<double>{0, 2.5, 5, 10}));
  EXPECT_EQ(made.output.directory, "cases/results/made");
  const Lines functions = lines(config::functions(made));
  for (const char* line :
       {"loads[0].pressure = { t = [0, 1, 1, 2], values = [0, 1, 3, 3], period = 2.5 } x y z t 0 1 2 2.5",
        "materials.steel.creep[0].rate = 1e-9*q^3*(1 + t) q T t eps", "supports[0].displacement.y = -0.1*t x y z t"})
    EXPECT_EQ(std::ranges::count(functions, line), 1) << line << " among\n"
                                                      << fmt::format("{}", fmt::join(functions, "\n"));
  const Lines values = lines(config::identifying_values(made));
  for (const char* line : {"loads[5].rotation.axis = [0, 1, 0]", "loads[0].on = \"top\"", "loads[3].node = 12",
                           "contacts[0].slave = \"outer\"", "contacts[0].gap = \"geometric\""})
    EXPECT_EQ(std::ranges::count(values, line), 1) << line << " among\n" << fmt::format("{}", fmt::join(values, "\n"));
}

/// Equal models have one fingerprint, made in code or read; every other value of the model gives another.
TEST(WrittenConfig, EveryValueOfTheModelIsInTheFingerprint) {
  const Lines before = lines(config::identifying_values(made_in_code(settings::Analysis::solid)));
  const auto changes = [&](const auto& change) {
    config::Config made = made_in_code(settings::Analysis::solid);
    change(made);
    const Lines now = lines(config::identifying_values(made));
    Lines different;
    std::ranges::set_symmetric_difference(std::set<std::string>(before.begin(), before.end()),
                                          std::set<std::string>(now.begin(), now.end()), std::back_inserter(different));
    return different.size();
  };
  EXPECT_EQ(changes([](config::Config& made) { made.time.end = 20; }), 0U);
  EXPECT_EQ(changes([](config::Config& made) { made.loads[0].kind = config::Pressure{1.0}; }), 2U);
  EXPECT_EQ(changes([](config::Config& made) { std::get<config::Rotation>(made.loads[5].kind).density = 1.0; }), 2U);
  EXPECT_EQ(changes([](config::Config& made) { made.materials[0].creep[0].parameters[0].values = {1.0}; }), 2U);
  EXPECT_EQ(changes([](config::Config& made) { made.supports[0].from = 1; }), 1U);
  EXPECT_EQ(changes([](config::Config& made) { made.contacts[0].friction = 0.1; }), 2U);
}

TEST(WrittenConfig, HasItsComments) {
  config::Config made = made_in_code(settings::Analysis::solid);
  config::Comments comments;
  comments.above[""] = "Made of\ntwo lines.";
  comments.beside["loads[0]"] = "*DLOAD";
  comments.beside["mesh.order"] = "the default";
  comments.above["loads[1].traction"] = "why";
  const std::string text = config::to_toml(made, vocabulary(), comments);
  EXPECT_TRUE(text.starts_with("# Made of\n# two lines.\ntitle = \"a \\\"title\\\"\\u000Aof two lines\"\n")) << text;
  EXPECT_TRUE(contains(text, "[[loads]]                    # *DLOAD\non = \"top\"\n")) << text;
  EXPECT_TRUE(contains(text, "order = 2                    # the default\n")) << text;
  EXPECT_TRUE(contains(text, "# why\ntraction = ")) << text;
  expect_equal(made, config::parse(text, made.file, vocabulary()));
}

/// What a file must not say is refused when it is read, not left out.
TEST(WrittenConfig, WritesWhatIsWrong) {
  config::Config made = made_in_code(settings::Analysis::solid);
  made.materials[0].orthotropic.emplace();
  EXPECT_TRUE(says(message_of<ConfigError>([&] { read_again(made); }), {"young_modulus: ", "'orthotropic'"}));
  made = made_in_code(settings::Analysis::solid);
  made.materials[0].creep[0].law = "none";
  EXPECT_THROW(config::complete(made, vocabulary()), std::invalid_argument);
}

}  // namespace
}  // namespace creepcontact::run::test
