#include "study_conclusion.hpp"

#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "scatter_plots.hpp"
#include "scatter_tables.hpp"
#include "study_plots.hpp"
#include "study_report.hpp"

namespace creepcontact::study {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of_probes(const config::Study& study) {
  std::vector<std::string> names;
  if (study.random)
    for (const config::Reference& probe : study.compare.quantities) names.push_back(probe.name);
  return names;
}

/// Results without pictures are better than none.
template <class Draw>
std::vector<fs::path> drawn(const Draw& draw) {
  try {
    return draw();
  } catch (const Error& error) {
    log::warning("no pictures: {}", error.what());
    return {};
  }
}

}  // namespace

StudyConclusion::StudyConclusion(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                                 ResultUnits units)
    : study_(study),
      runs_(runs),
      comparison_(study),
      histories_(names_of_probes(study), runs.size()),
      units_(std::move(units)) {
  StudyRow not_started;
  not_started.status = "not started";
  rows_.assign(runs.size(), not_started);
}

void StudyConclusion::take_reference(const RunOutcome& outcome, const std::string& name) {
  reference_ = outcome.row;
  comparison_.take_reference(outcome, name);
}

void StudyConclusion::take(std::size_t run, const RunOutcome& outcome, StudyRow row) {
  comparison_.compare(outcome, row);
  if (study_.random && row.succeeded()) histories_.take(run, outcome.history, row.status == "completed");
  rows_[run] = std::move(row);
}

void StudyConclusion::write(const fs::path& directory) const {
  platform::replace_file(directory / "study.csv", study_csv(study_, runs_, rows_));
  std::string scatter_text;
  std::vector<fs::path> pictures;
  if (study_.random) {
    platform::replace_file(directory / "samples.csv", samples_csv(study_, runs_));
    const Scatter scatter = scatter_of(study_, runs_, rows_, histories_);
    for (const auto& [name, text] : scatter_tables(runs_, scatter)) platform::replace_file(directory / name, text);
    scatter_text = scatter_markdown(study_, scatter);
    pictures = drawn([&] { return plot_scatter(study_, runs_, scatter, units_, title_of(study_), directory); });
  } else {
    pictures = drawn([&] { return plot_study(study_, runs_, rows_, directory); });
  }
  platform::replace_file(directory / "study.md",
                         study_markdown(study_, runs_, rows_, reference_, scatter_text, pictures));
}

}  // namespace creepcontact::study
