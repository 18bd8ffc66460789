#include "gnuplot_text.hpp"

#include "creepcontact/base/utf8.hpp"

namespace creepcontact::plot {
std::string gnuplot_quoted(std::string_view text) {
  std::string result = "'";
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    const auto c = static_cast<unsigned char>(text[i]);
    if (length == 0) {
      result += '?';
    } else if (c < 0x20 || c == 0x7F) {
      result += ' ';
    } else if (c == '\'') {
      // gnuplot knows neither two in a row nor one at the beginning.
      result += result.size() == 1 || result.ends_with("''") ? "\u2019" : "''";
    } else {
      result += text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return result + "'";
}

std::size_t text_width(std::string_view text) {
  std::size_t width = 0;
  for (char c : text) width += continues_utf8(c) ? 0 : 1;
  return width;
}

std::string shortened(std::string_view text, std::size_t width) {
  if (text_width(text) <= width) return std::string(text);
  std::size_t end = 0;
  for (std::size_t characters = 0; end < text.size(); ++end)
    if (!continues_utf8(text[end]) && ++characters == width) break;
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace creepcontact::plot
