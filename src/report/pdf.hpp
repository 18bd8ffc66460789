#pragma once
/// Pages as PDF files.

#include <filesystem>
#include <string>

namespace creepcontact::report {

/// @throws ConfigError if there is no Chromium, saying what to do
void require_browser();

/// Prints a page by Chromium in a process without network and settings of the user's. @returns megabytes
/// @throws ConfigError if there is no Chromium, saying what to do; Error (exit status 4) with its message if it fails
/// Cost: some seconds.
double print_pdf(const std::string& page, const std::filesystem::path& file);

}  // namespace creepcontact::report
