#pragma once
/// Files that are installed with the program and that it starts or loads when they are needed.

#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::platform {

/// Where a companion of this name may be: in the directory of the program (that of the build), where it is installed
/// relative to the program, and where it was installed by the build; in the order in which they are tried.
std::vector<std::filesystem::path> companion_places(const std::string& name);

/// The first of these places at which there is a file that may be read (or, with `executable`, executed); empty: none.
std::filesystem::path find_companion(const std::string& name, bool executable);

/// Data that are installed with the program: a file or directory of this name in the directory of the program (that of
/// the build), or in share/creepcontact; empty: none.
std::filesystem::path find_shared(const std::string& name);

}  // namespace creepcontact::platform
