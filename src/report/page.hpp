#pragma once
/// What all pages have: styles, the script of the interactive view, and how they come into a file.

#include <filesystem>
#include <string>

#include "html.hpp"

namespace creepcontact::report {

enum class Script { embedded, none };

/// Up to <body>. Without script the page forbids all scripts.
void open_page(const std::string& title, Html& page, Script script = Script::embedded);
/// The script, and the end.
void close_page(Html& page, Script script = Script::embedded);
/// Makes the directory of a file. @throws ConfigError with the option and the reason
void make_parent_directory(const std::filesystem::path& file, const char* option);
/// @param option  of the command line that names the file, for messages
void write_page(const std::filesystem::path& file, const std::string& text, const char* option);

}  // namespace creepcontact::report
