// Materials that take their data from the material library.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "config_fixture.hpp"
#include "creepcontact/config/material_library.hpp"
#include "creepcontact/config/schema.hpp"
#include "creepcontact/config/writer.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

const std::string library_head = R"(name = "Steel 9"
composition = "9Cr-1Mo"
also = ["P9", "1.7386"]
units = { stress = "MPa", time = "h", temperature = "C", length = "mm" }
[sources.paper]
citation = "A. Smith, 1999"
where = "table 2"
copies = ["the paper"]
status = "original"
licence = "values with citation"
[properties]
source = { young_modulus = "paper", poisson_ratio = "paper", thermal_expansion = "paper" }
young_modulus = { T = [20, 600], values = [2e5, 1.5e5] }
poisson_ratio = 0.3
thermal_expansion = "1e-5 + 1e-9*T"
reference_temperature = 20
)";

const std::string library_check = R"(
quantity = "rate"
T = 500
stress = 100
value = 1
tolerance = 0.1
printed = true
where = "table 3"
)";

const std::string library_variants = R"toml([variants.norton]
title = "steady creep"
source = "paper"
notes = "no primary creep"
data_range = { T = [450, 600], stress = [50, 200] }
[[variants.norton.creep]]
law = "norton"
A = 1e-20
n = 7
[[variants.norton.checks]])toml" + library_check +
                                     R"toml([variants.curved]
title = "n varies"
source = "paper"
notes = "none"
[[variants.curved.creep]]
law = "norton"
A = "1e-20*exp(0.01*T)"
n = { T = [500, 600], values = [7, 5] }
[variants.curved.rupture]
rupture_time = "1e20*q^-6*exp(-1e-2*T)"
[[variants.curved.checks]])toml" + library_check +
                                     R"toml([variants.larson_miller]
title = "rupture"
source = "paper"
notes = "none"
[variants.larson_miller.rupture]
stress = [50, 100]
parameter = [20000, 19000]
[variants.larson_miller.fatigue]
cycles_to_failure = "1000 - T + 0*eps"
[[variants.larson_miller.checks]])toml" +
                                     library_check;

class OfLibrary : public testing::Test {
 protected:
  OfLibrary() {
    std::filesystem::create_directories(directory_);
    write(library_head + library_variants);
    words_.materials = directory_;
    for (Law& law : words_.laws)
      if (law.name == "norton") {
        enum { A, n };
        law.keys[0].dimension = unit::per_time / unit::pow(unit::stress, n);
        law.keys.push_back({.name = "absolute_zero",
                            .description = "of temperatures",
                            .minimum = -1000,
                            .required = false,
                            .fallback = {-273.15},
                            .dimension = unit::temperature});
      }
  }
  ~OfLibrary() override { std::filesystem::remove_all(directory_); }
  OfLibrary(const OfLibrary&) = delete;
  OfLibrary& operator=(const OfLibrary&) = delete;

  void write(const std::string& text) const { std::ofstream(directory_ / "steel_9.toml") << text; }

  /// @param keys  of the material, without its constants
  Config read(const std::string& keys, const std::string& units = "mm, N, MPa, h",
              const std::vector<std::string>& overrides = {}) const {
    std::string text = minimal;
    text.replace(text.find("young_modulus = 2e5\npoisson_ratio = 0.3"), 39, keys);
    if (!units.empty()) text = fmt::format("units = \"{}\"\n", units) + text;
    return parse(text, "cases/block.toml", words_, overrides);
  }
  std::string refusal(const std::string& keys, const std::string& units = "mm, N, MPa, h",
                      const std::vector<std::string>& overrides = {}) const {
    return test::message_of<ConfigError>([&] { read(keys, units, overrides); });
  }

  std::filesystem::path directory_ =
      std::filesystem::path(testing::TempDir()) / fmt::format("creepcontact_library_{}", ::getpid());
  Vocabulary words_ = test_vocabulary();
};

double constant(const Material& of, std::size_t number, double T = 0) {
  return of.creep.at(0).parameters.at(number).values.at(0)({.T = T});
}

