#pragma once
/// *SURFACE INTERACTION with the cards below it: what acts between surfaces.

#include <map>
#include <optional>
#include <string>

#include "draft.hpp"

namespace creepcontact::deck {

struct Interaction {
  Course friction;
  bool tied = false;
  std::string name = {};
  std::string gasket = {};  ///< of the configuration
  std::optional<Function> conductance = {};
};
using Interactions = std::map<std::string, Interaction>;  // by name in upper case

/// Reads all interactions, with *CHANGE FRICTION of the steps; adds the gaskets of their curves to the configuration.
Interactions read_interactions(Draft& draft);

}  // namespace creepcontact::deck
