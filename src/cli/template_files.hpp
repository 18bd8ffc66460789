#pragma once
/// The files of configs/templates, as parts of the program.

#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::cli {

struct TemplateFile {
  std::string of;    ///< name of the template
  std::string name;  ///< of the file
  std::string_view text;
};

/// All files of all templates, sorted by template.
const std::vector<TemplateFile>& template_files();

/// A line per template: its name and what it is, for a terminal.
std::string list_templates(bool markdown);

}  // namespace creepcontact::cli
