#pragma once
/// A complete configuration, and the lines of the message that a wrong one gives.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/reader.hpp"
#include "unit/config/test_vocabulary.hpp"

namespace creepcontact::config {

/// The smallest configuration that is right: 11 lines, so that what is appended begins in line 12.
inline const std::string minimal = R"([mesh]
file = "block.msh"
[bodies.block]
region = "all"
material = "steel"
[materials.steel]
young_modulus = 2e5
poisson_ratio = 0.3

[time]
end = 100
)";

inline Config parse_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse(text, "cases/block.toml", test_vocabulary(), overrides);
}

/// The lines of the ConfigError; empty if there is none.
inline std::vector<std::string> mistakes(const std::string& text, const std::vector<std::string>& overrides = {}) {
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

/// Expects exactly one mistake, with this text (from its start; the rest of the line is what is allowed).
inline void expect_mistake(const std::string& text, const std::string& begin,
                           const std::vector<std::string>& overrides = {}) {
  const std::vector<std::string> lines = mistakes(text, overrides);
  ASSERT_EQ(lines.size(), 1u) << (lines.empty() ? "no mistake found" : lines[0] + "\n" + lines.back());
  EXPECT_EQ(lines[0].substr(0, begin.size()), begin) << "in " << lines[0];
}

}  // namespace creepcontact::config
