#include <fmt/format.h>

#include "creepcontact/model/range_monitor.hpp"
#include "preparation.hpp"

namespace creepcontact::run {

std::vector<std::string> settings_warnings(const config::Config& config) {
  std::vector<std::string> warnings = config.remarks;
  for (std::string& warning : model::RangeMonitor::time_warnings(config)) warnings.push_back(std::move(warning));
  const config::Time& time = config.time;
  const bool controls_errors = !time.integrator.ends_with("_euler") || time.step.mode == settings::StepMode::adaptive;
  const bool iterates = config.contact_solver.method == settings::ContactMethod::schwarz;
  if (!config.contacts.empty() && iterates && controls_errors && config.contact_solver.tolerance > time.tolerance)
    warnings.push_back(
        fmt::format("contact_solver.tolerance = {:g} is looser than time.tolerance = {:g}: the errors of contact will "
                    "dominate, and steps that they disturb are repeated; set it to a tenth of time.tolerance",
                    config.contact_solver.tolerance, time.tolerance));
  constexpr double min_jump_tolerance = 3;  // of time.tolerance
  if (time.jump_cycles && controls_errors && time.jump_tolerance < min_jump_tolerance * time.tolerance)
    warnings.push_back(fmt::format(
        "time.jump_tolerance = {:g} is near time.tolerance = {:g}: the errors of the cycles that are computed "
        "make jumps fail; set it to ten times time.tolerance",
        time.jump_tolerance, time.tolerance));
  return warnings;
}

}  // namespace creepcontact::run
