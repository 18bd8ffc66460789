#include "creepcontact/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <utility>

#include "assets.hpp"
#include "comparison.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/plot/overlay_plots.hpp"
#include "criteria.hpp"
#include "drawings.hpp"
#include "html.hpp"
#include "page.hpp"
#include "pdf.hpp"
#include "run_data.hpp"
#include "run_labels.hpp"
#include "run_sections.hpp"
#include "scatter_section.hpp"
#include "sensitivity_section.hpp"
#include "title_block.hpp"

namespace creepcontact::report {
namespace {

constexpr std::size_t most_views = 8;  // of runs in a comparison

/// A part of the page that the contents lead to.
struct Part {
  std::string id, title;
};

/// The sections of a page, each with an entry in the contents.
class Parts {
 public:
  explicit Parts(Html& page) : page_(page) {}

  void add(const char* id, const char* title, const std::function<void()>& content) {
    all_.push_back({id, title});
    page_.open("section", fmt::format("id=\"{}\"", id));
    content();
    page_.close("section");
  }
  /// An entry for a section that opens itself, or for none. @param content  adds it
  void add_if_any(const char* id, const char* title, const std::function<void()>& content) {
    const std::size_t before = page_.text().size();
    content();
    if (page_.text().size() > before) all_.push_back({id, title});
  }
  const std::vector<Part>& all() const { return all_; }

