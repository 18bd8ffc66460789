#include "unit/config/config_fixture.hpp"

#include "support/says.hpp"

namespace creepcontact::config {

Config parse_text(const std::string& text, const std::vector<std::string>& overrides) {
  return parse(text, "cases/block.toml", test_vocabulary(), overrides);
}

std::vector<std::string> mistakes(const std::string& text, const std::vector<std::string>& overrides) {
  std::vector<std::string> lines;
  try {
    parse_text(text, overrides);
  } catch (const ConfigError& error) {
    std::string message = error.what();
    std::size_t begin = 0;
    for (std::size_t end = message.find('\n'); end != std::string::npos; end = message.find('\n', begin)) {
      lines.push_back(message.substr(begin, end - begin));
      begin = end + 1;
    }
    lines.push_back(message.substr(begin));
  }
  return lines;
}

void expect_mistake(const std::string& text, std::initializer_list<std::string_view> facts,
                    const std::vector<std::string>& overrides) {
  const std::vector<std::string> lines = mistakes(text, overrides);
  ASSERT_EQ(lines.size(), 1u) << (lines.empty() ? "no mistake found" : lines[0] + "\n" + lines.back());
  EXPECT_TRUE(lines[0].starts_with(*facts.begin())) << *facts.begin() << "\n--- in\n" << lines[0];
  EXPECT_TRUE(test::says(lines[0], facts));
}

}  // namespace creepcontact::config