TEST_F(OfLibrary, GivesAllThatTheVariantHas) {
  const Material material = read("use = \"steel_9/norton\"").materials[0];
  EXPECT_EQ(material.young_modulus({.T = 600}), 1.5e5);
  EXPECT_EQ(material.poisson_ratio({}), 0.3);
  EXPECT_DOUBLE_EQ(material.thermal_expansion[0]({.T = 100}), 1.01e-5);
  EXPECT_EQ(material.reference_temperature, 20.0);
  EXPECT_EQ(constant(material, 0), 1e-20);
  EXPECT_EQ(constant(material, 1), 7.0);
  EXPECT_EQ(material.creep[0].temperature_range->low, 450.0);
  EXPECT_EQ(material.creep[0].stress_range->high, 200.0);
  EXPECT_EQ(material.sources,
            (std::vector<std::string>{
                "steel_9 (young_modulus, poisson_ratio, thermal_expansion): A. Smith, 1999; table 2 (status: original)",
                "steel_9/norton: A. Smith, 1999; table 2 (status: original)"}));
}

TEST_F(OfLibrary, IsConvertedToTheUnitsOfTheModel) {
  const Material pascal = read("use = \"steel_9/norton\"", "m, Pa, s, K").materials[0];
  EXPECT_DOUBLE_EQ(pascal.young_modulus({.T = 873.15}), 1.5e11);
  EXPECT_DOUBLE_EQ(pascal.thermal_expansion[0]({.T = 373.15}), 1.01e-5);
  EXPECT_DOUBLE_EQ(*pascal.reference_temperature, 293.15);
  EXPECT_NEAR(constant(pascal, 0) / (1e-20 * std::pow(1e-6, 7) / 3600), 1, 1e-12);
  EXPECT_EQ(constant(pascal, 1), 7.0);
  EXPECT_EQ(constant(pascal, 2), 0.0) << "absolute zero, which the library does not give";
  EXPECT_DOUBLE_EQ(pascal.creep[0].temperature_range->low, 723.15);
  EXPECT_DOUBLE_EQ(pascal.creep[0].stress_range->high, 2e8);
  const Material inch = read("use = \"steel_9/norton\"", "inch psi min degF").materials[0];
  EXPECT_NEAR(inch.young_modulus({.T = 1112}), 1.5e11 / 6894.757293168361, 1);
  EXPECT_NEAR(inch.thermal_expansion[0]({.T = 212}), 1.01e-5 / 1.8, 1e-15);
  EXPECT_NEAR(constant(inch, 2), -459.67, 1e-9);
}

TEST_F(OfLibrary, ExponentsMayVaryWithTheTemperature) {
  const Config given = read("use = \"steel_9/curved\"");
  const Config other = read("use = \"steel_9/curved\"", "m, Pa, s, K");
  for (const double T : {450.0, 500.0, 540.0, 600.0, 650.0}) {
    const auto rate = [](const Material& of, double q, double temperature) {
      return constant(of, 0, temperature) * std::pow(q, constant(of, 1, temperature));
    };
    const double expected = rate(given.materials[0], 120, T);
    EXPECT_NEAR(rate(other.materials[0], 1.2e8, T + 273.15) * 3600 / expected, 1, 1e-10) << T;
    EXPECT_NEAR((*other.materials[0].rupture->rupture_time)({.T = T + 273.15, .q = 1.2e8}) / 3600,
                (*given.materials[0].rupture->rupture_time)({.T = T, .q = 120}), 1e-3);
  }
}

TEST_F(OfLibrary, LarsonMillerDataAndFatigueAreConverted) {
  const Material inch =
      read("use = [\"steel_9/norton\", \"steel_9/larson_miller\"]", "inch, psi, min, F", {"time.cycle=10"})
          .materials[0];
  const Rupture& rupture = *inch.rupture;
  EXPECT_NEAR(rupture.stress[0], 5e7 / 6894.757293168361, 1e-6);
  EXPECT_NEAR(rupture.parameter[0], 36000, 1e-9);
  EXPECT_NEAR(rupture.absolute_zero, -459.67, 1e-9);
  EXPECT_NEAR(rupture.time_unit, 1.0 / 60, 1e-15);
  EXPECT_NEAR((*inch.fatigue->cycles_to_failure)({.T = 932, .eps = 0.01}), 500, 1e-9);
  EXPECT_FALSE(read("use = \"steel_9/larson_miller\"").materials[0].fatigue) << "there are no cycles";
}

TEST_F(OfLibrary, BlocksComeFromTheFirstThatHasThem) {
  const Material both = read("use = [\"steel_9/norton\", \"steel_9/curved\"]").materials[0];
  EXPECT_EQ(constant(both, 1, 600), 7.0);
  EXPECT_TRUE(both.rupture);
  EXPECT_EQ(both.sources.size(), 3u);
  const Material elastic = read("use = \"steel_9\"").materials[0];
  EXPECT_TRUE(elastic.creep.empty());
  EXPECT_TRUE(test::says(refusal("use = [\"steel_9/curved\", \"steel_9/norton\"]"),
                         {"use[1]", "'steel_9/norton' adds nothing", "creep"}));
}

