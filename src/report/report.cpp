#include "creepcontact/report/report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "assets.hpp"
#include "comparison.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/plot/overlay_plots.hpp"
#include "drawings.hpp"
#include "html.hpp"
#include "page.hpp"
#include "run_data.hpp"
#include "run_sections.hpp"

namespace creepcontact::report {
namespace {

struct Part {
  const char *id, *title;
};
constexpr std::array parts{Part{"answer", "What came out"}, Part{"histories", "Histories"}, Part{"fields", "Fields"},
                           Part{"inputs", "Inputs"},        Part{"accuracy", "Accuracy"},   Part{"origin", "Origin"}};

void add_contents(const std::vector<RunData>& runs, Html& page) {
  page.open("nav", "aria-label=\"Contents\"");
  page.open("ul");
  const auto entry = [&](const std::string& id, const std::string& title) {
    page.open("li");
    page.element("a", title, fmt::format("href=\"#{}\"", id));
    page.close("li");
  };
  if (runs.size() == 1) {
    for (const Part& part : parts) entry(fmt::format("{}-1", part.id), part.title);
  } else {
    entry("comparison", "Comparison");
    for (std::size_t i = 0; i < runs.size(); ++i) entry(fmt::format("run-{}", i + 1), runs[i].label);
  }
  page.close("ul");
  page.close("nav");
}

void add_heading(const std::vector<RunData>& runs, const std::string& title, Html& page) {
  const std::time_t now = std::time(nullptr);
  page.open("header");
  page.element("h1", title);
  page.open("p", "class=\"about\"");
  page.raw(fmt::format("Report of {:%Y-%m-%d %H:%M}, creepcontact {}", fmt::localtime(now), CREEPCONTACT_VERSION));
  if (runs.size() == 1 && !runs[0].record.fingerprint.empty())
    page.raw(escaped(fmt::format(", model {}", runs[0].record.fingerprint)));
  page.close("p");
  page.close("header");
}

void add_run(const RunData& run, std::size_t number, bool is_alone, Drawings& drawings, Html& page) {
  const std::string level = is_alone ? "h2" : "h3";
  page.open("section", fmt::format("id=\"run-{}\"", number));
  if (!is_alone) page.element("h2", fmt::format("{}: {}", run.label, run.title()));
  if (const std::string text = ending(run); !text.empty()) page.element("p", text, "class=\"ending\" role=\"note\"");
  const auto part = [&](const char* id, const auto& add) {
    page.open("section", fmt::format("id=\"{}-{}\"", id, number));
    add();
    page.close("section");
  };
  part("answer", [&] { add_answer(run, page, level); });
  part("histories", [&] { add_histories(run, drawings, page, level); });
  part("fields", [&] { add_fields(run, number, drawings, page, level); });
  part("inputs", [&] { add_inputs(run, drawings, page, level); });
  part("accuracy", [&] { add_accuracy(run, drawings, page, level); });
  part("origin", [&] { add_origin(run, page, level); });
  page.close("section");
}

std::filesystem::path output_file(const std::vector<std::filesystem::path>& runs, const ReportOptions& options) {
  if (options.output.empty()) return runs.size() == 1 ? runs.front() / "report.html" : "report.html";
  if (path_exists(options.output) && path_is_directory(options.output)) return options.output / "report.html";
  return options.output;
}

}  // namespace

WrittenReport write_report(const std::vector<std::filesystem::path>& directories, const ReportOptions& options) {
  std::vector<std::string> labels;
  for (const plot::LabelledRun& run : plot::labelled_by_directory(directories)) labels.push_back(run.label);
  std::vector<RunData> runs;
  for (std::size_t i = 0; i < directories.size(); ++i)
    runs.push_back(read_run(directories[i], labels[i], options.limit_mb / static_cast<double>(directories.size())));

  const bool is_alone = runs.size() == 1;
  const std::string title = is_alone ? runs.front().title() : fmt::format("Comparison of {} runs", runs.size());
  Drawings drawings;
  Html page;
  open_page(title, page);
  add_heading(runs, title, page);
  add_contents(runs, page);
  page.open("main");
  if (!is_alone) {
    page.open("section", "id=\"comparison\"");
    add_comparison(runs, drawings, page);
    page.close("section");
  }
  for (std::size_t i = 0; i < runs.size(); ++i) add_run(runs[i], i + 1, is_alone, drawings, page);
  WrittenReport report{output_file(directories, options), 0, {}};
  for (const RunData& run : runs)
    for (const std::string& note : run.notes)
      report.notes.push_back(is_alone ? note : fmt::format("{}: {}", run.label, note));
  std::ranges::copy(drawings.notes(), std::back_inserter(report.notes));
  if (viewer_script().empty())
    report.notes.emplace_back("The program was built without the interactive view of fields (npm was missing).");
  if (!drawings.notes().empty()) {
    page.open("section", "id=\"missing\"");
    page.element("h2", "What is missing here");
    page.open("ul");
    for (const std::string& note : drawings.notes()) page.element("li", note);
    page.close("ul");
    page.close("section");
  }
  page.close("main");
  close_page(page);
  write_page(report.file, page.text(), "--output");
  report.megabytes = static_cast<double>(page.text().size()) / 1e6;
  return report;
}

}  // namespace creepcontact::report
