#include "syntax_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "item.hpp"

namespace creepcontact::config {
namespace {

constexpr std::size_t longest_line = 300;  // regular expressions recurse with the length of what they match

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line.substr(0, longest_line));
  }
  return lines;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

/// The name in "[name]" or "[[name]]"; empty if the line is not a heading.
std::string heading_of(const std::string& line) {
  std::smatch found;
  static const std::regex heading(R"(^\s*\[\[?\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$)");
  return std::regex_match(line, found, heading) ? found[1].str() : std::string();
}

/// A heading that an earlier one forbids.
std::string repeated_heading(const Lines& lines, std::size_t at, const std::vector<KeyInfo>& schema) {
  const std::string name = heading_of(lines[at]);
  if (name.empty()) return {};
  const std::string path = schema_path(name);
  const auto key =
      std::find_if(schema.begin(), schema.end(), [&](const KeyInfo& one) { return without_indices(one.path) == path; });
  std::size_t first = 0;
  while (first < at && heading_of(lines[first]) != name) ++first;
  const std::string before = first < at ? fmt::format(", and in line {}", first + 1) : "";
  if (key != schema.end() && key->form == Form::tables)
    return fmt::format("[{0}] appears here{1}: each of several entries needs two brackets, [[{0}]]", name, before);
  return fmt::format("the table [{}] appears here{}: put all its keys under one heading", name,
                     before.empty() ? " for the second time" : before);
}

/// A value as it is written around a column.
struct Written {
  std::string key;  ///< empty in a list
  std::string value;
};

Written written_at(const std::string& line, std::size_t column) {
  constexpr std::string_view before = "=[{,", after = ",]}#";
  const std::size_t stop = std::min(column, line.size());
  std::size_t begin = stop;
  while (begin > 0 && before.find(line[begin - 1]) == std::string_view::npos) --begin;
  const std::size_t end = std::min(line.find_first_of(after, stop), line.size());
  Written written{{}, trimmed(line.substr(begin, end - begin))};
  if (begin == 0 || line[begin - 1] != '=') return written;
  std::size_t key = begin - 1;
  while (key > 0 && before.find(line[key - 1]) == std::string_view::npos) --key;
  written.key = trimmed(line.substr(key, begin - 1 - key));
  return written;
}

bool matches(const std::string& text, const char* pattern) {
  return std::regex_match(text, std::regex(pattern));
}

std::string decimal_comma(const std::string& line, std::size_t column) {
  static const std::regex with_comma(R"(([+-]?\d+),(\d+(?:[eE][+-]?\d+)?))");
  for (auto found = std::sregex_iterator(line.begin(), line.end(), with_comma); found != std::sregex_iterator();
       ++found) {
    const std::size_t begin = found->position();
    if (column < begin || column > begin + static_cast<std::size_t>(found->length())) continue;
    return fmt::format("'{}' has a decimal comma; write {}.{}", found->str(), (*found)[1].str(), (*found)[2].str());
  }
  return {};
}

/// A value that is neither a number nor a text in quotation marks.
std::string wrong_value(const Written& written) {
  const std::string& value = written.value;
  if (value.empty() || std::string_view("\"'[{").find(value.front()) != std::string_view::npos) return {};
  const std::string begin = written.key.empty() ? "" : written.key + " = ";
  std::string lower = value;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower == "true" || lower == "false") return fmt::format("'{}' must be in lower case: {}{}", value, begin, lower);
  if (matches(value, R"([+-]?0\d+)")) return fmt::format("'{}': numbers must not have leading zeros", value);
  if (matches(value, R"([+-]?(\d+\.|\.\d+)([eE][+-]?\d+)?)"))
    return fmt::format("'{}': a number needs digits on both sides of the point, as in 1.0 or 0.5", value);
  if (matches(value, R"([+-]?\d+(\.\d+)?([eE][+-]?\d+)?\s+[A-Za-z%].*)"))
    return fmt::format("'{}': write numbers without units; use one consistent set of units for all of them", value);
  if (matches(value, R"(([A-Za-z_\\/~]|\.\.?/)[^"]*)") && !matches(value, R"(.*[*+()^].*)"))
    return fmt::format("'{0}' is text and needs quotation marks: {1}\"{0}\"", value, begin);
  if (matches(value, R"([^"]*[*/+()^-][^"]*)"))
    return fmt::format("'{0}' is not a number; an expression needs quotation marks: {1}\"{0}\"", value, begin);
  return {};
}

}  // namespace

std::string explain_syntax(const std::string& text, const Location& where, std::string_view description,
                           const std::vector<KeyInfo>& schema) {
  const auto says = [&](std::string_view words) { return description.find(words) != std::string_view::npos; };
  std::string own(description);
  const Lines lines = lines_of(text);
  if (where.line < 1 || static_cast<std::size_t>(where.line) > lines.size()) return own;
  const auto at = static_cast<std::size_t>(where.line) - 1;
  const std::string& line = lines[at];
  const std::size_t column = where.column > 0 ? static_cast<std::size_t>(where.column) - 1 : 0;
  if (column >= longest_line) return own;

  if (says("cannot redefine")) {
    if (std::string heading = repeated_heading(lines, at, schema); !heading.empty()) return heading;
    return "the key is given for the second time; remove one of the two";
  }
  if (says("escape sequence"))
    return "a backslash has a special meaning in double quotation marks; write / in paths, or use single quotation "
           "marks";
  if (says("parsing string")) return "the text has no closing quotation mark on its line";
  if (std::string comma = decimal_comma(line, column); !comma.empty()) return comma;
  if (trimmed(line).starts_with("//")) return "a comment begins with #";
  if (says("inline table"))
    return "a table in braces must end on the line where it begins, without a comma after its last key; write a longer "
           "table under its own heading";
  if (line.find('=') == std::string::npos && line.find_first_of("[]") == std::string::npos)
    return fmt::format("'{}' is not an assignment: a line is written key = value", trimmed(line));
  if (std::string value = wrong_value(written_at(line, column)); !value.empty()) return value;
  return own;
}

}  // namespace creepcontact::config