TEST_F(OfLibrary, KeysBesideItReplaceIt) {
  const Material material = read(
                                "use = \"steel_9/curved\"\nyoung_modulus = 1e5\nsources = \"test 7\"\n"
                                "[[materials.steel.creep]]\nlaw = \"norton\"\nA = 2\nn = 3")
                                .materials[0];
  EXPECT_EQ(material.young_modulus({}), 1e5);
  EXPECT_EQ(constant(material, 0), 2.0);
  EXPECT_TRUE(material.rupture);
  EXPECT_EQ(material.sources.front(), "test 7");
}

TEST_F(OfLibrary, SingleConstantsMayBeReplaced) {
  const std::string use = "use = \"steel_9/norton\"\n";
  EXPECT_EQ(constant(read(use + "override = { \"creep[0].A\" = 3e-20 }").materials[0], 0), 3e-20);
  EXPECT_EQ(constant(read(use + "[materials.steel.override]\n\"creep.0.n\" = \"7 + T\"").materials[0], 1, 1), 8.0);
  EXPECT_EQ(constant(read(use, "mm, N, MPa, h", {"materials.steel.creep[0].A=4e-20"}).materials[0], 0), 4e-20);
  EXPECT_EQ(constant(read(use, "mm, N, MPa, h", {"materials.steel.use=steel_9/curved"}).materials[0], 1, 600), 5.0);
  EXPECT_EQ(read(use, "mm, N, MPa, h", {"units=m, Pa, s"}).materials[0].creep[0].stress_range->high, 2e8);
  EXPECT_TRUE(test::says(refusal(use + "override = { \"creep[0].absolute_zer\" = 3 }"),
                         {"materials.steel.creep[0].absolute_zer: unknown key", "'absolute_zero'"}));
  EXPECT_TRUE(test::says(refusal(use + "override = { \"creep[1].n\" = 3 }"), {"override.creep[1].n", "no entry '1'"}));
  EXPECT_TRUE(test::says(refusal(use + "override = { \"fatigue.cycles\" = 3 }"), {"the material has no 'fatigue'"}));
  EXPECT_TRUE(test::says(refusal("young_modulus = 1\npoisson_ratio = 0\noverride = { \"creep[0].n\" = 3 }"),
                         {"override: has no effect", "`use`"}));
}

TEST_F(OfLibrary, ResultsArePlain) {
  const Config config = read("use = [\"steel_9/norton\", \"steel_9/larson_miller\"]", "m, Pa, s, K");
  const std::string text = to_toml(config, words_);
  EXPECT_EQ(text.find("use"), std::string::npos);
  EXPECT_EQ(to_toml(parse(text, config.file, words_), words_), text);
}

TEST_F(OfLibrary, NamesAreSuggested) {
  EXPECT_TRUE(test::says(refusal("use = \"steel_8/norton\""), {"use: unknown steel 'steel_8'", "'steel_9'"}));
  EXPECT_TRUE(test::says(refusal("use = \"1.7386/norton\""), {"unknown steel '1.7386'", "'steel_9'"}));
  EXPECT_TRUE(test::says(refusal("use = \"steel_9/nortn\""), {"no variant 'nortn'", "'norton'", "larson_miller"}));
  EXPECT_TRUE(test::says(refusal("use = 3"), {"use: number 3", "creepcontact list materials"}));
  // A mistake is not followed by others that it causes.
  EXPECT_EQ(refusal("use = \"steel_8/norton\"").find('\n'), std::string::npos);
}

TEST_F(OfLibrary, UnitsAreNeeded) {
  const std::string use = "use = \"steel_9/norton\"";
  EXPECT_TRUE(test::says(refusal(use, ""), {"units: missing", "MPa", "psi", "degC"}));
  EXPECT_TRUE(test::says(refusal(use, "millimetres and newtons"), {"units: 'millimetres' is not a known unit", "MPa"}));
  EXPECT_TRUE(test::says(refusal(use, "mm, N, h, Pa"), {"N per mm^2 is not Pa"}));
  EXPECT_EQ(refusal(use, "").find('\n'), std::string::npos);
  EXPECT_EQ(read("young_modulus = 1\npoisson_ratio = 0", "whatever").units, "whatever");
}

