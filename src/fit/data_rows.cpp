#include "data_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"

namespace creepcontact::fit {
namespace {

constexpr std::size_t max_mistakes = 20;
constexpr std::size_t fewest_to_group = 3;  // rows with the same mistake

/// "2-5, 9"
std::string ranges_of(const std::vector<int>& lines) {
  std::vector<std::string> ranges;
  for (std::size_t first = 0, last = 0; first < lines.size(); first = ++last) {
    while (last + 1 < lines.size() && lines[last + 1] == lines[last] + 1) ++last;
    ranges.push_back(first == last ? fmt::format("{}", lines[first]) : fmt::format("{}-{}", lines[first], lines[last]));
  }
  return fmt::format("{}", fmt::join(ranges, ", "));
}

std::string without_numbers(const std::string& message) {
  static const std::regex number(R"([-+]?\d+\.?\d*(e[-+]?\d+)?)");
  return std::regex_replace(message, number, "#");
}

const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> names{"creep", "relaxation", "rupture", "rate"};
  return names;
}

/// Reads the cells of one row.
class RowReader {
 public:
  RowReader(const io::CsvCells& table, const DataColumns& columns, io::Thousands thousands, RowMistakes& mistakes)
      : columns_(columns), numbers_(table.format, thousands, "--thousands"), mistakes_(mistakes) {}

  /// @returns false if the row has a mistake
  bool read(const io::CsvCells::Row& row, bool strain_is_total, DataRow& into) {
    row_ = &row;
    right_ = true;
    into.line = row.line;
    into.test = text(ColumnRole::test);
    into.batch = text(ColumnRole::batch);
    into.time = number(ColumnRole::time, 0);
    into.rate = number(ColumnRole::rate);
    into.rupture = number(ColumnRole::rupture);
    const auto creep_strain = number(ColumnRole::creep_strain), total = number(ColumnRole::total_strain),
               strain = number(ColumnRole::strain);
    into.strain = creep_strain ? creep_strain : total ? total : strain;
    into.strain_is_total = !creep_strain && (total || (strain && strain_is_total));
    const auto stress = number(ColumnRole::stress);
    const auto temperature = number(ColumnRole::temperature);
    into.kind = kind(into);
    if (!right_) return false;
    require_all(into, stress, temperature);
    return right_;
  }

 private:
  std::string text(ColumnRole role) const { return columns_[role] ? row_->cells[columns_[role]->index] : ""; }

  void mistake(const std::string& message) {
    mistakes_.add(row_->line, message);
    right_ = false;
  }

  std::optional<double> number(ColumnRole role, std::optional<double> least = {}) {
    const std::string cell = text(role);
    if (cell.empty()) return std::nullopt;
    const auto [value, reason] = numbers_.read(cell, static_cast<std::size_t>(row_->line));
    if (!value || !std::isfinite(*value)) {
      mistake(fmt::format("column '{}': {}", columns_[role]->name,
                          value ? fmt::format("'{}' is not a number", cell) : reason));
      return std::nullopt;
    }
    if (least && *value < *least) {
      mistake(fmt::format("column '{}': {}; allowed: numbers >= {}", columns_[role]->name, cell, *least));
      return std::nullopt;
    }
    return *value * columns_[role]->factor;
  }

