#pragma once
/// Butcher tables of ARKODE by name: those that save solves.

#include <string>
#include <vector>

namespace creepcontact::ode {

struct ButcherTable {
  std::string name;         ///< "dormand_prince_7_4_5": author, stages, orders of the embedded method and of the method
  std::string arkode_name;  ///< "ARKODE_DORMAND_PRINCE_7_4_5"
  int order = 0;
};

/// The default comes first.
const std::vector<ButcherTable>& explicit_tables();
const std::vector<ButcherTable>& diagonally_implicit_tables();

/// @param name  in upper or lower case, with or without ARKODE's prefix
/// @throws ConfigError naming the tables that there are
const ButcherTable& find_table(const std::vector<ButcherTable>& tables, const std::string& name);

/// What a configuration may ask for.
std::vector<std::string> table_names(const std::vector<ButcherTable>& tables);

}  // namespace creepcontact::ode
