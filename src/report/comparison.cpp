#include "comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/plot/overlay_plots.hpp"
#include "engineering.hpp"
#include "run_sections.hpp"

namespace creepcontact::report {
namespace {

constexpr std::size_t runs_side_by_side = 5;  // on paper
constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Value = std::function<double(const io::Summary&)>;

/// A table whose columns are runs. Many runs make several tables below each other.
class RunTable {
 public:
  RunTable(const std::vector<RunData>& runs, std::string first) : runs_(runs), first_(std::move(first)) {}

  void add_texts(const std::string& name, std::vector<std::string> cells) {
    if (std::ranges::all_of(cells, [](const std::string& cell) { return cell == "-"; })) return;
    cells.insert(cells.begin(), name);
    rows_.push_back(std::move(cells));
  }
  void add_texts(const std::string& name, const std::function<std::string(const RunData&)>& text) {
    std::vector<std::string> cells;
    for (const RunData& run : runs_) {
      const std::string cell = text(run);
      cells.push_back(cell.empty() ? "-" : cell);
    }
    add_texts(name, std::move(cells));
  }
  /// Rows in a common unit. @param unit  as in the results
  void add(const std::vector<std::pair<std::string, Value>>& rows, const std::string& unit) {
    std::vector<std::vector<double>> values;
    std::vector<double> all;
    for (const auto& row : rows) {
      std::vector<double>& own = values.emplace_back();
      for (const RunData& run : runs_) own.push_back(run.summary ? row.second(*run.summary) : none);
      all.insert(all.end(), own.begin(), own.end());
    }
    const Scale scale(unit, all);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::vector<std::string> cells;
      for (const double value : values[r]) cells.push_back(scale.text(value));
      add_texts(labelled(rows[r].first, scale.unit()), std::move(cells));
    }
  }
  /// Two numbers per cell, all in a common unit.
  void add_pairs(const std::string& name, const Value& first, const Value& second, const std::string& unit,
                 const char* between) {
    std::vector<double> all;
    for (const RunData& run : runs_)
      for (const Value* value : {&first, &second}) all.push_back(run.summary ? (*value)(*run.summary) : none);
    const Scale scale(unit, all);
    std::vector<std::string> cells;
    for (std::size_t r = 0; r < runs_.size(); ++r)
      cells.push_back(std::isnan(all[2 * r]) ? "-" : scale.text(all[2 * r]) + between + scale.text(all[2 * r + 1]));
    add_texts(labelled(name, scale.unit()), std::move(cells));
  }
  void add_shares(const std::string& name, const Value& value) {
    add_texts(name, [&](const RunData& run) { return run.summary ? percent(value(*run.summary)) : "-"; });
  }
  void add_times(const std::string& name, const Value& value, const std::string& unit) {
    add_texts(labelled(name, unit),
              [&](const RunData& run) { return run.summary ? time_text(value(*run.summary), "") : "-"; });
  }

  void write(const std::string& caption, Html& page) const {
    if (rows_.empty()) return;
    for (std::size_t begin = 0; begin < runs_.size(); begin += runs_side_by_side) {
      const std::size_t end = std::min(begin + runs_side_by_side, runs_.size());
      std::vector<std::string> head{first_};
      for (std::size_t r = begin; r < end; ++r) head.push_back(runs_[r].label);
      std::vector<std::vector<std::string>> rows;
      for (const std::vector<std::string>& row : rows_) {
        rows.push_back({row.front()});
        rows.back().insert(rows.back().end(), row.begin() + 1 + static_cast<std::ptrdiff_t>(begin),
                           row.begin() + 1 + static_cast<std::ptrdiff_t>(end));
      }
      page.table(head, rows, begin == 0 ? caption : caption + ", continued");
    }
  }

