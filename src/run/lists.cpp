#include "creepcontact/run/lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/bubble.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/material/law_reference.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::run {
namespace {

using Row = std::vector<std::string>;

struct Table {
  Row heads;
  std::vector<Row> rows;
};

/// Columns as wide as their longest entry.
std::string plain(const Table& table) {
  std::vector<std::size_t> width;
  for (const Row& row : table.rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  }
  std::string text;
  for (const Row& row : table.rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += c + 1 < row.size() ? fmt::format("{:<{}}  ", row[c], width[c]) : row[c];
    std::erase(line, '`');  // marks of code are for documents
    text += line + "\n";
  }
  return text;
}

/// Names of which the same is said share a row.
std::string markdown(const Table& table) {
  std::vector<Row> rows;
  for (const Row& row : table.rows) {
    const std::string name = '`' + row[0] + '`';
    if (!rows.empty() && std::equal(row.begin() + 1, row.end(), rows.back().begin() + 1)) {
      rows.back()[0] += ", " + name;
    } else {
      rows.push_back(row);
      rows.back()[0] = name;
    }
  }
  std::string text =
      fmt::format("| {} |\n|{}\n", fmt::join(table.heads, " | "), fmt::join(Row(table.heads.size(), "---|"), ""));
  for (const Row& row : rows) text += fmt::format("| {} |\n", fmt::join(row, " | "));
  return text;
}

Table integrators() {
  Table table{{"integrator", "what"}, {}};
  for (const ode::IntegratorInfo& info : ode::integrators()) table.rows.push_back({info.name, info.description});
  return table;
}

Table laws() {
  Table table{{"law", "what"}, {}};
  for (const material::LawInfo& law : material::creep_laws()) {
    table.rows.push_back({law.name, law.formula + "   (" + law.source + ")"});
    for (const material::ParameterInfo& parameter : law.parameters)
      table.rows.push_back({"  " + parameter.key, parameter.description});
  }
  return table;
}

std::string integration_points(mesh::CellType type) {
  const Index n = fem::reference_element(type).bulk_rule().size();
  const Index in_rings = fem::bulk_rule(type, {settings::Analysis::axisymmetric}).size();
  std::string text = fmt::format("{} integration point{}", n, n == 1 ? "" : "s");
  if (in_rings != n) text += fmt::format(" ({} in axisymmetric models)", in_rings);
  return text;
}

std::string remark(mesh::CellType type) {
  using mesh::CellType;
  const fem::ReferenceElement& element = fem::reference_element(type);
  std::string text = fmt::format("{}{} nodes, {}", mesh::dimension(type) == 2 ? "sections: " : "", element.n_nodes(),
                                 integration_points(type));
  if (element.locks()) {
    const char* const instead = type == CellType::tet4 ? "tet10" : type == CellType::tri3 ? "tri6" : "wedge15";
    return text + fmt::format("; locks under creep: use {}, or set mesh.allow_locking = true", instead);
  }
  return text + fmt::format("; mean stress {} in the element{}",
                            element.volumetric_strain() == fem::Projection::linear ? "linear" : "constant",
                            fem::has_bubble(type) ? ", one inner displacement" : "");
}

Table elements() {
  Table table{{"element", "what"}, {}};
  for (const mesh::CellType type : mesh::volume_cell_types())
    table.rows.push_back({std::string(mesh::name(type)), remark(type)});
  for (const mesh::CellType type : mesh::cell_types())
    if (mesh::dimension(type) == 2) table.rows.push_back({std::string(mesh::name(type)), remark(type)});
  return table;
}

Table quantity_table() {
  Table table{{"quantity", "where", "dimension", "what"}, {}};
  for (const results::Quantity& quantity : results::quantities()) {
    const results::OutputVariable& variable = *quantity.variable;
    table.rows.push_back({quantity.name, std::string(variable.places()),
                          variable.dimension == Dimension::none ? "-" : name_of(variable.dimension),
                          variable.description});
  }
  return table;
}

Table table_of(const std::string& what) {
  if (what == "integrators") return integrators();
  if (what == "laws") return laws();
  if (what == "elements") return elements();
  if (what == "quantities") return quantity_table();
  throw ConfigError(fmt::format("list: '{}' is unknown; there are integrators, laws, elements, quantities", what));
}

}  // namespace

std::string list(const std::string& what) {
  return plain(table_of(what));
}

std::string list_markdown(const std::string& what) {
  return what == "laws" ? material::law_reference() : markdown(table_of(what));
}

}  // namespace creepcontact::run
