#pragma once
/// The mistakes that a configuration or a study is told.

#include <sstream>
#include <string>
#include <vector>

#include "creepcontact/base/error.hpp"

namespace creepcontact::config {

/// The lines of the ConfigError that an action throws; none if it throws nothing.
template <class Action>
std::vector<std::string> complaints(Action action) {
  std::vector<std::string> lines;
  try {
    action();
  } catch (const ConfigError& error) {
    std::istringstream text(error.what());
    for (std::string line; std::getline(text, line);) lines.push_back(line);
  }
  return lines;
}

}  // namespace creepcontact::config
