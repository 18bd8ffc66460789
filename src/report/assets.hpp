#pragma once
/// Files that are part of the program.

#include <string_view>

namespace creepcontact::report {

std::string_view viewer_script();  ///< bundle of web/report; empty if the program was built without
std::string_view viewer_style();   ///< the same
std::string_view report_style();   ///< report.css
std::string_view colours();        ///< web/report/src/colours.json: [[position, red, green, blue], ...]

}  // namespace creepcontact::report
