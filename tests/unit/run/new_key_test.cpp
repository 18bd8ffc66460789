/// A kind of load that is declared once, as a table of keys, is known to all who derive something from the keys.
#include "../../../src/config/configured_values.hpp"
#include "../../../src/config/table.hpp"
#include "../../../src/config/tables.hpp"
#include "../../../src/config/toml_document.hpp"
#include "../../../src/run/fingerprint.hpp"
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

/// The configuration of the blocks, with what the site's keys add to it.
config::Config with_wind(const Case& blocks, const std::string& wind) {
  config::Config result = blocks.config();
  const toml::table document = config::parse_toml("[[winds]]\n" + wind, "site.toml", {});
  config::Context context;
  const config::Value<Site> table = site_table();
  EXPECT_TRUE(table.read({&document, {}}, context));
  EXPECT_TRUE(context.errors.empty());
  result.functions.insert(result.functions.end(), context.functions.begin(), context.functions.end());
  const auto values = config::configured_values(document, table.keys);
  result.values.insert(result.values.end(), values.begin(), values.end());
  return result;
}

TEST(NewKey, IsKnownToTheBreakpoints) {
  const Case blocks;
  EXPECT_EQ(build_model(blocks.config()).breakpoints, std::vector<double>());
  const Model table = build_model(with_wind(blocks, "speed = { t = [0, 1, 1, 3], values = [0, 0, 5, 5] }"));
  EXPECT_EQ(table.breakpoints, (std::vector<double>{1, 3}));
  const Model kink = build_model(with_wind(blocks, "speed = 'abs(t - 2.5)'"));
  ASSERT_EQ(kink.breakpoints.size(), 1U);
  EXPECT_NEAR(kink.breakpoints[0], 2.5, 1e-9);
}

TEST(NewKey, IsKnownToTheFingerprint) {
  const Case blocks;
  const Model model = build_model(blocks.config());
  const auto changes = [&](const std::string& before, const std::string& now) {
    return differences(fingerprint(with_wind(blocks, before), model), fingerprint(with_wind(blocks, now), model));
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(changes("speed = 3", "speed = 3.0\nheight = 2"), Lines()) << "equal values, and a default";
  EXPECT_EQ(changes("speed = 3", "speed = '3*t'"), Lines({R"(winds[0].speed was 3 and is now "3*t")"}));
  EXPECT_EQ(changes("speed = 3", "speed = 3\nheight = 10"), Lines({"winds[0].height was 2 and is now 10"}));
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
