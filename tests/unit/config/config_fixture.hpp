#pragma once
/// A complete configuration, and the lines of the message that a wrong one gives.

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>
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

Config parse_text(const std::string& text, const std::vector<std::string>& overrides = {});

/// The lines of the ConfigError; empty if there is none.
std::vector<std::string> mistakes(const std::string& text, const std::vector<std::string>& overrides = {});

/// Expects exactly one mistake, whose line begins with the first fact (the place and the key) and then names the
/// others.
void expect_mistake(const std::string& text, std::initializer_list<std::string_view> facts,
                    const std::vector<std::string>& overrides = {});

}  // namespace creepcontact::config