 private:
  Html& page_;
  std::vector<Part> all_;
};

void add_links(const char* name, const char* style, const std::vector<Part>& parts, Html& page) {
  page.open("nav", fmt::format("aria-label=\"{}\" class=\"{}\"", name, style));
  page.open("ul");
  for (const Part& part : parts) {
    page.open("li");
    page.element("a", part.title, fmt::format("href=\"#{}\"", part.id));
    page.close("li");
  }
  page.close("ul");
  page.close("nav");
}

/// The first runs of a study, as many as a reader can compare and memory holds, none of one whose shards keep them; of
/// any other directory itself. Links to
/// elsewhere are not followed.
std::vector<std::filesystem::path> runs_in(const std::filesystem::path& directory, std::vector<std::string>& notes) {
  // Samples differ by chance: a few of them show what a run is like.
  const std::size_t most = has_scatter(directory) ? 4 : 24;
  if (!path_exists(directory) || !path_is_directory(directory) || !path_exists(directory / "study.csv"))
    return {directory};
  std::vector<std::filesystem::path> runs;
  const std::filesystem::path place = directory / "runs";
  if (path_exists(place) && path_is_directory(place))
    for (const auto& entry : std::filesystem::directory_iterator(place))
      if (!entry.is_symlink() && entry.is_directory() &&
          (path_exists(entry.path() / "summary.json") || path_exists(entry.path() / "history.csv")) &&
          entry.path().filename().string().starts_with("run_"))
        runs.push_back(entry.path());
  if (runs.empty() && has_scatter(directory)) {
    notes.emplace_back("The runs are kept in files of shards, and none of them is shown.");
    return {};
  }
  if (runs.empty())
    throw ConfigError(
        fmt::format("'{}' is the directory of a study without results in '{}'", directory.string(), place.string()));
  std::ranges::sort(runs);
  if (runs.size() > most) {
    notes.push_back(fmt::format(
        "The study has {} runs, of which the first {} are compared here; study.csv in {} has a row for each. "
        "To compare others, name their directories.",
        runs.size(), most, directory.string()));
    runs.resize(most);
  }
  return runs;
}

/// The first heading of study.md; empty if there is none.
std::string title_of_study(const std::filesystem::path& directory) {
  constexpr std::size_t longest = std::size_t{16} << 20;
  if (!path_exists(directory / "study.csv") || !path_exists(directory / "study.md")) return "";
  const std::string text = read_file(directory / "study.md", longest).bytes;
  return text.starts_with("# ") ? text.substr(2, text.find('\n') - 2) : "";
}

std::filesystem::path output_file(const std::vector<std::filesystem::path>& given, const ReportOptions& options) {
  const char* const name = options.pdf ? "report.pdf" : "report.html";
  if (options.output.empty()) return given.size() == 1 ? given.front() / name : name;
  if (path_exists(options.output) && path_is_directory(options.output)) return options.output / name;
  return options.output;
}

bool has_appendix(const std::vector<RunData>& runs) {
  return runs.front().record.report.appendix;
}

void add_one(const RunData& run, Script script, Drawings& drawings, Html& page, Parts& parts) {
  if (const std::string text = ending(run); !text.empty()) page.element("p", text, "class=\"ending\" role=\"note\"");
  parts.add_if_any("question", "Question", [&] { add_question({run}, page); });
  parts.add_if_any("criteria", "Criteria", [&] { add_criteria(run, page); });
  parts.add_if_any("sensitivities", "Sensitivities", [&] { add_sensitivities(run, page); });
  parts.add("answer", "What came out", [&] { add_answer(run, page); });
  parts.add("histories", "Histories", [&] { add_histories(run, drawings, page); });
  parts.add_if_any("cycles", "Cycles", [&] { add_cycles(run, drawings, page); });
  parts.add("pictures", "Pictures", [&] {
    add_fields(run, drawings, page);
    if (script == Script::embedded) add_viewer(run, 1, page);
  });
  parts.add("inputs", "Inputs", [&] { add_inputs(run, {}, drawings, page); });
  parts.add("accuracy", "Accuracy", [&] { add_accuracy(run, page); });
  if (has_appendix({run})) parts.add("appendix", "Appendix", [&] { add_appendix(run, drawings, page); });
}

void add_several(const std::vector<RunData>& runs, const std::vector<InputDifference>& differences, Script script,
                 Drawings& drawings, Html& page, Parts& parts) {
  parts.add_if_any("question", "Question", [&] { add_question(runs, page); });
  parts.add_if_any("criteria", "Criteria", [&] { add_criteria(runs, page); });
  parts.add("differences", "What differs", [&] { add_differences(differences, runs, page); });
  parts.add("answer", "What came out", [&] { add_compared_results(runs, page); });
  parts.add_if_any("histories", "Histories", [&] {
    page.open("section", "id=\"histories\"");
    add_overlays(runs, drawings, page);
    page.close("section");
  });
  parts.add("pictures", "Pictures", [&] {
    add_compared_pictures(runs, drawings, page);
    for (std::size_t i = 0; script == Script::embedded && i < std::min(runs.size(), most_views); ++i)
      add_viewer(runs[i], i + 1, page);
  });
  parts.add("inputs", "Inputs", [&] {
    add_inputs(runs.front(), {runs.begin() + 1, runs.end()}, drawings, page);
    page.element("p",
                 fmt::format("The inputs are those of the run with {}; what differs in another run is marked.",
                             runs.front().label),
                 "class=\"about\"");
  });
  parts.add("accuracy", "Accuracy", [&] { add_compared_accuracy(runs, page); });
  if (has_appendix(runs)) parts.add("appendix", "Appendix", [&] { add_compared_appendix(runs, page); });
}

void add_figures(const Html& body, Html& page) {
  if (body.figures().empty()) return;
  std::vector<Part> figures;
  for (std::size_t i = 0; i < body.figures().size(); ++i)
    figures.push_back({fmt::format("figure-{}", i + 1), fmt::format("Figure {}: {}", i + 1, body.figures()[i])});
  page.open("section", "id=\"figures\"");
  page.element("h2", "Figures");
  add_links("Figures", "figures", figures, page);
  page.close("section");
}

void add_missing(const std::vector<std::string>& notes, Html& page) {
  if (notes.empty()) return;
  page.open("section", "id=\"missing\"");
  page.element("h2", "What is missing here");
  page.open("ul");
  for (const std::string& note : notes) page.element("li", note);
  page.close("ul");
  page.close("section");
}

/// What is missing, each sentence once with the runs that it is of.
std::vector<std::string> notes_of_runs(const std::vector<RunData>& runs, Script script) {
  std::vector<std::pair<std::string, std::vector<std::string>>> all;
  for (const RunData& run : runs)
    for (const std::string& note : run.notes) {
      // What the view leaves out is of no interest without it.
      if (script == Script::none && run.scene && note == run.scene->note) continue;
      auto found = std::ranges::find(all, note, &std::pair<std::string, std::vector<std::string>>::first);
      if (found == all.end()) found = all.insert(all.end(), {note, {}});
      found->second.push_back(run.label);
    }
  std::vector<std::string> notes;
  notes.reserve(all.size());
  for (const auto& [note, labels] : all)
    notes.push_back(runs.size() == 1               ? note
                    : labels.size() == runs.size() ? "All runs: " + note
                                                   : fmt::format("{}: {}", fmt::join(labels, "; "), note));
  return notes;
}

}  // namespace

WrittenReport write_report(const std::vector<std::filesystem::path>& given, const ReportOptions& options) {
  if (options.pdf) require_browser();  // before the pictures, which take long
  std::vector<std::filesystem::path> directories;
  std::vector<std::string> notes_of_studies;
  for (const std::filesystem::path& directory : given)
    std::ranges::move(runs_in(directory, notes_of_studies), std::back_inserter(directories));
  std::vector<std::string> labels;
  for (const plot::LabelledRun& run : plot::labelled_by_directory(directories)) labels.push_back(run.label);
  std::vector<RunData> runs;
  for (std::size_t i = 0; i < directories.size(); ++i)
    runs.push_back(read_run(directories[i], labels[i], options.limit_mb / static_cast<double>(directories.size())));

  const bool is_alone = runs.size() == 1;
  std::vector<const io::ModelRecord*> records;
  records.reserve(runs.size());
  for (const RunData& run : runs) records.push_back(&run.record);
  const std::vector<InputDifference> differences = input_differences(records);
  labels = labels_by_inputs(differences, labels);
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].label = is_alone ? runs[i].title() : labels[i];
  std::string title = is_alone ? runs.front().title() : "";
  if (title.empty() && given.size() == 1) title = title_of_study(given.front());
  if (title.empty()) title = fmt::format("Comparison of {} runs", runs.size());

