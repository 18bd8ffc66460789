/// A kind of load that is declared once, as a table of keys, is known to all who derive something from the keys.
#include "../../../src/config/configured_values.hpp"
#include "../../../src/config/table.hpp"
#include "../../../src/config/tables.hpp"
#include "../../../src/config/toml_document.hpp"
#include "creepcontact/config/key_reference.hpp"
#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

struct Wind {
  Function speed;
  double height = 2;
};

struct Site {
  std::vector<Wind> winds;
};

/// All that this test declares.
config::Value<Site> site_table() {
  const auto wind = config::table<Wind>({
      config::field<Wind>("speed", &Wind::speed, config::function(config::position_and_time, config::at_least(0)),
                          "of the air", config::Presence::required)
          .in("length/time"),
      config::field<Wind>("height", &Wind::height, config::number(config::greater(0)), "of the reference point"),
  });
  return config::table<Site>({config::field<Site>("winds", &Site::winds, config::tables(wind), "a load of fancy")});
}

Site site(const std::string& wind) {
  const toml::table document = config::parse_toml("[[winds]]\n" + wind, "site.toml", {});
  config::Context context;
  const auto result = site_table().read({&document, {}}, context);
  EXPECT_TRUE(result);
  EXPECT_TRUE(context.errors.empty());
  return result.value_or(Site());
}

std::vector<std::string> values(const Site& of) {
  std::vector<std::string> lines;
  for (const config::ConfiguredValue& value : config::values_of(site_table(), of, true))
    lines.push_back(value.key + " " + value.text);
  return lines;
}

TEST(NewKey, IsKnownToTheFunctions) {
  const auto functions =
      config::functions_of(site_table(), site("speed = { t = [0, 1, 1, 3], values = [0, 0, 5, 5] }"));
  ASSERT_EQ(functions.size(), 1U);
  EXPECT_EQ(functions[0].key, "winds[0].speed");
  EXPECT_EQ(functions[0].value.breakpoints(), (std::vector<double>{0, 1, 3}));
  EXPECT_EQ(functions[0].variables, config::position_and_time);
}

TEST(NewKey, IsKnownToTheValues) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(values(site("speed = 3")), (Lines{"winds[0].speed 3", "winds[0].height 2"}));
  EXPECT_EQ(values(site("speed = 3")), values(site("speed = 3.0\nheight = 2"))) << "equal values, and a default";
  EXPECT_EQ(values(site("speed = '3*t'\nheight = 10")), (Lines{R"(winds[0].speed "3*t")", "winds[0].height 10"}));
}

TEST(NewKey, IsKnownOfAStructThatWasNotRead) {
  Site made;
  made.winds.push_back({Function::table("t", {0, 1}, {0, 5}), 2});
  EXPECT_EQ(values(made), values(site("speed = { t = [0, 1], values = [0, 5] }")));
}

TEST(NewKey, IsKnownToTheReference) {
  const std::vector<config::KeySection> sections = config::key_sections(site_table().keys);
  for (const std::string& text : {config::key_markdown(sections, true), config::key_listing(sections)}) {
    EXPECT_TRUE(contains(text, "[[winds]]")) << text;
    EXPECT_TRUE(contains(text, "function of x, y, z, t, >= 0 [length/time]")) << text;
    EXPECT_TRUE(contains(text, "of the reference point")) << text;
  }
  EXPECT_TRUE(contains(config::key_names(sections), "winds[].height\n"));
  const config::Json schema = site_table().json(), wind = schema["properties"]["winds"]["items"];
  EXPECT_EQ(wind["required"], config::Json::array({"speed"}));
  EXPECT_EQ(wind["properties"]["height"]["default"], 2);
  EXPECT_EQ(wind["properties"]["height"]["exclusiveMinimum"], 0);
}

}  // namespace
}  // namespace creepcontact::run::test