 private:
  const std::vector<RunData>& runs_;
  std::string first_;
  std::vector<std::vector<std::string>> rows_;
};

template <typename Map>
std::set<std::string> names_in_all(const std::vector<RunData>& runs, Map io::Summary::*member) {
  std::set<std::string> names;
  for (const RunData& run : runs)
    if (run.summary)
      for (const auto& [name, value] : (*run.summary).*member) names.insert(name);
  return names;
}

/// A number of an entry by its name; none where a run does not have it.
template <typename Map, typename Of>
Value of_entry(Map io::Summary::*member, const std::string& name, Of of) {
  return [member, name, of](const io::Summary& summary) {
    const auto found = (summary.*member).find(name);
    return found == (summary.*member).end() ? none : of(found->second);
  };
}

void add_probes(const std::vector<RunData>& runs, RunTable& table) {
  using Course = io::SummaryProbe::Course;
  for (const std::string& name : names_in_all(runs, &io::Summary::probes)) {
    const auto of = [&](double Course::*member) {
      return of_entry(&io::Summary::probes, name, [member](const io::SummaryProbe& probe) {
        return probe.course ? (*probe.course).*member : none;
      });
    };
    std::string unit;
    for (const RunData& run : runs)
      if (run.summary && unit.empty())
        if (const auto found = run.summary->probes.find(name); found != run.summary->probes.end())
          unit = found->second.unit.value_or("");
    table.add_pairs(name + ", start → end", of(&Course::start), of(&Course::end), unit, " → ");
    table.add_pairs(name + ", smallest … largest", of(&Course::min), of(&Course::max), unit, " … ");
  }
}

}  // namespace

void add_differences(const std::vector<InputDifference>& differences, const std::vector<RunData>& runs, Html& page) {
  page.element("h2", "What differs");
  if (differences.empty()) {
    const bool known = std::ranges::none_of(runs, [](const RunData& run) { return run.record.inputs.empty(); });
    page.element("p", known ? "The runs have the same inputs."
                            : "At least one run does not record its inputs: it is of an earlier version.");
    return;
  }
  constexpr std::size_t most = 30;
  RunTable table(runs, "key of the configuration");
  for (std::size_t d = 0; d < std::min(differences.size(), most); ++d)
    table.add_texts(differences[d].key, differences[d].values);
  table.write("Inputs that are not the same in all runs", page);
  if (differences.size() > most) page.element("p", fmt::format("{} further keys differ.", differences.size() - most));
}

void add_compared_results(const std::vector<RunData>& runs, Html& page) {
  page.element("h2", "What came out");
  for (const RunData& run : runs)
    if (const std::string text = ending(run); !text.empty())
      page.element("p", fmt::format("{}: {}", run.label, text), "class=\"ending\" role=\"note\"");
  const RunData& first = runs.front();
  const std::string time = first.unit(Dimension::time), force = first.unit(Dimension::force),
                    stress = first.unit(Dimension::stress);
  using Course = io::Summary::Course;
  RunTable results(runs, "result");
  results.add_times(
      "time of rupture", [](const io::Summary& s) { return s.rupture ? s.rupture->time : none; }, time);
  for (const std::string& name : names_in_all(runs, &io::Summary::contacts)) {
    const auto of = [&](double Course::*member) {
      return of_entry(&io::Summary::contacts, name,
                      [member](const io::Summary::Contact& contact) { return contact.normal_force.*member; });
    };
    results.add({{fmt::format("normal force of {}, start", name), of(&Course::start)},
                 {fmt::format("normal force of {}, largest", name), of(&Course::largest)},
                 {fmt::format("normal force of {}, end", name), of(&Course::end)}},
                force);
  }
  std::vector<std::pair<std::string, Value>> stresses;
  for (const std::string& name : names_in_all(runs, &io::Summary::bodies))
    stresses.emplace_back(
        fmt::format("von Mises stress of {}, largest", name),
        of_entry(&io::Summary::bodies, name, [](const io::Summary::Body& body) { return body.von_mises.largest; }));
  results.add(stresses, stress);
  const auto add_shares = [&](auto member, const char* what) {
    for (const std::string& name : names_in_all(runs, member))
      results.add_shares(fmt::format("{} of {}", what, name),
                         of_entry(member, name, [](const io::Summary::Largest& share) { return share.value; }));
  };
  add_shares(&io::Summary::life_fraction, "creep life used");
  add_shares(&io::Summary::fatigue_fraction, "fatigue life used");
  add_shares(&io::Summary::creep_fatigue, "interaction diagram used");
  for (const std::string& name : names_in_all(runs, &io::Summary::events))
    results.add_texts(labelled(fmt::format("event {}", name), time), [&](const RunData& run) -> std::string {
      if (!run.summary) return "-";
      const auto found = run.summary->events.find(name);
      if (found == run.summary->events.end()) return "-";
      return found->second ? time_text(*found->second, "") : "never";
    });
  results.write("Results of all runs", page);
  RunTable probes(runs, "probe");
  add_probes(runs, probes);
  probes.write("Probes of all runs", page);
}

