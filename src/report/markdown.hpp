#pragma once
/// Markdown of configurations as HTML.

#include <string>
#include <string_view>

namespace creepcontact::report {

/// Paragraphs, headings, lists, tables, emphasis, code and links. HTML in the text is shown as it is written. Links
/// lead to http, https and mailto alone; of others, and of images, the text remains.
/// @param heading  level of the headings "#" of the text: 3 makes <h3>
std::string markdown(std::string_view text, int heading);

}  // namespace creepcontact::report
