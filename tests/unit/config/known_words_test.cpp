#include "../../../src/config/known_words.hpp"

#include <fmt/format.h>

#include <regex>
#include <set>

#include "config_fixture.hpp"
#include "creepcontact/config/key_reference.hpp"
#include "creepcontact/config/schema.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

TEST(KnownWords, FeaturesThatThisVersionDoesNotHave) {
  const std::vector<std::string> lines = mistakes(minimal + "[[loads]]\non = \"s\"\npressure = 1\nmoment = 1\n");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(creepcontact::test::says(lines[0], {"loads[0].moment: ", absent_feature}));
  EXPECT_EQ(lines[0].find('?'), std::string::npos) << lines[0];
}

TEST(KnownWords, LeadToTheRightKeyOrLaw) {
  const std::string creep = minimal + "[[materials.steel.creep]]\n";
  for (const std::string law : {"bailey_norton", "Bailey"})
    expect_mistake(
        creep + "law = \"" + law + "\"\n",
        {"cases/block.toml:13:7: materials.steel.creep[0].law: ", "'" + law + "'", "'norton_bailey'", "'hardening'"});
  const std::pair<const char*, const char*> top[] = {{"dt = 1", "'step'"}, {"step_size = 1", "'step'"}};
  for (const auto& [key, right] : top) {
    const std::vector<std::string> lines = mistakes(minimal + key + '\n');
    ASSERT_EQ(lines.size(), 1u) << key;
    EXPECT_TRUE(creepcontact::test::says(lines[0], {right}));
  }
  const std::string contact = minimal + "[[contacts]]\nbetween = [\"a\", \"b\"]\n";
  for (const char* key : {"mu", "friction_coefficient", "coefficient_of_friction"})
    expect_mistake(contact + key + " = 0.15\n",
                   {fmt::format("cases/block.toml:14:1: contacts[0].{}: ", key), "'friction'"});
  expect_mistake(contact + "type = \"frictional\"\n",
                 {"cases/block.toml:14:8: contacts[0].type: ", "'frictional'", "'unilateral'", "'friction'"});
  const std::string gold = minimal + "[materials.gold]\nyoung_modulus = 1\npoisson_ratio = 0\n";
  const std::pair<const char*, const char*> material[] = {{"E = 1", "'young_modulus'"},
                                                          {"youngs_modulus = 1", "'young_modulus'"},
                                                          {"nu = 0.3", "'poisson_ratio'"},
                                                          {"poisson = 0.3", "'poisson_ratio'"},
                                                          {"alpha = 1", "'thermal_expansion'"}};
  for (const auto& [key, right] : material) {
    const std::vector<std::string> lines = mistakes(gold + key + '\n');
    ASSERT_EQ(lines.size(), 1u) << key;
    EXPECT_TRUE(creepcontact::test::says(lines[0], {"materials.gold.", right}));
  }
  const std::vector<std::string> rpm =
      mistakes(minimal + "[[loads]]\nbody = \"block\"\nrotation = { rpm = 5000, density = 1, angular_velocity = 1 }\n");
  ASSERT_EQ(rpm.size(), 1u);
  EXPECT_TRUE(creepcontact::test::says(rpm[0], {"loads[0].rotation.rpm: ", "'angular_velocity'"}));
  const std::vector<std::string> restart = mistakes(minimal + "restart = true\n");
  ASSERT_EQ(restart.size(), 1u);
  EXPECT_TRUE(creepcontact::test::says(restart[0], {"time.restart: ", "--resume"}));
}

/// The table must not outlive what it speaks of: its places exist, its words are no keys, the keys it names are.
TEST(KnownWords, AgreeWithTheSchema) {
  std::set<std::string> tables{""}, paths, names;
  for (const KeyInfo& key : schema(test_vocabulary())) {
    paths.insert(key.path);
    names.insert(key.path.substr(key.path.rfind('.') + 1));
    if (key.form == Form::table) tables.insert(key.path);
    if (key.form == Form::tables) tables.insert(key.path + "[]");
    if (key.form == Form::named) tables.insert(key.path + ".<name>");
    for (const Word& word : key.words) names.insert(word.text);
  }
  tables.insert({"loads[].rotation", "supports[].displacement"});  // written inline
  // of the program's own vocabulary, which this test does not see
  for (const char* name : {"norton_bailey",
                           "hardening",
                           "garofalo",
                           "kachanov_rabotnov",
                           "omega",
                           "theta_projection",
                           "rcc_mr",
                           "soderberg",
                           "chaboche",
                           "rate0",
                           "theta_1",
                           "theta_4",
                           "activation_energy",
                           "gas_constant",
                           "m",
                           "auto",
                           "cvode_adams",
                           "log_adams",
                           "arkode_dirk",
                           "stress_r",
                           "displacement_x",
                           "creep_strain_equivalent",
                           "principal_1",
                           "reaction_x",
                           "contact_force_x"})
    names.insert(name);
  for (const KnownWord& known : known_words()) {
    const std::string position(known.place), says(known.says);
    const bool of_value = position.ends_with('=');
    if (of_value)
      EXPECT_TRUE(paths.contains(position.substr(0, position.size() - 1))) << position;
    else
      EXPECT_TRUE(tables.contains(position)) << position;
    std::istringstream words{std::string(known.words)};
    for (std::string word; !of_value && words >> word;)
      EXPECT_FALSE(paths.contains(position.empty() ? word : position + '.' + word)) << position << ' ' << word;
    static const std::regex quoted("'([^']+)'(?![a-z])");
    std::sregex_iterator at(says.begin(), says.end(), quoted);
    const bool names_something = at != std::sregex_iterator();
    for (; at != std::sregex_iterator(); ++at)
      EXPECT_TRUE(names.contains((*at)[1]) || paths.contains((*at)[1])) << (*at)[1] << " in: " << says;
    EXPECT_TRUE(names_something || says.starts_with(absent_feature) || says.find("--resume") != std::string::npos)
        << says;
  }
}

TEST(KnownWords, AfterListKeys) {
  EXPECT_TRUE(creepcontact::test::says(
      creepcontact::test::message_of<ConfigError>([] { select_keys(key_sections(schema(test_vocabulary())), "rpm"); }),
      {"loads[].rotation: ", "'angular_velocity'"}));
}

}  // namespace
}  // namespace creepcontact::config
