#pragma once
/// Makes a configuration and its mesh of a deck.

#include <string>
#include <vector>

#include "creepcontact/config/writer.hpp"
#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

struct Import {
  config::Config config;
  config::Comments comments;  ///< on what each table comes from
  std::string msh;            ///< content of the mesh file
  /// Names and contents of the tables that the configuration names: temperatures, initial stresses.
  std::vector<std::pair<std::string, std::string>> tables = {};
  std::vector<std::string> found;     ///< one line per contact that the deck does not name: place, card, what it is
  std::vector<std::string> left_out;  ///< one line per card not taken into account or missed: place, card, consequence
};

/// @param name  of the mesh file, which the configuration names, and of its tables: <name>.msh, <name>_temperature.csv,
/// <name>_stress_1.csv
/// @throws ConfigError with all reasons, a line each, why the deck makes no model
Import import_deck(Deck deck, const std::string& name);

}  // namespace creepcontact::deck