  std::optional<TestKind> kind(const DataRow& row) {
    if (const std::string word = text(ColumnRole::kind); !word.empty()) {
      const auto& names = kind_names();
      for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i]) return static_cast<TestKind>(i);
      mistake(fmt::format("column '{}': '{}'{}; allowed: {}", columns_[ColumnRole::kind]->name, word,
                          did_you_mean(word, names), fmt::join(names, ", ")));
      return std::nullopt;
    }
    if (row.strain && row.rate) mistake("has a strain and a rate; allowed: one of them per row");
    if (row.strain) return TestKind::creep;
    if (row.rate) return TestKind::rate;
    if (row.time) return TestKind::rupture;
    if (!row.rupture) mistake("has no reading: no time, strain, rate or time to rupture");
    return std::nullopt;
  }

  void require(bool condition, const std::string& message) {
    if (!condition) mistake(message);
  }

  void require_all(DataRow& row, const std::optional<double>& stress, const std::optional<double>& temperature) {
    if (columns_[ColumnRole::batch]) require(!row.batch.empty(), "has no batch");
    if (columns_[ColumnRole::temperature]) require(temperature.has_value(), "has no temperature");
    row.temperature = temperature.value_or(0);
    if (!stress)
      mistake("has no stress");
    else
      require(*stress > 0, fmt::format("stress {:g}; allowed: stresses > 0 (give the magnitude)", *stress));
    row.stress = stress.value_or(0);
    if (row.rupture) require(*row.rupture > 0, fmt::format("time to rupture {:g}; allowed: times > 0", *row.rupture));
    if (!row.kind) return;
    const std::string what = name_of(*row.kind);
    if (*row.kind != TestKind::rate) require(row.time.has_value(), fmt::format("has no time ({})", what));
    if (*row.kind == TestKind::creep) require(row.strain.has_value(), "has no strain (creep)");
    if (*row.kind == TestKind::rupture && row.time)
      require(*row.time > 0,
              fmt::format("time to rupture {:g}; allowed: times > 0{}", *row.time,
                          text(ColumnRole::kind).empty()
                              ? " (rows with a stress and a time alone are times to rupture; a relaxation test "
                                "needs a column 'kind' with the word relaxation in each row)"
                              : ""));
    if (*row.kind == TestKind::rate) {
      if (!row.rate)
        mistake("has no rate");
      else
        require(*row.rate > 0, fmt::format("rate {:g}; allowed: rates > 0", *row.rate));
    }
    if (row.strain)
      require(std::abs(*row.strain) <= 1,
              fmt::format("strain {:g}, more than 100 %; if the column is in per cent, name "
                          "it 'strain [%]'",
                          *row.strain));
  }

  const DataColumns& columns_;
  io::CsvNumbers numbers_;
  RowMistakes& mistakes_;
  const io::CsvCells::Row* row_ = nullptr;
  bool right_ = true;
};

}  // namespace

void RowMistakes::add(int line, const std::string& message) {
  mistakes_.push_back({line, message});
}

void RowMistakes::throw_if_any() const {
  if (mistakes_.empty()) return;
  std::vector<Mistake> sorted = mistakes_;
  std::ranges::stable_sort(sorted, {}, &Mistake::line);
  std::map<std::string, std::vector<const Mistake*>> groups;
  std::vector<std::vector<const Mistake*>*> group_of;
  for (const Mistake& mistake : sorted) {
    group_of.push_back(&groups[without_numbers(mistake.message)]);
    group_of.back()->push_back(&mistake);
  }
  std::vector<std::string> shown;
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const Mistake& mistake = sorted[i];
    const std::vector<const Mistake*>& group = *group_of[i];
    const bool grouped = group.size() >= fewest_to_group;
    if (grouped && group.front() != &mistake) continue;
    if (shown.size() == max_mistakes) {
      left_out += grouped ? group.size() : 1;
      continue;
    }
    if (!grouped) {
      shown.push_back(fmt::format("{}:{}: {}", file_, mistake.line, mistake.message));
      continue;
    }
    std::vector<int> lines;
    lines.reserve(group.size());
    for (const Mistake* own : group) lines.push_back(own->line);
    const bool equal = std::ranges::all_of(group, [&](const Mistake* own) { return own->message == mistake.message; });
    shown.push_back(fmt::format("{}: {} rows (lines {}): {}{}", file_, group.size(), ranges_of(lines),
                                equal ? "" : fmt::format("in line {}: ", mistake.line), mistake.message));
  }
  if (left_out > 0) shown.push_back(fmt::format("{}: {} more bad rows", file_, left_out));
  throw ConfigError(fmt::format("{}", fmt::join(shown, "\n")));
}

const std::string& name_of(TestKind kind) {
  return kind_names()[static_cast<std::size_t>(kind)];
}

const std::string& value_of(TestKind kind) {
  static const std::vector<std::string> names{"creep strain", "stress", "time to rupture", "creep rate"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<DataRow> read_rows(const io::CsvCells& table, const DataColumns& columns, bool strain_is_total,
                               io::Thousands thousands, RowMistakes& mistakes) {
  for (const io::CsvCells::UnevenRow& row : table.uneven)
    mistakes.add(row.line, fmt::format("{} cells under {} columns", row.cells, table.names.size()));
  RowReader reader(table, columns, thousands, mistakes);
  std::vector<DataRow> rows;
  for (const io::CsvCells::Row& cells : table.rows)
    if (DataRow row; reader.read(cells, strain_is_total, row)) rows.push_back(row);
  return rows;
}

}  // namespace creepcontact::fit