TEST_F(OfLibrary, ConstantsThatItLacksAreAskedFor) {
  std::string without = library_head;
  without.erase(without.find("young_modulus = {"),
                without.find("poisson_ratio = 0.3") - without.find("young_modulus = {"));
  without.replace(without.find("young_modulus = \"paper\", "), 25, "");
  write(without + library_variants);
  EXPECT_TRUE(test::says(refusal("use = \"steel_9/norton\""), {"young_modulus: missing", "next to `use`"}));
  EXPECT_EQ(read("use = \"steel_9/norton\"\nyoung_modulus = 7").materials[0].young_modulus({}), 7.0);
}

TEST_F(OfLibrary, FilesOfTheUsersOwnAreTakenToo) {
  words_.materials = directory_ / "..";
  std::string text = minimal;
  text.replace(text.find("young_modulus = 2e5\npoisson_ratio = 0.3"), 39, "use = \"steel_9.toml/norton\"");
  const Config config = parse("units = \"MPa, h\"\n" + text, directory_ / "block.toml", words_);
  EXPECT_EQ(constant(config.materials[0], 1), 7.0);
}

// As `fit` writes them: with the units of the tests in the block, or in the material if it has elastic constants too.
TEST_F(OfLibrary, MaterialsOfOtherConfigurationsAreTaken) {
  const std::string block = R"([[materials.fitted.creep]]
law = "norton"
units = "MPa, h, degC"
A = 1e-20
n = 7
stress_range = [50, 200]
)";
  const auto fitted = [&](const std::string& text, const std::string& use, const std::string& units = "m, Pa, s, K") {
    std::ofstream(directory_ / "fit.toml") << text;
    std::string model = minimal;
    model.replace(model.find("young_modulus = 2e5\npoisson_ratio = 0.3"), 39, use);
    return parse("units = \"" + units + "\"\n" + model, directory_ / "block.toml", words_).materials[0];
  };
  const double in_pascal = 1e-20 * std::pow(1e-6, 7) / 3600;
  const Material two = fitted(block, "use = [\"fit.toml/fitted\", \"steel_9\"]");
  EXPECT_NEAR(constant(two, 0) / in_pascal, 1, 1e-12);
  EXPECT_DOUBLE_EQ(two.creep[0].stress_range->high, 2e8);
  EXPECT_DOUBLE_EQ(two.young_modulus({.T = 873.15}), 1.5e11);
  EXPECT_EQ(two.sources.front(), "fit.toml/fitted");
  EXPECT_TRUE(two.units.empty() && two.creep[0].units.empty());

  std::string whole =
      "[materials.fitted]\nunits = \"MPa, h\"\nyoung_modulus = 1.6e5\npoisson_ratio = 0.3\n"
      "sources = \"test 7\"\n" +
      block;
  whole.erase(whole.find("units = \"MPa, h, degC\"\n"), 23);
  const Material all = fitted(whole, "use = \"fit.toml/fitted\"\npoisson_ratio = 0.25");
  EXPECT_NEAR(constant(all, 0) / in_pascal, 1, 1e-12);
  EXPECT_DOUBLE_EQ(all.young_modulus({}), 1.6e11);
  EXPECT_EQ(all.poisson_ratio({}), 0.25);
  EXPECT_EQ(all.sources.front(), "fit.toml/fitted: test 7");
  EXPECT_DOUBLE_EQ(fitted(whole, "use = \"fit.toml/fitted\"", "mm, N, h").young_modulus({}), 1.6e5);

  const auto refused = [&](const std::string& text, const std::string& use) {
    return test::message_of<ConfigError>([&] { fitted(text, use); });
  };
  EXPECT_TRUE(test::says(refused(block, "use = \"fit.toml/fitted\""), {"young_modulus: missing", "next to `use`"}));
  EXPECT_TRUE(test::says(refused(block, "use = \"fit.toml/fittet\""), {"fit.toml", "'fittet'", "'fitted'"}));
  EXPECT_TRUE(test::says(refused(whole, "use = [\"steel_9/norton\", \"fit.toml/fitted\"]\nsources = \"1\""),
                         {"'fit.toml/fitted' adds nothing"}));
  EXPECT_TRUE(test::says(refused("[materials.fitted]\nuse = \"steel_9\"\n", "use = \"fit.toml/fitted\""),
                         {"fit.toml/fitted", "by `use` itself"}));
  whole.replace(whole.find("MPa, h"), 6, "MPa, weeks");
  EXPECT_TRUE(test::says(refused(whole, "use = \"fit.toml/fitted\""), {"fit.toml", "fitted.units", "'weeks'"}));
}

