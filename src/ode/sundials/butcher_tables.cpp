#include "butcher_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "creepcontact/base/error.hpp"

namespace creepcontact::ode {

namespace {

const std::string prefix = "arkode_";

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

const std::vector<ButcherTable>& explicit_tables() {
  static const std::vector<ButcherTable> tables{
      {"bogacki_shampine_4_2_3", "ARKODE_BOGACKI_SHAMPINE_4_2_3", 3},
      {"dormand_prince_7_4_5", "ARKODE_DORMAND_PRINCE_7_4_5", 5},
  };
  return tables;
}

const std::vector<ButcherTable>& diagonally_implicit_tables() {
  static const std::vector<ButcherTable> tables{{"ark324l2sa_dirk_4_2_3", "ARKODE_ARK324L2SA_DIRK_4_2_3", 3}};
  return tables;
}

const ButcherTable& find_table(const std::vector<ButcherTable>& tables, const std::string& name) {
  std::string wanted = lower_case(name);
  if (wanted.starts_with(prefix)) wanted.erase(0, prefix.size());
  const auto found = std::ranges::find(tables, wanted, &ButcherTable::name);
  if (found == tables.end())
    throw ConfigError(
        fmt::format("table = \"{}\": there is no such table; allowed: {}", name, fmt::join(table_names(tables), ", ")));
  return *found;
}

std::vector<std::string> table_names(const std::vector<ButcherTable>& tables) {
  std::vector<std::string> names;
  names.reserve(tables.size());
  for (const ButcherTable& table : tables) names.push_back(table.name);
  return names;
}

}  // namespace creepcontact::ode
