#include "creepcontact/io/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"

namespace creepcontact::io {
namespace {

/// Cells of a line; those in quotes may hold commas.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      all.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      all.emplace_back();
    else if (line[i] != '\r')
      all.back() += line[i];
  }
  for (std::string& cell : all) {
    cell.erase(0, cell.find_first_not_of(" \t"));
    cell.erase(cell.find_last_not_of(" \t") + 1);
  }
  return all;
}

double number(const std::string& cell, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    throw ConfigError(fmt::format("{}: '{}' is no number", where, cell));
  return value;
}

}  // namespace

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

const std::vector<double>* CsvTable::column(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

CsvTable read_csv_table(const std::filesystem::path& path, UnendedRow unended) {
  if (const std::string reason = why_unreadable(path); !reason.empty())
    throw ConfigError(fmt::format("{}: cannot be read: {}", path.string(), reason));
  std::ifstream stream(path);
  std::string line;
  if (!stream || !std::getline(stream, line))
    throw ConfigError(fmt::format("{}: cannot be read: {}", path.string(),
                                  stream.is_open() ? "no header" : std::generic_category().message(errno)));
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // the mark that Excel sets before UTF-8
  CsvTable table;
  table.names = cells(line);
  table.columns.resize(table.names.size());
  for (int row = 2; std::getline(stream, line); ++row) {
    if (stream.eof() && unended == UnendedRow::is_left_out) break;
    const std::vector<std::string> found = cells(line);
    if (found.size() == 1 && found[0].empty()) continue;
    const std::string where = fmt::format("{}:{}", path.string(), row);
    if (found.size() != table.names.size())
      throw ConfigError(fmt::format("{}: {} cells under {} columns", where, found.size(), table.names.size()));
    for (std::size_t c = 0; c < found.size(); ++c) table.columns[c].push_back(number(found[c], where));
  }
  return table;
}

}  // namespace creepcontact::io
