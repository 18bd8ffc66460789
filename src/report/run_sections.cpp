#include "run_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "assets.hpp"
#include "creepcontact/base/error.hpp"
#include "engineering.hpp"
#include "markdown.hpp"

namespace creepcontact::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

void add_stills(const std::vector<Drawings::Still>& stills, Html& page, const char* box) {
  if (stills.empty()) return;
  page.open("div", fmt::format("class=\"{}\"", box));
  for (const Drawings::Still& still : stills) page.figure(still.url, still.title, still.title);
  page.close("div");
}

/// The section of another run with the same title. @returns null if it has none
const io::RecordedSection* same_section(const io::ModelRecord& other, const io::RecordedSection& section) {
  const auto found = std::ranges::find(other.sections, section.title, &io::RecordedSection::title);
  return found == other.sections.end() ? nullptr : &*found;
}

/// The table of another run with the same headings. @returns null if it has none
const io::RecordedTable* same_table(const io::ModelRecord& other, const io::RecordedSection& section,
                                    const io::RecordedTable& table) {
  const io::RecordedSection* const found = same_section(other, section);
  if (found == nullptr) return nullptr;
  const auto same = std::ranges::find_if(found->tables, [&](const io::RecordedTable& candidate) {
    return candidate.title == table.title && candidate.head == table.head;
  });
  return same == found->tables.end() ? nullptr : &*same;
}

/// The row of another table with the name, its first cell, of row `r` of this one: the n-th if `r` is the n-th of that
/// name. @returns null if it has none
const std::vector<std::string>* same_row(const io::RecordedTable& other, const io::RecordedTable& table,
                                         std::size_t r) {
  const auto has_name = [&](const std::vector<std::string>& row) {
    return !row.empty() && !table.rows[r].empty() && row.front() == table.rows[r].front();
  };
  auto before = std::count_if(table.rows.begin(), table.rows.begin() + static_cast<std::ptrdiff_t>(r), has_name);
  for (const std::vector<std::string>& row : other.rows)
    if (has_name(row) && before-- == 0) return &row;
  return nullptr;
}

/// Whether the sections of that title have the note in all runs.
bool is_in_all(const std::string& note, const io::RecordedSection& section, const std::vector<RunData>& others) {
  return std::ranges::all_of(others, [&](const RunData& other) {
    const io::RecordedSection* const same = same_section(other.record, section);
    return same != nullptr && std::ranges::count(same->notes, note) > 0;
  });
}

/// Rows for readers. What is not the same in all other runs is marked.
Rows with_marks(const io::RecordedTable& table, const io::RecordedSection& section,
                const std::vector<RunData>& others) {
  Rows rows = table.rows;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::vector<bool> differs(rows[r].size(), false);
    bool is_in_all = true;
    for (const RunData& other : others) {
      const io::RecordedTable* const same = same_table(other.record, section, table);
      const std::vector<std::string>* const row = same != nullptr ? same_row(*same, table, r) : nullptr;
      if (row == nullptr) is_in_all = false;
      for (std::size_t c = 0; row != nullptr && c < differs.size(); ++c)
        if (c >= row->size() || (*row)[c] != table.rows[r][c]) differs[c] = true;
    }
    for (std::size_t c = 0; c < rows[r].size(); ++c)
      rows[r][c] = readable(rows[r][c]) + (differs[c] ? " (differs)" : "");
    if (!is_in_all && !rows[r].empty()) rows[r].front() += " (not in all runs)";
  }
  return rows;
}

}  // namespace

void add_histories(const RunData& run, Drawings& drawings, Html& page) {
  page.element("h2", "Histories");
  if (!run.tables || run.tables->history.rows() < 2) {
    page.element("p", "There are fewer than two output times so far: no curves can be drawn.");
    return;
  }
  if (run.tables->history.names.size() < 2) {
    page.element("p", "The run has no probes ([[probes]] in its configuration).");
    return;
  }
  try {
    std::size_t n = 0;
    for (const plot::NamedFigure& one : plot::run_figures(*run.tables, {}))
      if (one.name.starts_with("history"))
        drawings.add(one.figure, ++n == 1 ? "Histories of the probes" : "Histories of the probes, continued", page);
  } catch (const ConfigError& error) {
    page.element("p", error.what());
  }
}

void add_fields(const RunData& run, Drawings& drawings, Html& page) {
  page.element("h2", "Pictures");
  if (!run.scene) {
    page.element("p", "The run has no field files.");
    return;
  }
  add_stills(drawings.fields(run), page, "still");
  page.element("p",
               "Displacements are drawn larger by the factor shown, from the mesh as it was made. Bodies with an "
               "interference or a gap given in the configuration touch in the mesh; deformed they therefore appear "
               "apart, or overlap, by that amount times the factor.",
               "class=\"about\"");
}

