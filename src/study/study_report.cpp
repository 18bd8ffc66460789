#include "study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "creepcontact/base/one_line.hpp"
#include "creepcontact/io/tables/csv_table.hpp"

namespace creepcontact::study {
namespace {

using Cells = std::vector<std::string>;

// Rows in study.md: beyond, nobody reads them.
constexpr std::size_t most_rows = 1000, most_sampled_rows = 20;

/// Keys that head columns: those of the axes, then the others that some runs set, then the random ones.
Cells keys(const config::Study& study) {
  Cells all;
  const auto add = [&](const std::string& key) {
    if (std::find(all.begin(), all.end(), key) == all.end()) all.push_back(key);
  };
  for (const config::Product& product : config::products(study)) {
    for (const config::Setting& setting : product.settings) add(setting.key);
    for (const config::Axis& axis : product.axes) add(axis.key.name);
  }
  if (study.random)
    for (const config::RandomKey& key : study.random->keys) add(key.key.name);
  return all;
}

std::string value_of(const config::Study& study, const config::PlannedRun& run, const std::string& key) {
  for (std::size_t k = 0; k < run.sampled.size(); ++k)
    if (study.random->keys[k].key.name == key) return fmt::format("{}", run.sampled[k]);
  std::string value;  // of the last setting, as overrides do
  for (const config::Setting& setting : run.settings)
    if (setting.key == key) value = setting.value.label;
  return value;
}

std::string markdown_cell(const std::string& text) {
  std::string escaped;
  for (const char c : one_line(text)) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string csv_line(const Cells& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != cells.data()) line += ',';
    line += io::csv_cell(cell);
  }
  return line + '\n';
}

std::string markdown_line(const Cells& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + markdown_cell(cell) + " |";
  return line + '\n';
}

std::string rule(std::size_t columns) {
  std::string line = "|";
  for (std::size_t i = 0; i < columns; ++i) line += "---|";
  return line + '\n';
}

/// Names of criteria or events that some run has.
std::set<std::string> names_in(const std::vector<StudyRow>& rows, std::map<std::string, double> StudyRow::*of) {
  std::set<std::string> names;
  for (const StudyRow& row : rows)
    for (const auto& [name, value] : row.*of) names.insert(name);
  return names;
}

/// What has a column, apart from the costs.
struct Columns {
  Cells keys;
  std::set<std::string> criteria, events;
  Columns(const config::Study& study, const std::vector<StudyRow>& rows)
      : keys(study::keys(study)),
        criteria(names_in(rows, &StudyRow::criteria)),
        events(names_in(rows, &StudyRow::events)) {}
};

Cells head(const config::Study& study, const Columns& columns) {
  Cells cells = columns.keys;
  if (study.reference)
    for (const config::Reference& quantity : study.compare.quantities) cells.push_back("error_" + quantity.name);
  for (const config::Reference& quantity : study.compare.quantities)
    for (const char* const part : {"start", "end", "min", "max"})
      cells.push_back(fmt::format("{}_{}", quantity.name, part));
  for (const std::string& name : columns.criteria) cells.push_back("criterion_" + name);
  for (const std::string& name : columns.events) cells.push_back("event_" + name);
  cells.insert(cells.end(), {"status", "message"});
  for (const std::string& name : config::study_counts()) cells.push_back(name);
  return cells;
}

/// Cells under head(). @param digits  significant ones of errors and seconds, two less than those of probes; 0: all
Cells body(const config::Study& study, const config::PlannedRun& run, const StudyRow& row, const Columns& columns,
           int digits) {
  const auto with_digits = [&](double value, int more) {
    if (!std::isfinite(value)) return std::string();
    return digits > 0 ? fmt::format("{:.{}g}", value, digits + more) : fmt::format("{}", value);
  };
  const auto number = [&](double value) { return with_digits(value, 0); };
  Cells cells;
  for (const std::string& key : columns.keys) cells.push_back(value_of(study, run, key));
  for (std::size_t q = 0; study.reference && q < study.compare.quantities.size(); ++q)
    cells.push_back(q < row.errors.size() ? number(row.errors[q]) : std::string());
  for (std::size_t q = 0; q < study.compare.quantities.size(); ++q) {
    const ProbeCourse course = q < row.courses.size() ? row.courses[q] : ProbeCourse{};
    for (const double value : {course.start, course.end, course.min, course.max})
      cells.push_back(with_digits(value, 2));
  }
  const auto add = [&](const std::map<std::string, double>& values, const std::set<std::string>& names) {
    for (const std::string& name : names) {
      const auto found = values.find(name);
      const bool is_known = found != values.end();
      cells.push_back(is_known && std::isinf(found->second) ? "inf"
                                                            : number(is_known ? found->second : ProbeCourse::unknown));
    }
  };
  add(row.criteria, columns.criteria);
  add(row.events, columns.events);
  cells.push_back(row.status);
  cells.push_back(one_line(row.message));
  for (const std::string& name : config::study_counts()) {
    const double count = row.count(name);
    cells.push_back(name == "wall_seconds" || !row.counted ? number(count) : fmt::format("{:.0f}", count));
  }
  return cells;
}

std::string reference_text(const config::Study& study, const std::optional<StudyRow>& row) {
  if (!study.reference) return "";
  const std::string norm = study.compare.norm == config::ErrorNorm::max
                               ? "the largest difference over the output times, relative to the largest magnitude of "
                                 "the reference"
                               : "the difference at the last output time, relative to the reference there";
  std::string text = "Reference: ";
  if (!study.reference->csv.empty()) text += '`' + study.reference->csv.filename().string() + '`';
  const auto& expressions = study.reference->expressions;
  for (auto one = expressions.begin(); one != expressions.end(); ++one)
    text += fmt::format("{}`{} = {}`", one == expressions.begin() ? "" : ", ", one->first, one->second.text());
  if (row) {
    text += "a run";
    for (const config::Setting& setting : study.reference->settings)
      text += fmt::format("{} `{} = {}`", &setting == study.reference->settings.data() ? " with" : ",", setting.key,
                          setting.value.label);
    text += fmt::format(" ({} steps, {} elastic solves, {:.3g} s)", row->steps, row->elastic_solves, row->wall_seconds);
  }
  return fmt::format("{}. Errors are {}.\n\n", text, norm);
}

std::string orders_text(const config::Study& study, const std::vector<StudySeries>& all,
                        const std::vector<StudyRow>& rows) {
  if (!study.reference) return "";
  std::string text;
  for (const StudySeries& one : all) {
    for (std::size_t q = 0; q < study.compare.quantities.size(); ++q) {
      const std::vector<double> orders = observed_orders(one.x, one.errors(rows, q));
      for (std::size_t i = 0; i < orders.size(); ++i)
        text += markdown_line(
            {one.label, study.compare.quantities[q].name, fmt::format("{}: {} to {}", one.axis, one.x[i], one.x[i + 1]),
             std::isfinite(orders[i]) ? fmt::format("{:.2f}", std::round(100 * orders[i]) / 100 + 0.0) : ""});
    }
  }
  if (text.empty()) return "";
  return "\n## Observed orders\n\nSlope of log(error) against the logarithm of what is varied, between "
         "consecutive values.\n\n" +
         markdown_line({"runs", "quantity", "from, to", "order"}) + rule(4) + text;
}

}  // namespace

