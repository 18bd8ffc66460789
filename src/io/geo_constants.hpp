#pragma once
/// Which constants of a .geo can be overridden: the library does not tell.

#include <filesystem>
#include <set>
#include <string>

namespace creepcontact::io {

/// Names of the numbers that a .geo and the files it includes make with DefineConstant. Files that cannot be read count
/// as empty (Gmsh itself reports them).
std::set<std::string> geo_constants(const std::filesystem::path& file);

}  // namespace creepcontact::io
