/// The keys for people: which table they stand in, which ones a user's word means, how they are shown.
#include "creepcontact/config/key_reference.hpp"

#include <algorithm>

#include "config_fixture.hpp"
#include "support/says.hpp"

namespace creepcontact::config {
namespace {

using Lines = std::vector<std::string>;

std::vector<KeySection> sections() {
  return key_sections(schema(test_vocabulary()));
}

Lines paths(const std::vector<KeySection>& found) {
  Lines all;
  for (const KeySection& section : found)
    for (const KeyInfo& key : section.keys) all.push_back(key.path);
  return all;
}

Lines selected(const std::string& wanted) {
  return paths(select_keys(sections(), wanted));
}

bool has_line(const std::string& text, const std::string& line) {
  return ('\n' + text).find('\n' + line + '\n') != std::string::npos;
}

TEST(KeySections, TablesAsInTheFile) {
  Lines titles;
  for (const KeySection& section : sections()) titles.push_back(section.title);
  EXPECT_EQ(titles, (Lines{"",
                           "[mesh]",
                           "[surfaces.<name>]",
                           "[bodies.<name>]",
                           "[bodies.<name>.material_axes]",
                           "[materials.<name>]",
                           "[materials.<name>.orthotropic]",
                           "[materials.<name>.hill]",
                           "[[materials.<name>.creep]]",
                           "[materials.<name>.plasticity]",
                           "[[materials.<name>.plasticity.curve]]",
                           "[[materials.<name>.plasticity.kinematic]]",
                           "[materials.<name>.rupture]",
                           "[materials.<name>.data_range]",
                           "[materials.<name>.fatigue]",
                           "[[supports]]",
                           "[[loads]]",
                           "[generalized_plane_strain]",
                           "[temperature]",
                           "[heat]",
                           "[initial_stress.<name>]",
                           "[gaskets.<name>]",
                           "[[contacts]]",
                           "[[springs]]",
                           "[[cyclic]]",
                           "[[rigid]]",
                           "[[coupling]]",
                           "[[equations]]",
                           "[contact_solver]",
                           "[linear_solver]",
                           "[time]",
                           "[output]",
                           "[report]",
                           "[[probes]]",
                           "[[events]]",
                           "[[criteria]]",
                           "[sensitivity]"}));
}

TEST(KeySections, EveryKeyStandsInOneOfThem) {
  const std::vector<KeyInfo> keys = schema(test_vocabulary());
  Lines all;
  for (const KeyInfo& key : keys) all.push_back(key.path);
  Lines found = paths(sections());
  std::sort(all.begin(), all.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, all);
}

TEST(KeySections, KeysWrittenInlineStandAmongThoseAroundThem) {
  for (const KeySection& section : sections()) {
    for (const KeyInfo& key : section.keys) {
      if (key.path == "loads[].rotation.axis") {
        EXPECT_EQ(section.name(key), "rotation.axis");
      }
      if (key.path == "time.output.count") {
        EXPECT_EQ(section.title, "[time]");
      }
      if (key.path == "materials.<name>.rupture.alpha") {
        EXPECT_EQ(section.name(key), "alpha");
      }
    }
  }
}

TEST(KeySections, OfAStudy) {
  Lines titles;
  for (const KeySection& section : key_sections(study_schema())) titles.push_back(section.title);
  for (const char* title : {"", "[[axes]]", "[[runs]]", "[[runs.axes]]", "[reference]", "[compare]"})
    EXPECT_NE(std::find(titles.begin(), titles.end(), title), titles.end()) << title;
}

TEST(KeySelection, PathWithAllBelowIt) {
  EXPECT_EQ(selected("time.output"),
            (Lines{"time.output", "time.output.first", "time.output.count", "time.output.spacing"}));
  EXPECT_EQ(selected("contacts[0].gap"), Lines{"contacts[].gap"});
  EXPECT_EQ(selected("contacts.12.gap"), Lines{"contacts[].gap"});
  EXPECT_EQ(selected("materials.steel.young_modulus"), Lines{"materials.<name>.young_modulus"});
  EXPECT_EQ(selected("materials.steel.creep[1].rate"), Lines{"materials.<name>.creep[].rate"});
}

TEST(KeySelection, OneTable) {
  EXPECT_EQ(selected("[output]"),
            (Lines{"output.directory", "output.fields", "output.frd", "output.revolve", "output.unit_names",
                   "output.separator", "output.decimal", "output.checkpoint_seconds"}));
  EXPECT_EQ(selected("[bodies.shaft]"),
            (Lines{"bodies.<name>.region", "bodies.<name>.material", "bodies.<name>.thickness",
                   "bodies.<name>.axial_force", "bodies.<name>.material_axes"}));
  const Lines material = selected("[materials.<name>]");
  EXPECT_NE(std::find(material.begin(), material.end(), "materials.<name>.rupture"), material.end());
  EXPECT_EQ(std::find(material.begin(), material.end(), "materials.<name>.rupture.alpha"), material.end());
  EXPECT_EQ(selected("[]").front(), "title");
  EXPECT_EQ(select_keys(sections(), "[]").size(), 1u);
}

TEST(KeySelection, WordInNamesOrValuesElseInDescriptions) {
  EXPECT_EQ(selected("Tolerance"), (Lines{"loads[].tolerance", "heat.tolerance", "contact_solver.tolerance",
                                          "time.tolerance", "time.inner_tolerance", "time.jump_tolerance"}));
  EXPECT_EQ(selected("hereditary"), (Lines{"materials.<name>.creep[].law", "materials.<name>.creep[].compliances",
                                           "materials.<name>.creep[].times"}));
  EXPECT_EQ(selected("active_set"), Lines{"contact_solver.method"});
  EXPECT_EQ(selected("mass per volume"), (Lines{"materials.<name>.density", "loads[].rotation.density"}));
}

TEST(KeySelection, NothingFoundNamesTheNearest) {
  EXPECT_TRUE(creepcontact::test::says(creepcontact::test::message_of<ConfigError>([] { selected("toleranze"); }),
                                       {"'toleranze'", "'tolerance'"}));
  EXPECT_THROW(selected("[tims]"), ConfigError);
  EXPECT_THROW(selected(""), ConfigError);
}

TEST(KeyMarkdown, RowsOfATable) {
  const std::string text = key_markdown(select_keys(sections(), "[time]"), false);
  EXPECT_EQ(text.substr(0, text.find('\n')), "| key | type | default | meaning |");
  EXPECT_NE(text.find("\n| `end` | number >= 0 [time] | *required* | "), std::string::npos) << text;
  EXPECT_NE(text.find("| `tolerance` | number in (0, 0.5] | `0.0001` | "), std::string::npos) << text;
  EXPECT_NE(text.find("| `inner` | `\"fixed_point\"`, `\"newton\"` | `\"fixed_point\"` | "), std::string::npos) << text;
  EXPECT_NE(text.find("| `breakpoints` | list of numbers >= 0 [time] | `[]` | "), std::string::npos) << text;
  EXPECT_EQ(text.find("###"), std::string::npos);
}

TEST(KeyMarkdown, TypesInFewWords) {
  const std::string text = key_markdown(sections(), true);
  EXPECT_NE(text.find("| `young_modulus` | function of T, > 0 [stress] | required without `orthotropic`, unless only "
                      "the heat is computed |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| `traction` | `[x, y, z]`, functions of x, y, z, t [stress] |"), std::string::npos) << text;
  EXPECT_NE(text.find("| `directory` | path | `results/<name of the configuration>` |"), std::string::npos) << text;
  EXPECT_NE(text.find("| `creep` | [`[[materials.<name>.creep]]`](#materialsnamecreep) | elastic |"), std::string::npos)
      << text;
  EXPECT_NE(text.find("### `[contact_solver]`\n\n| key |"), std::string::npos) << text;
}

TEST(KeyMarkdown, KeysOfALawInOneRow) {
  const std::string text = key_markdown(select_keys(sections(), "[materials.<name>.creep]"), false);
  EXPECT_TRUE(has_line(text, "| `\"hereditary\"` |  | `compliances`, `times` |")) << text;
  EXPECT_TRUE(has_line(text, "| `\"picky\"` |  | `m` [`Q`] |")) << text;
  EXPECT_EQ(text.find("| `m` |"), std::string::npos) << text;
}

TEST(KeyListing, FitsATerminal) {
  const std::string text = key_listing(sections());
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    EXPECT_LE(end - begin, 100u) << text.substr(begin, end - begin);
    begin = end + 1;
  }
  EXPECT_EQ(text.find('`'), std::string::npos);
  EXPECT_NE(text.find("\n[time]  time integration; required\n  end "), std::string::npos) << text;
  EXPECT_NE(text.find("number in (0, 0.5]; default 0.0001\n"), std::string::npos) << text;
}

TEST(KeyNames, AsAfterSet) {
  const std::string names = key_names(sections());
  for (const char* name : {"title", "time.output", "time.output.first", "contacts[].gap", "mesh.parameters",
                           "materials.<name>.creep[].rate", "loads[].rotation"})
    EXPECT_TRUE(has_line(names, name)) << name;
  EXPECT_FALSE(has_line(names, "time"));
  EXPECT_FALSE(has_line(names, "materials.<name>.creep"));
}

TEST(KeyValues, Words) {
  EXPECT_EQ(key_values(select_keys(sections(), "time.step")), "stable\nadaptive\n");
  EXPECT_EQ(key_values(select_keys(sections(), "output.fields")), "true\nfalse\n");
  EXPECT_EQ(key_values(select_keys(sections(), "contacts[3].gap")), "geometric\n");
  EXPECT_EQ(key_values(select_keys(sections(), "time.integrator")),
            "explicit_euler\nbeta_euler\ncvode_bdf\narkode_erk\n");
  EXPECT_EQ(key_values(select_keys(sections(), "time.end")), "");
}

/// A word that the reference offers must be one that the reader takes.
TEST(KeyValues, AreAllowed) {
  for (const KeySection& section : sections()) {
    if (section.title != "[time]" && section.title != "[contact_solver]" && section.title != "[output]") continue;
    for (const KeyInfo& key : section.keys) {
      for (const Word& word : key.words) {
        if (key.path.starts_with("time.output.")) continue;  // a table of its own decides
        std::vector<std::string> overrides{key.path + '=' + word.text};
        if (key.path == "time.jump_cycles") overrides.emplace_back("time.cycle=0.25");  // which it needs
        EXPECT_TRUE(mistakes(minimal, overrides).empty()) << key.path << " = " << word.text;
      }
    }
  }
}

}  // namespace
}  // namespace creepcontact::config
