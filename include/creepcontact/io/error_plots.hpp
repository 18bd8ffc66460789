#pragma once
/// What an accuracy costs, method by method: the pictures of a study.

#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::io {

/// Runs of one method, one an entry of each list; an entry that is not known is NaN.
struct MethodErrors {
  std::string name;
  std::string setting_name;  ///< what was varied: "time.step", "time.tolerance"
  std::vector<double> setting, elastic_solves, wall_seconds, error;
};

/// Log-log pictures of the error over the setting (`error_over_<setting_name>`, one for each that occurs), over
/// elastic solves (`error_over_solves`) and over wall-clock seconds (`error_over_seconds`): SVG and PNG with script and
/// data, as draw(). More methods than a picture takes are spread over several (`..._2`).
/// A logarithmic axis takes no entry that is zero, negative or NaN; it is left out, and so is a picture without
/// entries.
/// @param error_label  of the error's axis: "error of fit_pressure, relative"
/// @param stem  begins the names of the files if not empty: `<stem>_error_over_solves`
/// @returns the SVG files
/// @throws ConfigError if the lists of a method differ in length; as draw()
std::vector<std::filesystem::path> plot_errors(const std::filesystem::path& directory, const std::string& title,
                                               const std::string& error_label, const std::vector<MethodErrors>& methods,
                                               const std::string& stem = {});

}  // namespace creepcontact::io