void add_viewer(const RunData& run, std::size_t n, Html& page) {
  if (viewer_script().empty() || !run.scene) return;
  page.open("figure", fmt::format("class=\"fields\" id=\"fields-{}\"", n));
  page.raw(fmt::format("<div class=\"viewer\" data-scene=\"scene-{}\"></div>\n", n));
  page.element("noscript", "The interactive view needs JavaScript.");
  page.element("figcaption", fmt::format("Interactive view of {}. {}", run.label, run.scene->note));
  page.close("figure");
  const PackedScene scene = packed(*run.scene);
  page.raw(fmt::format("<script type=\"application/json\" id=\"scene-{}\">{}</script>\n", n, scene.header));
  page.raw(fmt::format("<script type=\"text/plain\" id=\"scene-{}-data\">{}</script>\n", n, scene.data));
}

void add_inputs(const RunData& run, const std::vector<RunData>& others, Drawings& drawings, Html& page) {
  page.element("h2", "Inputs");
  if (!run.record.report.assumptions.empty()) {
    page.element("h3", "Assumptions");
    page.raw(markdown(run.record.report.assumptions, 4));
  }
  if (run.record.sections.empty()) {
    page.element("p", "The run has no model.json, which describes the inputs.");
    return;
  }
  for (std::size_t s = 0; s < run.record.sections.size(); ++s) {
    const io::RecordedSection& section = run.record.sections[s];
    page.element("h3", section.title);
    for (const std::string& note : section.notes)
      page.element("p", note + (is_in_all(note, section, others) ? "" : " (differs)"));
    for (const io::RecordedTable& table : section.tables)
      page.table(table.head, with_marks(table, section, others), table.title);
    if (!section.plots.empty()) page.open("div", "class=\"small\"");
    for (const io::RecordedPlot& plot : section.plots) drawings.add(plot, page);
    if (!section.plots.empty()) page.close("div");
    if (s > 0) continue;
    add_stills(drawings.model(run), page, "model");
    // A comparison is about results: the model above has all bodies.
    if (others.empty()) add_stills(drawings.meshes(run), page, "meshes");
  }
}

void add_accuracy(const RunData& run, Html& page) {
  page.element("h2", "Accuracy and warnings");
  if (!run.summary) {
    page.element("p", "Without summary.json nothing is known of the accuracy.");
    return;
  }
  const io::Summary& summary = *run.summary;
  const io::Summary::Accuracy& accuracy = summary.accuracy;
  Rows rows;
  if (accuracy.tolerance > 0)
    rows.push_back({"relative accuracy asked for the stress (time.tolerance)", engineering(accuracy.tolerance, 2)});
  if (accuracy.largest_step_error > 0) {
    rows.push_back({"estimated error of the steps on average, of what is allowed", percent(accuracy.mean_step_error)});
    rows.push_back({"the same, the largest", percent(accuracy.largest_step_error)});
  }
  if (accuracy.equilibrium_residual)
    rows.push_back({"forces that nothing balances at the end, of the largest nodal force",
                    engineering(*accuracy.equilibrium_residual, 2)});
  if (summary.friction_kappa)
    rows.push_back({"friction: kappa (above 1 several states may be possible)", engineering(*summary.friction_kappa)});
  if (!rows.empty()) page.table({"item", "value"}, rows, "Accuracy");
  page.element("p",
               "The error estimate is that of the integration in time. The error of the mesh is not in it: compare "
               "with a finer mesh. The forces that nothing balances include those of the stabilisation of elements "
               "with reduced integration.");
  if (summary.warnings.empty()) {
    page.element("p", accuracy.tolerance > 0 ? "The run gave no warnings."
                                             : "Runs of this version do not record what they warned of.");
    return;
  }
  page.open("ul", "class=\"warnings\"");
  for (const std::string& warning : summary.warnings) page.element("li", warning);
  page.close("ul");
}

void add_appendix(const RunData& run, Drawings& drawings, Html& page) {
  page.element("h2", "Appendix: numerics and origin");
  Rows rows;
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) rows.push_back({what, text});
  };
  if (run.summary) {
    const io::Summary& summary = *run.summary;
    add("integrator", summary.method.empty() || summary.method == summary.integrator
                          ? summary.integrator
                          : fmt::format("{} ({})", summary.integrator, summary.method));
    add("time steps, accepted + rejected", fmt::format("{} + {}", summary.steps, summary.rejected_steps));
    add("elastic solves", fmt::format("{}", summary.elastic_solves));
    add("computing time", engineering(summary.wall_seconds.total) + " s");
    add("memory", engineering(summary.peak_memory_mb) + " MB");
  }
  if (!rows.empty()) page.table({"item", "value"}, rows, "Numerics and cost");
  if (run.tables && run.tables->steps.rows() > 1)
    drawings.add(
        plot::steps_figure(run.tables->steps, run.tables->heading, plot::spans_decades(run.tables->steps.columns[0])),
        "Length, order and cost of the time steps", page);
  rows.clear();
  add("directory", run.directory.lexically_normal().string());
  add("configuration", run.record.configuration);
  add("fingerprint of configuration and mesh", run.record.fingerprint);
  add("run started", run.record.started);
  add("version of the program", run.summary ? run.summary->version : run.record.version);
  add("units", run.units());
  page.table({"item", "value"}, rows, "Origin of the results");
}

}  // namespace creepcontact::report
