#pragma once
/// Pictures of bodies and of fields on them are drawn by VTK, in a process of Python.

#include <filesystem>
#include <string>

namespace creepcontact::plot {

/// Draws PNG files. Cost: seconds for the process, then tenths of a second per picture.
/// @param jobs  a list in JSON, described in src/plot/picture.py. @param place  a private directory for the outputs.
/// @throws ConfigError if Python, VTK or a virtual display is missing (naming the package); Error (exit status 4) with
/// the message of the process if it fails
void draw_by_vtk(const std::string& jobs, const std::filesystem::path& place);

}  // namespace creepcontact::plot
