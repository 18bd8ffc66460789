#include "run_data.hpp"

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "run_directory.hpp"

namespace creepcontact::report {
namespace {

io::ModelRecord read_record(const std::filesystem::path& path, std::vector<std::string>& notes) {
  if (!path_exists(path)) {
    notes.emplace_back(
        "The directory has no model.json: the run is of an earlier version, or ended before its first "
        "output. Materials, loads and contacts are therefore not described.");
    return {};
  }
  try {
    return io::read_model_record(path);
  } catch (const ConfigError& error) {
    notes.emplace_back(fmt::format("The model cannot be described: {}.", error.what()));
    return {};
  }
}

std::optional<plot::RunTables> read_tables(const std::filesystem::path& directory, std::vector<std::string>& notes) {
  try {
    io::SummaryHeading heading;
    try {
      heading = io::read_summary_heading(directory / "summary.json");
    } catch (const ConfigError&) {  // the lack of it has its own note
    }
    return plot::read_run_tables(directory, std::move(heading));
  } catch (const ConfigError& error) {
    notes.emplace_back(fmt::format("There are no histories: {}.", error.what()));
    return std::nullopt;
  }
}

}  // namespace

std::string RunData::title() const {
  if (!record.report.title.empty()) return record.report.title;
  if (summary && !summary->title.empty()) return summary->title;
  if (tables && !tables->heading.title.empty()) return tables->heading.title;
  return directory.lexically_normal().filename().string();
}

std::string RunData::units() const {
  if (summary) return summary->units;
  return tables ? tables->heading.units : "";
}

RunData read_run(const std::filesystem::path& directory, const std::string& label, double limit_mb) {
  require_run(directory, "report");
  RunData run{directory, label, io::read_summary(directory / "summary.json"), {}, {}, {}, {}};
  if (!run.summary)
    run.notes.emplace_back(path_exists(directory / "summary.json")
                               ? "summary.json cannot be read: it is damaged or of a version with other entries."
                               : "There is no summary.json: the run is under way, or ended before its first output.");
  run.record = read_record(directory / "model.json", run.notes);
  run.tables = read_tables(directory, run.notes);
  run.scene = read_scene(directory, run.record, run.units(), limit_mb);
  if (run.scene) {
    run.scene->title = run.title();
    if (!run.scene->note.empty()) run.notes.push_back(run.scene->note);
  } else {
    run.notes.emplace_back("There are no fields: the run wrote none (output.fields), or not yet.");
  }
  return run;
}

}  // namespace creepcontact::report
