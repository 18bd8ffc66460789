#include "butcher_tables.hpp"

#include <arkode/arkode_butcher_dirk.h>
#include <arkode/arkode_butcher_erk.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <memory>

#include "creepcontact/base/error.hpp"

namespace creepcontact::ode {

namespace {

const std::string prefix = "arkode_";

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

struct TableDeleter {
  void operator()(ARKodeButcherTable table) const { ARKodeButcherTable_Free(table); }
};

/// @param load  of SUNDIALS, by ARKODE's name
template <typename Load>
std::vector<ButcherTable> embedded(std::initializer_list<const char*> names, Load load) {
  std::vector<ButcherTable> tables;
  for (const char* name : names) {
    const std::unique_ptr<ARKodeButcherTableMem, TableDeleter> table(load(name));
    if (table && table->d) tables.push_back({lower_case(name).substr(prefix.size()), name, table->q});
  }
  return tables;
}

}  // namespace

const std::vector<ButcherTable>& explicit_tables() {
  static const std::vector<ButcherTable> tables =
      embedded({"ARKODE_HEUN_EULER_2_1_2", "ARKODE_BOGACKI_SHAMPINE_4_2_3", "ARKODE_ARK324L2SA_ERK_4_2_3",
                "ARKODE_ZONNEVELD_5_3_4", "ARKODE_ARK436L2SA_ERK_6_3_4", "ARKODE_SAYFY_ABURUB_6_3_4",
                "ARKODE_CASH_KARP_6_4_5", "ARKODE_FEHLBERG_6_4_5", "ARKODE_DORMAND_PRINCE_7_4_5",
                "ARKODE_ARK548L2SA_ERK_8_4_5", "ARKODE_VERNER_8_5_6", "ARKODE_FEHLBERG_13_7_8",
                "ARKODE_KNOTH_WOLKE_3_3", "ARKODE_ARK437L2SA_ERK_7_3_4", "ARKODE_ARK548L2SAb_ERK_8_4_5"},
               ARKodeButcherTable_LoadERKByName);
  return tables;
}

const std::vector<ButcherTable>& diagonally_implicit_tables() {
  static const std::vector<ButcherTable> tables = embedded({"ARKODE_SDIRK_2_1_2",
                                                            "ARKODE_BILLINGTON_3_3_2",
                                                            "ARKODE_TRBDF2_3_3_2",
                                                            "ARKODE_KVAERNO_4_2_3",
                                                            "ARKODE_ARK324L2SA_DIRK_4_2_3",
                                                            "ARKODE_CASH_5_2_4",
                                                            "ARKODE_CASH_5_3_4",
                                                            "ARKODE_SDIRK_5_3_4",
                                                            "ARKODE_KVAERNO_5_3_4",
                                                            "ARKODE_ARK436L2SA_DIRK_6_3_4",
                                                            "ARKODE_KVAERNO_7_4_5",
                                                            "ARKODE_ARK548L2SA_DIRK_8_4_5",
                                                            "ARKODE_ARK437L2SA_DIRK_7_3_4",
                                                            "ARKODE_ARK548L2SAb_DIRK_8_4_5",
                                                            "ARKODE_ESDIRK324L2SA_4_2_3",
                                                            "ARKODE_ESDIRK325L2SA_5_2_3",
                                                            "ARKODE_ESDIRK32I5L2SA_5_2_3",
                                                            "ARKODE_ESDIRK436L2SA_6_3_4",
                                                            "ARKODE_ESDIRK43I6L2SA_6_3_4",
                                                            "ARKODE_QESDIRK436L2SA_6_3_4",
                                                            "ARKODE_ESDIRK437L2SA_7_3_4",
                                                            "ARKODE_ESDIRK547L2SA_7_4_5",
                                                            "ARKODE_ESDIRK547L2SA2_7_4_5"},
                                                           ARKodeButcherTable_LoadDIRKByName);
  return tables;
}

const ButcherTable& find_table(const std::vector<ButcherTable>& tables, const std::string& name) {
  std::string wanted = lower_case(name);
  if (wanted.starts_with(prefix)) wanted.erase(0, prefix.size());
  const auto found = std::ranges::find(tables, wanted, &ButcherTable::name);
  if (found == tables.end())
    throw ConfigError(
        fmt::format("table = \"{}\": there is no such table with an embedded method, which the control of the step "
                    "needs; allowed: {}",
                    name, fmt::join(table_names(tables), ", ")));
  return *found;
}

std::vector<std::string> table_names(const std::vector<ButcherTable>& tables) {
  std::vector<std::string> names;
  names.reserve(tables.size());
  for (const ButcherTable& table : tables) names.push_back(table.name);
  return names;
}

}  // namespace creepcontact::ode