void add_overlays(const std::vector<RunData>& runs, Drawings& drawings, Html& page) {
  std::vector<plot::RunTables> tables;
  std::vector<std::string> labels;
  for (const RunData& run : runs)
    if (run.tables && run.tables->history.rows() > 1) {
      tables.push_back(*run.tables);
      labels.push_back(run.label);
    }
  if (tables.size() < 2) return;
  page.element("h2", "Histories");
  page.open("div", "class=\"overlays\"");
  try {
    for (const plot::NamedCurves& one : plot::overlaid(tables, labels, "", {})) {
      plot::Figure figure{"", one.curves.x, {{one.curves.y, {}}}};
      for (const plot::Series& series : one.curves.series)
        if (figure.panels[0].series.size() < plot::max_series) figure.panels[0].series.push_back(series);
      if (!figure.panels[0].series.empty()) drawings.add(figure, fmt::format("{} of all runs", one.curves.title), page);
    }
  } catch (const ConfigError& error) {
    page.element("p", error.what());
  }
  page.close("div");
}

void add_compared_pictures(const std::vector<RunData>& runs, Drawings& drawings, Html& page) {
  page.element("h2", "Pictures");
  const std::vector<Drawings::Still> all = drawings.compared(runs);
  if (all.empty()) page.element("p", "The runs have no field files, or there is nothing that draws them.");
  page.open("div", "class=\"still row\"");
  for (const Drawings::Still& still : all) page.figure(still.url, still.title, still.title);
  page.close("div");
}

void add_compared_accuracy(const std::vector<RunData>& runs, Html& page) {
  page.element("h2", "Accuracy and warnings");
  RunTable table(runs, "item");
  const auto add = [&](const char* name, const Value& value) {
    table.add_texts(name, [&](const RunData& run) { return run.summary ? engineering(value(*run.summary), 2) : "-"; });
  };
  add("relative accuracy asked for the stress",
      [](const io::Summary& s) { return s.accuracy.tolerance > 0 ? s.accuracy.tolerance : none; });
  table.add_shares("error of the steps on average, of what is allowed", [](const io::Summary& s) {
    return s.accuracy.largest_step_error > 0 ? s.accuracy.mean_step_error : none;
  });
  table.add_shares("the same, the largest", [](const io::Summary& s) {
    return s.accuracy.largest_step_error > 0 ? s.accuracy.largest_step_error : none;
  });
  add("forces that nothing balances, of the largest nodal force",
      [](const io::Summary& s) { return s.accuracy.equilibrium_residual.value_or(none); });
  table.add_texts("warnings", [](const RunData& run) {
    return run.summary ? fmt::format("{}", run.summary->warnings.size()) : "-";
  });
  table.write("Accuracy of all runs", page);
  std::map<std::string, std::vector<std::string>> warnings;
  for (const RunData& run : runs)
    if (run.summary)
      for (const std::string& warning : run.summary->warnings) warnings[warning].push_back(run.label);
  if (warnings.empty()) return;
  page.open("ul", "class=\"warnings\"");
  for (const auto& [warning, labels] : warnings)
    page.element(
        "li",
        fmt::format("{}: {}", labels.size() == runs.size() ? "all runs" : fmt::format("{}", fmt::join(labels, "; ")),
                    warning));
  page.close("ul");
}

void add_compared_appendix(const std::vector<RunData>& runs, Html& page) {
  page.element("h2", "Appendix: numerics and origin");
  RunTable table(runs, "item");
  const auto add = [&](const char* name, const std::function<std::string(const io::Summary&)>& text) {
    table.add_texts(name, [&](const RunData& run) { return run.summary ? text(*run.summary) : "-"; });
  };
  add("integrator", [](const io::Summary& s) { return s.integrator; });
  add("time steps", [](const io::Summary& s) { return std::to_string(s.steps); });
  add("elastic solves", [](const io::Summary& s) { return std::to_string(s.elastic_solves); });
  add("computing time [s]", [](const io::Summary& s) { return engineering(s.wall_seconds.total); });
  add("memory [MB]", [](const io::Summary& s) { return engineering(s.peak_memory_mb); });
  add("version of the program", [](const io::Summary& s) { return s.version; });
  table.add_texts("directory", [](const RunData& run) { return run.directory.lexically_normal().string(); });
  table.add_texts("fingerprint", [](const RunData& run) { return run.record.fingerprint; });
  table.add_texts("run started", [](const RunData& run) { return run.record.started; });
  table.write("Cost and origin of all runs", page);
}

}  // namespace creepcontact::report
