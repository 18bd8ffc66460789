#include "comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/plot/overlay_plots.hpp"
#include "run_sections.hpp"

namespace creepcontact::report {
namespace {

using Row = std::vector<std::string>;

/// One row: a value of each run, "-" where it has none.
Row row(const std::string& name, const std::vector<RunData>& runs,
        const std::function<std::string(const io::Summary&)>& value) {
  Row cells{name};
  for (const RunData& run : runs) {
    const std::string cell = run.summary ? value(*run.summary) : "";
    cells.push_back(cell.empty() ? "-" : cell);
  }
  return cells;
}

template <typename Map>
std::set<std::string> names_in_all(const std::vector<RunData>& runs, Map io::Summary::*member) {
  std::set<std::string> names;
  for (const RunData& run : runs)
    if (run.summary)
      for (const auto& [name, value] : (*run.summary).*member) names.insert(name);
  return names;
}

}  // namespace

void add_comparison(const std::vector<RunData>& runs, Drawings& drawings, Html& page) {
  page.element("h2", "Comparison");
  Row head{""};
  for (const RunData& run : runs) head.push_back(run.label);
  std::vector<Row> rows;
  Row status{"ended"};
  for (const RunData& run : runs) status.push_back(ending(run).empty() ? "completed" : "early");
  rows.push_back(status);
  rows.push_back(row("time reached", runs, [](const io::Summary& s) { return number(s.time_reached); }));
  rows.push_back(row("last output, the end of these values", runs,
                     [](const io::Summary& s) { return number(s.last_output.value_or(s.time_reached)); }));
  for (const std::string& name : names_in_all(runs, &io::Summary::contacts)) {
    const auto of = [&](double io::Summary::Course::*member) {
      return [&name, member](const io::Summary& s) {
        const auto found = s.contacts.find(name);
        return found == s.contacts.end() ? "" : number(found->second.normal_force.*member);
      };
    };
    rows.push_back(row(fmt::format("normal force of {}, start", name), runs, of(&io::Summary::Course::start)));
    rows.push_back(row(fmt::format("normal force of {}, largest", name), runs, of(&io::Summary::Course::largest)));
    rows.push_back(row(fmt::format("normal force of {}, end", name), runs, of(&io::Summary::Course::end)));
  }
  for (const std::string& name : names_in_all(runs, &io::Summary::probes)) {
    const auto of = [&](double io::SummaryProbe::Course::*member) {
      return [&name, member](const io::Summary& s) {
        const auto found = s.probes.find(name);
        return found == s.probes.end() || !found->second.course ? "" : number((*found->second.course).*member);
      };
    };
    rows.push_back(row(fmt::format("{}, start", name), runs, of(&io::SummaryProbe::Course::start)));
    rows.push_back(row(fmt::format("{}, end", name), runs, of(&io::SummaryProbe::Course::end)));
  }
  for (const std::string& name : names_in_all(runs, &io::Summary::events))
    rows.push_back(row(fmt::format("event {}", name), runs, [&](const io::Summary& s) {
      const auto found = s.events.find(name);
      return found == s.events.end() ? "" : found->second ? number(*found->second) : "never";
    }));
  rows.push_back(row("steps", runs, [](const io::Summary& s) { return std::to_string(s.steps); }));
  rows.push_back(row("computing time [s]", runs, [](const io::Summary& s) { return number(s.wall_seconds.total); }));
  page.table(head, rows, "Results of all runs, in the units of each");

  std::vector<plot::RunTables> tables;
  std::vector<std::string> labels;
  for (const RunData& run : runs)
    if (run.tables && run.tables->history.rows() > 1) {
      tables.push_back(*run.tables);
      labels.push_back(run.label);
    }
  if (tables.size() < 2) return;
  try {
    for (const plot::NamedCurves& one : plot::overlaid(tables, labels, "", {})) {
      plot::Figure figure{one.curves.title, one.curves.x, {{one.curves.y, {}}}};
      for (const plot::Series& series : one.curves.series)
        if (figure.panels[0].series.size() < plot::max_series) figure.panels[0].series.push_back(series);
      if (!figure.panels[0].series.empty())
        drawings.add(figure, fmt::format("Histories of {} of all runs", one.name), page);
    }
  } catch (const ConfigError& error) {
    page.element("p", error.what());
  }
}

}  // namespace creepcontact::report