TEST_F(OfLibrary, UnitsOfAMaterialAreConverted) {
  const std::string keys = "units = \"GPa, s\"\nthermal_expansion = 1e-5\nreference_temperature = 20\n";
  const std::string elastic = "young_modulus = 200\npoisson_ratio = 0.3\n";
  const std::string law = "[[materials.steel.creep]]\nlaw = \"norton\"\nA = 1\nn = 2\n";
  const Material material = read(keys + elastic + law + "units = \"MPa, h\"\n").materials[0];
  EXPECT_DOUBLE_EQ(material.young_modulus({}), 2e5);
  EXPECT_DOUBLE_EQ(constant(material, 0), 1.0);
  EXPECT_NEAR(constant(read(keys + elastic + law).materials[0], 0), 3600e-6, 1e-15);
  const Material orthotropic =
      read(keys + law +
           "[materials.steel.orthotropic]\nyoung_moduli = [1, 2, 3]\npoisson_ratios = [0, 0, 0]\n"
           "shear_moduli = [1, \"2 + T/100\", 3]\n")
          .materials[0];
  EXPECT_DOUBLE_EQ(orthotropic.orthotropic->young_moduli[1]({}), 2000);
  EXPECT_DOUBLE_EQ(orthotropic.orthotropic->shear_moduli[1]({.T = 100}), 3000);

  for (const char* units : {"", "whatever"}) {
    const Config unknown = read(keys + elastic + law, units);
    EXPECT_EQ(unknown.materials[0].young_modulus({}), 200) << "the model has no units that are understood";
    ASSERT_EQ(unknown.remarks.size(), 1u);
    EXPECT_TRUE(test::says(unknown.remarks[0], {"materials.steel", "GPa, s", "units"}));
  }
  EXPECT_TRUE(test::says(refusal("units = \"GPa, weeks\"\n" + elastic + law), {"materials.steel.units", "'weeks'"}));
}

TEST_F(OfLibrary, FilesNeedSourcesAndChecks) {
  for (const char* const needed : {"citation", "where", "copies", "status", "licence", "title", "notes", "name"}) {
    std::string text = '\n' + library_head + library_variants;
    const std::size_t begin = text.find(fmt::format("\n{} = ", needed));
    ASSERT_NE(begin, std::string::npos) << needed;
    text.erase(begin, text.find('\n', begin + 1) - begin);
    write(text);
    const std::string message = test::message_of<ConfigError>([&] { material_library(directory_); });
    EXPECT_TRUE(test::says(message, {"steel_9.toml", "missing", needed}));
  }
  write(library_head + library_variants.substr(0, library_variants.find("[[variants.norton.checks]]")));
  EXPECT_TRUE(test::says(test::message_of<ConfigError>([&] { material_library(directory_); }), {"norton: checks"}));
}

TEST_F(OfLibrary, NamesAreOfferedToEditors) {
  const std::vector<KeyInfo> keys = schema(words_);
  const auto use = std::ranges::find(keys, "materials.<name>.use", &KeyInfo::path);
  ASSERT_NE(use, keys.end());
  std::vector<std::string> offered;
  for (const Word& word : use->words) offered.push_back(word.text);
  EXPECT_EQ(offered,
            (std::vector<std::string>{"steel_9", "steel_9/norton", "steel_9/curved", "steel_9/larson_miller"}));
  EXPECT_NE(json_schema(words_).find("\"steel_9/curved\""), std::string::npos);
}

TEST_F(OfLibrary, ListsShowWhatThereIs) {
  const auto library = material_library(directory_);
  const std::string listing = library_listing(library);
  EXPECT_TRUE(test::says(listing, {"steel_9", "P9", "/norton", "creep (norton)", "450 to 600 °C", "original",
                                   "/larson_miller", "rupture, fatigue"}));
  EXPECT_EQ(matching(library, "p9").size(), 1u);
  EXPECT_EQ(matching(library, "1.73").size(), 1u);
  EXPECT_TRUE(matching(library, "P22").empty());
  EXPECT_TRUE(test::says(library_markdown(library), {"### Steel 9", "| `norton` steady creep |", "A. Smith, 1999"}));
}

}  // namespace
}  // namespace creepcontact::config
