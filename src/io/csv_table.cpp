#include "creepcontact/io/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "creepcontact/base/error.hpp"
#include "csv_text.hpp"
#include "file_text.hpp"

namespace creepcontact::io {
namespace {

double number(const std::string& cell, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    throw ConfigError(fmt::format("{}: '{}' is not a number", where, cell));
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
  return found == names.end() ? nullptr : &columns[found - names.begin()];
}

CsvTable parse_csv_table(std::string_view text, const std::string& name, UnendedRow unended) {
  CsvLines lines(text);
  std::string_view line;
  if (!lines.next(line)) throw ConfigError(fmt::format("{}: no header", name));
  CsvTable table;
  table.names = csv_cells(line);
  table.columns.resize(table.names.size());
  for (int row = 2; lines.next(line); ++row) {
    if (!lines.ended() && unended == UnendedRow::is_left_out) break;
    const std::vector<std::string> found = csv_cells(line);
    if (found.size() == 1 && found[0].empty()) continue;
    const std::string where = fmt::format("{}:{}", name, row);
    if (found.size() != table.names.size())
      throw ConfigError(fmt::format("{}: {} cells under {} columns", where, found.size(), table.names.size()));
    for (std::size_t c = 0; c < found.size(); ++c) table.columns[c].push_back(number(found[c], where));
  }
  return table;
}

CsvTable read_csv_table(const std::filesystem::path& path, UnendedRow unended) {
  return parse_csv_table(file_text<ConfigError>(path), path.string(), unended);
}

}  // namespace creepcontact::io
