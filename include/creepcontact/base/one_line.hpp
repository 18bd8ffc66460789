#pragma once
/// Text from outside, such as the name of a file, within a line that is written.

#include <string>
#include <string_view>

namespace creepcontact {

/// The text with a blank for each control character (line ends, tabs, escape sequences), and with '?' for bytes that
/// are not UTF-8: it cannot end a comment or make a file unreadable.
std::string one_line(std::string_view text);

}  // namespace creepcontact
