#pragma once
/// Text that users give, in the commands of gnuplot.

#include <string>
#include <string_view>

namespace creepcontact::plot {

/// Puts the text in single quotes, where gnuplot neither runs commands nor expands anything. Control characters become
/// spaces, bytes that are not UTF-8 a question mark: an SVG file holds neither.
std::string gnuplot_quoted(std::string_view text);

/// Number of characters, not of bytes.
std::size_t text_width(std::string_view text);

/// Cuts the text and adds an ellipsis if it is longer than `width` characters.
std::string shortened(std::string_view text, std::size_t width);

}  // namespace creepcontact::plot
