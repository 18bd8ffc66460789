#include "creepcontact/simulation/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/material/life_fraction.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/simulation/quantities.hpp"

namespace creepcontact::simulation {
namespace {

using Row = std::vector<std::string>;

/// Columns as wide as their longest entry.
std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> width;
  for (const Row& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += c + 1 < row.size() ? fmt::format("{:<{}}  ", row[c], width[c]) : row[c];
    text += line + "\n";
  }
  return text;
}

std::string list_integrators() {
  std::vector<Row> rows;
  for (const ode::IntegratorInfo& info : ode::integrators()) rows.push_back({info.name, info.description});
  return table(rows);
}

std::string list_laws() {
  std::vector<Row> rows;
  for (const material::LawInfo& law : material::creep_laws()) {
    rows.push_back({law.name, law.formula + "   (" + law.source + ")"});
    for (const material::ParameterInfo& parameter : law.parameters)
      rows.push_back({"  " + parameter.key, parameter.description});
  }
  return table(rows);
}

std::string list_elements() {
  using mesh::CellType;
  std::vector<Row> rows;
  for (const CellType type : {CellType::tet4, CellType::tet10, CellType::hex8, CellType::hex20, CellType::hex27,
                              CellType::wedge6, CellType::wedge15}) {
    const fem::ReferenceElement& element = fem::reference_element(type);
    std::string remark = fmt::format("{} nodes, {} integration points", element.n_nodes(), element.rule().size());
    if (element.averages_volumetric_strain()) remark += ", B-bar";
    if (type == CellType::tet4) remark += "; locks under creep, use tet10";
    rows.push_back({std::string(mesh::name(type)), remark});
  }
  return table(rows);
}

std::string list_quantities() {
  std::vector<Row> rows;
  for (const QuantityInfo& info : quantities())
    rows.push_back({info.name,
                    info.kind == QuantityInfo::Kind::field      ? "point, surface, body"
                    : info.kind == QuantityInfo::Kind::reaction ? "supported group"
                                                                : "contact surface",
                    info.description});
  return table(rows);
}

/// Makes the law, to see what it says.
config::LawVerdict judge(const material::LawInfo& info, const material::ParameterValues& values) {
  try {
    const auto law = info.make(values);
    const auto& parameters = law->parameters();
    const bool by_temperature = std::any_of(parameters.begin(), parameters.end(),
                                            [](const Function& value) { return value.depends_on_temperature(); });
    return {.mistake = {}, .depends_on_temperature = by_temperature};
  } catch (const material::ParameterError& error) {
    return {.mistake = config::LawMistake{error.key(), error.found(), error.allowed()}};
  }
}

std::optional<config::LawMistake> judge_larson_miller(const std::vector<double>& stress,
                                                      const std::vector<double>& parameter) {
  try {
    material::larson_miller({.stress = stress, .parameter = parameter});
    return std::nullopt;
  } catch (const material::ParameterError& error) {
    return config::LawMistake{error.key(), error.found(), error.allowed()};
  }
}

}  // namespace

config::Vocabulary vocabulary() {
  config::Vocabulary result;
  for (const material::LawInfo& law : material::creep_laws()) {
    config::Law entry{law.name, {}, {}};
    for (const material::ParameterInfo& parameter : law.parameters) {
      config::LawKey key;
      key.name = parameter.key;
      key.description = parameter.description;
      key.minimum = parameter.minimum;
      key.strict = parameter.strict;
      key.list = parameter.list;
      key.variables = parameter.variables;
      key.required = !parameter.fallback;
      key.fallback = parameter.fallback.value_or(std::vector<Function>{});
      key.maximum = parameter.maximum;
      entry.keys.push_back(key);
    }
    entry.judge = [&law](const material::ParameterValues& values) { return judge(law, values); };
    result.laws.push_back(std::move(entry));
  }
  result.judge_larson_miller = judge_larson_miller;
  for (const ode::IntegratorInfo& info : ode::integrators()) {
    result.integrators.push_back(info.name);
    if (!info.tables.empty()) result.tables[info.name] = info.tables;
  }
  for (const QuantityInfo& info : quantities()) {
    config::Quantity entry;
    entry.name = info.name;
    entry.surface_only = info.kind != QuantityInfo::Kind::field;
    entry.sum_only = info.kind == QuantityInfo::Kind::area || info.kind == QuantityInfo::Kind::force ||
                     info.kind == QuantityInfo::Kind::reaction;
    result.quantities.push_back(entry);
  }
  return result;
}

std::string list(const std::string& what) {
  if (what == "integrators") return list_integrators();
  if (what == "laws") return list_laws();
  if (what == "elements") return list_elements();
  if (what == "quantities") return list_quantities();
  throw ConfigError(fmt::format("list: '{}' is unknown; there are integrators, laws, elements, quantities", what));
}

}  // namespace creepcontact::simulation
