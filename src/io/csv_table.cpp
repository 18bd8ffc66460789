#include "creepcontact/io/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>

#include "creepcontact/base/error.hpp"

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

std::size_t CsvTable::find(const std::string& column) const {
  return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
}

CsvTable read_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  if (!stream || !std::getline(stream, line))
    throw ConfigError(fmt::format("{}: cannot be read: {}", file.string(),
                                  stream.is_open() ? "no header" : std::generic_category().message(errno)));
  CsvTable table;
  table.columns = cells(line);
  table.values.resize(table.columns.size());
  for (int row = 2; std::getline(stream, line); ++row) {
    const std::vector<std::string> found = cells(line);
    if (found.size() == 1 && found[0].empty()) continue;
    const std::string where = fmt::format("{}:{}", file.string(), row);
    if (found.size() != table.columns.size())
      throw ConfigError(fmt::format("{}: {} cells under {} columns", where, found.size(), table.columns.size()));
    for (std::size_t c = 0; c < found.size(); ++c) table.values[c].push_back(number(found[c], where));
  }
  return table;
}

}  // namespace creepcontact::io
