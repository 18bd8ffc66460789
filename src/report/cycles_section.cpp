/// What cycles of the loads do: tables per cycle, and creep against fatigue.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>

#include "creepcontact/base/error.hpp"
#include "engineering.hpp"
#include "interaction_diagram.hpp"
#include "run_sections.hpp"

namespace creepcontact::report {
namespace {

struct CycleColumn {
  const char *name, *title;
};
constexpr std::array of_body{CycleColumn{"inelastic_strain_range", "range of creep strain"},
                             CycleColumn{"strain_range", "strain range"},
                             CycleColumn{"damage", "damage"},
                             CycleColumn{"life_fraction", "creep life used"},
                             CycleColumn{"fatigue_fraction", "fatigue life used"},
                             CycleColumn{"creep_fatigue", "of the interaction diagram"},
                             CycleColumn{"cycles_to_limit", "cycles to the limit"}};

/// The first and the last ones of many.
std::vector<std::size_t> shown_rows(std::size_t n) {
  constexpr std::size_t most = 12, at_ends = 5;
  std::vector<std::size_t> rows(n);
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (n > most) rows.erase(rows.begin() + at_ends, rows.end() - at_ends);
  return rows;
}

void add_body(const std::string& body, const io::CsvTable& cycles, const RunData& run, Html& page) {
  std::vector<const std::vector<double>*> columns;
  std::vector<std::string> head{"cycle", labelled("end at t", run.unit(Dimension::time))};
  std::vector<bool> in_percent;
  for (const CycleColumn& one : of_body)
    if (const std::vector<double>* column = cycles.column(fmt::format("{}.{}", body, one.name))) {
      columns.push_back(column);
      head.emplace_back(one.title);
      const std::string_view name = one.name;
      in_percent.push_back(name.ends_with("_fraction") || name == "creep_fatigue");
    }
  if (columns.empty()) return;
  std::vector<Scale> scales;
  scales.reserve(columns.size());
  for (const std::vector<double>* column : columns) scales.emplace_back("", *column);
  const std::vector<double>&numbers = *cycles.column("cycle"), &times = cycles.columns[0];
  std::vector<std::vector<std::string>> rows;
  const std::vector<std::size_t> shown = shown_rows(cycles.rows());
  for (const std::size_t r : shown) {
    std::vector<std::string> row{engineering(numbers[r], 9), time_text(times[r], "")};
    for (std::size_t c = 0; c < columns.size(); ++c)
      row.push_back(in_percent[c] ? percent((*columns[c])[r]) : scales[c].text((*columns[c])[r]));
    rows.push_back(std::move(row));
  }
  page.table(head, rows,
             shown.size() < cycles.rows() ? fmt::format("Cycles of body {}, the first and the last ones", body)
                                          : fmt::format("Cycles of body {}", body));
}

void add_interaction(const std::vector<std::string>& bodies, const RunData& run, Drawings& drawings, Html& page) {
  if (const std::optional<plot::Figure> figure = interaction_figure(bodies, run.tables->cycles, run.record.inputs))
    drawings.add(*figure, "Interaction diagram: the largest shares of each body after every cycle, from the start on",
                 page);
}

}  // namespace

void add_cycles(const RunData& run, Drawings& drawings, Html& page) {
  if (!run.tables || run.tables->cycles.rows() == 0 || run.tables->cycles.column("cycle") == nullptr) return;
  constexpr std::size_t most_bodies = 8;
  const io::CsvTable& cycles = run.tables->cycles;
  page.open("section", "id=\"cycles\"");
  page.element("h2", "Cycles");
  std::vector<std::string> bodies;
  for (const std::string& name : cycles.names)
    if (const std::size_t dot = name.rfind('.'); dot != std::string::npos)
      if (const std::string body = name.substr(0, dot); std::ranges::count(bodies, body) == 0) bodies.push_back(body);
  for (std::size_t b = 0; b < std::min(bodies.size(), most_bodies); ++b) add_body(bodies[b], cycles, run, page);
  add_interaction(bodies, run, drawings, page);
  try {
    for (const plot::NamedFigure& one : plot::run_figures(*run.tables, {}))
      if (one.name.starts_with("cycles")) drawings.add(one.figure, "What changes from cycle to cycle", page);
  } catch (const ConfigError& error) {
    page.element("p", error.what());
  }
  page.close("section");
}

}  // namespace creepcontact::report