std::string study_csv(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                      const std::vector<StudyRow>& rows) {
  const Columns columns(study, rows);
  std::string text = csv_line(head(study, columns));
  for (std::size_t r = 0; r < runs.size(); ++r) text += csv_line(body(study, runs[r], rows[r], columns, 0));
  return text;
}

std::string study_markdown(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                           const std::vector<StudyRow>& rows, const std::optional<StudyRow>& reference,
                           const std::string& scatter, const std::vector<std::filesystem::path>& pictures) {
  constexpr int digits = 3;
  const std::size_t shown = study.random ? most_sampled_rows : most_rows;
  const Columns columns(study, rows);
  const Cells heads = head(study, columns);
  std::string text = fmt::format("# {}\n\n{}{}", study.title.empty() ? study.file.stem().string() : study.title,
                                 reference_text(study, reference), scatter);
  if (!scatter.empty()) text += "## Runs\n\n";
  if (runs.size() > shown)
    text += fmt::format("The first {} of {} runs; `study.csv` has a row for each.\n\n", shown, runs.size());
  text += markdown_line(heads) + rule(heads.size());
  for (std::size_t r = 0; r < std::min(shown, runs.size()); ++r)
    text += markdown_line(body(study, runs[r], rows[r], columns, digits));
  if (!study.random) text += orders_text(study, series(study, runs), rows);
  if (!pictures.empty()) text += "\n## Pictures\n";
  for (const std::filesystem::path& picture : pictures)
    text += fmt::format("\n![{}]({})\n", picture.stem().string(), picture.filename().string());
  return text;
}

}  // namespace creepcontact::study