  const Script script = options.pdf ? Script::none : Script::embedded;
  Drawings drawings;
  Html body;
  Parts parts(body);
  if (given.size() == 1 && has_scatter(given.front()))
    parts.add("scatter", "Scatter", [&] { add_scatter(given.front(), body); });
  if (is_alone)
    add_one(runs.front(), script, drawings, body, parts);
  else if (!runs.empty())
    add_several(runs, differences, script, drawings, body, parts);

  Html page;
  open_page(title, page, script);
  const std::string logo_note = add_title_block(runs, title, page);
  WrittenReport report{output_file(given, options), 0, std::move(notes_of_studies)};
  std::ranges::move(notes_of_runs(runs, script), std::back_inserter(report.notes));
  std::ranges::copy(drawings.notes(), std::back_inserter(report.notes));
  if (!logo_note.empty()) report.notes.push_back(logo_note);
  if (viewer_script().empty())
    report.notes.emplace_back("The program was built without the interactive view of fields (npm was missing).");
  add_links("Contents", "contents", parts.all(), page);
  page.open("main");
  page.raw(body.text());
  add_figures(body, page);
  add_missing(report.notes, page);
  page.close("main");
  close_page(page, script);
  if (options.pdf)
    report.megabytes = print_pdf(page.text(), report.file);
  else
    write_page(report.file, page.text(), "--output");
  if (!options.pdf) report.megabytes = static_cast<double>(page.text().size()) / 1e6;
  return report;
}

}  // namespace creepcontact::report
