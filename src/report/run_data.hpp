#pragma once
/// Everything a report says of one run, as read from its directory.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/units.hpp"
#include "creepcontact/io/tables/model_record.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/plot/run_plots.hpp"
#include "scene.hpp"

namespace creepcontact::report {

struct RunData {
  std::filesystem::path directory;
  std::string label;                   ///< tells it from the other runs
  std::optional<io::Summary> summary;  ///< nullopt: there is none, or it is of a version that cannot be read
  io::ModelRecord record;              ///< empty if the run is of a version before it
  std::optional<plot::RunTables> tables;
  std::optional<Scene> scene;
  std::vector<std::string> notes;  ///< what is missing, a sentence each

  std::string title() const;
  std::string units() const;
  /// Unit of a dimension in this run.
  std::string unit(Dimension dimension) const { return unit_of(dimension, units()); }
};

/// @param limit_mb  of the fields @throws as write_report()
RunData read_run(const std::filesystem::path& directory, const std::string& label, double limit_mb);

}  // namespace creepcontact::report
