#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "creepcontact/base/utf8.hpp"
#include "engineering.hpp"

namespace creepcontact::report {
std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t n = utf8_length(text);
    const char c = text.front();
    if (n == 0)
      result += "\xEF\xBF\xBD";  // U+FFFD
    else if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\'')
      result += "&#39;";
    else
      result += text.substr(0, n);
    text.remove_prefix(std::max<std::size_t>(n, 1));
  }
  return result;
}

void Html::open(std::string_view tag, std::string_view attributes) {
  text_ += fmt::format("<{}{}{}>\n", tag, attributes.empty() ? "" : " ", attributes);
}

void Html::close(std::string_view tag) {
  text_ += fmt::format("</{}>\n", tag);
}

void Html::element(std::string_view tag, std::string_view text, std::string_view attributes) {
  text_ += fmt::format("<{0}{1}{2}>{3}</{0}>\n", tag, attributes.empty() ? "" : " ", attributes, escaped(text));
}

void Html::table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                 std::string_view caption) {
  std::vector<bool> numbers(rows.empty() ? 0 : rows.front().size(), true);
  for (const std::vector<std::string>& row : rows)
    for (std::size_t c = 0; c < numbers.size(); ++c)
      numbers[c] = numbers[c] && c < row.size() && is_number_text(row[c]);
  const auto alignment = [&](std::size_t c) {
    return c > 0 && c < numbers.size() && numbers[c] ? "class=\"number\"" : "";
  };
  // Boxes that scroll must be reached by the keyboard.
  open("div", "class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"" +
                  escaped(caption.empty() ? "table" : caption) + "\"");
  open("table");
  if (!caption.empty()) element("caption", caption);
  if (!head.empty()) {
    open("thead");
    open("tr");
    for (std::size_t c = 0; c < head.size(); ++c) element(head[c].empty() ? "td" : "th", head[c], alignment(c));
    close("tr");
    close("thead");
  }
  open("tbody");
  for (const std::vector<std::string>& row : rows) {
    open("tr");
    for (std::size_t c = 0; c < row.size(); ++c)
      element(c == 0 ? "th" : "td", row[c], c == 0 ? "scope=\"row\"" : alignment(c));
    close("tr");
  }
  close("tbody");
  close("table");
  close("div");
}

void Html::figure(std::string_view url, std::string_view alternative, const std::string& caption) {
  figures_.push_back(caption);
  open("figure", fmt::format("id=\"figure-{}\"", figures_.size()));
  text_ += fmt::format("<img src=\"{}\" alt=\"{}\">\n", url, escaped(alternative));
  element("figcaption", fmt::format("Figure {}: {}", figures_.size(), caption));
  close("figure");
}

}  // namespace creepcontact::report
