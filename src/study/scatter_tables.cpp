#include "scatter_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/io/tables/csv_table.hpp"

namespace creepcontact::study {
namespace {

using TableCells = std::vector<std::string>;

std::string number_cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string table_line(const TableCells& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (&cell == cells.data() ? "" : ",") + io::csv_cell(cell);
  return line + '\n';
}

/// Keys that are set in any combination, in the order in which they come.
TableCells setting_keys(const std::vector<config::PlannedRun>& runs, const Scatter& scatter) {
  TableCells keys;
  for (const ScatterGroup& group : scatter.groups)
    for (const config::Setting& setting : runs[group.first_run].settings)
      if (std::ranges::count(keys, setting.key) == 0) keys.push_back(setting.key);
  return keys;
}

/// A table whose rows begin with the settings of their group.
class GroupedTable {
 public:
  GroupedTable(const std::vector<config::PlannedRun>& runs, const Scatter& scatter, const TableCells& columns)
      : runs_(runs), keys_(setting_keys(runs, scatter)) {
    TableCells head = keys_;
    head.insert(head.end(), columns.begin(), columns.end());
    text_ = table_line(head);
  }
  void add(const ScatterGroup& group, const TableCells& cells) {
    TableCells line;
    for (const std::string& key : keys_) {
      std::string value;
      for (const config::Setting& setting : runs_[group.first_run].settings)
        if (setting.key == key) value = setting.value.label;
      line.push_back(value);
    }
    line.insert(line.end(), cells.begin(), cells.end());
    text_ += table_line(line);
  }
  const std::string& text() const { return text_; }

 private:
  const std::vector<config::PlannedRun>& runs_;
  TableCells keys_;
  std::string text_;
};

std::string quantiles_csv(const std::vector<config::PlannedRun>& runs, const Scatter& scatter) {
  TableCells columns{"time"};
  for (const std::string& probe : scatter.probes)
    for (const double quantile : scatter.quantiles)
      columns.push_back(fmt::format("{}_q{}", probe, percent_name(quantile)));
  for (const std::string& probe : scatter.probes)
    for (const double quantile : scatter.quantiles)
      for (const char* const bound : {"low", "high"})
        columns.push_back(fmt::format("{}_q{}_{}", probe, percent_name(quantile), bound));
  columns.push_back("samples");
  GroupedTable table(runs, scatter, columns);
  for (const ScatterGroup& group : scatter.groups)
    for (std::size_t t = 0; t < group.times.size(); ++t) {
      TableCells cells{number_cell(group.times[t])};
      std::size_t samples = group.planned;
      for (const QuantileCourse& probe : group.probes) {
        for (const QuantileEstimate& one : probe.at[t]) cells.push_back(number_cell(one.value));
        samples = std::min(samples, probe.samples[t]);
      }
      for (const QuantileCourse& probe : group.probes)
        for (const QuantileEstimate& one : probe.at[t]) {
          cells.push_back(number_cell(one.low));
          cells.push_back(number_cell(one.high));
        }
      cells.push_back(std::to_string(samples));
      table.add(group, cells);
    }
  return table.text();
}

/// Events and criteria of any group, in the order of the first that has them.
std::vector<std::pair<std::string, bool>> happenings_in(const Scatter& scatter) {
  std::vector<std::pair<std::string, bool>> all;
  for (const ScatterGroup& group : scatter.groups)
    for (const Happening& one : group.happenings)
      if (std::ranges::count(all, std::pair(one.name, one.is_at_end)) == 0) all.emplace_back(one.name, one.is_at_end);
  return all;
}

std::string probabilities_csv(const std::vector<config::PlannedRun>& runs, const Scatter& scatter) {
  const auto all = happenings_in(scatter);
  TableCells columns{"time"};
  for (const auto& [name, is_at_end] : all) columns.insert(columns.end(), {name, name + "_low", name + "_high"});
  columns.push_back("samples");
  GroupedTable table(runs, scatter, columns);
  for (const ScatterGroup& group : scatter.groups)
    for (std::size_t t = 0; t < group.times.size() && group.succeeded > 0; ++t) {
      TableCells cells{number_cell(group.times[t])};
      for (const auto& [name, is_at_end] : all) {
        const auto one = std::ranges::find(group.happenings, name, &Happening::name);
        if (is_at_end && t + 1 < group.times.size()) {
          cells.insert(cells.end(), 3, "");
          continue;
        }
        const statistics::Proportion p = one == group.happenings.end() ? statistics::proportion(0, group.succeeded)
                                                                       : probability_at(*one, group.times[t]);
        for (const double value : {p.value, p.low, p.high}) cells.push_back(number_cell(value));
      }
      cells.push_back(std::to_string(group.succeeded));
      table.add(group, cells);
    }
  return table.text();
}

std::string correlation_csv(const std::vector<config::PlannedRun>& runs, const Scatter& scatter) {
  TableCells columns{"result"};
  columns.insert(columns.end(), scatter.keys.begin(), scatter.keys.end());
  GroupedTable table(runs, scatter, columns);
  for (const ScatterGroup& group : scatter.groups)
    for (std::size_t r = 0; r < group.results.size(); ++r) {
      TableCells cells{group.results[r].name};
      for (const double value : group.rank_correlations[r]) cells.push_back(number_cell(value));
      table.add(group, cells);
    }
  return table.text();
}

std::string sobol_indices_csv(const std::vector<config::PlannedRun>& runs, const Scatter& scatter) {
  TableCells columns{"result"};
  columns.insert(columns.end(), scatter.keys.begin(), scatter.keys.end());
  columns.insert(columns.end(), {"interactions", "quality", "degree"});
  GroupedTable table(runs, scatter, columns);
  for (const ScatterGroup& group : scatter.groups)
    for (std::size_t r = 0; r < group.results.size(); ++r) {
      const statistics::VarianceShares& shares = group.shares[r];
      const bool is_good = shares.quality >= min_quality && !shares.first_order.empty();
      TableCells cells{group.results[r].name};
      for (std::size_t k = 0; k < scatter.keys.size(); ++k)
        cells.push_back(is_good ? number_cell(shares.first_order[k]) : std::string());
      cells.push_back(is_good ? number_cell(shares.interactions) : std::string());
      cells.push_back(shares.first_order.empty() ? std::string() : number_cell(shares.quality));
      cells.push_back(is_good ? std::to_string(shares.degree) : std::string());
      table.add(group, cells);
    }
  return table.text();
}

std::string convergence_csv(const std::vector<config::PlannedRun>& runs, const Scatter& scatter) {
  TableCells columns{"samples"};
  for (const std::string& probe : scatter.probes)
    for (const double quantile : scatter.quantiles)
      columns.push_back(fmt::format("{}_q{}", probe, percent_name(quantile)));
  GroupedTable table(runs, scatter, columns);
  constexpr std::size_t least = 8;
  for (const ScatterGroup& group : scatter.groups)
    for (std::size_t n = std::min(least, group.planned);; n = std::min(2 * n, group.planned)) {
      TableCells cells{std::to_string(n)};
      for (std::size_t p = 0; p < scatter.probes.size(); ++p) {
        std::vector<double> first = group.results[end_of_probe(p)].values;
        first.resize(n);
        const std::vector<double> sorted = sorted_known(std::move(first));
        for (const double quantile : scatter.quantiles)
          cells.push_back(sorted.empty() ? std::string() : number_cell(statistics::quantile(sorted, quantile)));
      }
      table.add(group, cells);
      if (n == group.planned) break;
    }
  return table.text();
}

}  // namespace

std::string samples_csv(const config::Study& study, const std::vector<config::PlannedRun>& runs) {
  TableCells head{"run"};
  for (const config::RandomKey& key : study.random->keys) head.push_back(key.key.name);
  std::string text = table_line(head);
  for (const config::PlannedRun& run : runs) {
    TableCells cells{run.name};
    for (const double value : run.sampled) cells.push_back(number_cell(value));
    text += table_line(cells);
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> scatter_tables(const std::vector<config::PlannedRun>& runs,
                                                                const Scatter& scatter) {
  std::vector<std::pair<std::string, std::string>> tables{{"quantiles.csv", quantiles_csv(runs, scatter)},
                                                          {"probabilities.csv", probabilities_csv(runs, scatter)},
                                                          {"correlation.csv", correlation_csv(runs, scatter)},
                                                          {"convergence.csv", convergence_csv(runs, scatter)}};
  if (!scatter.is_correlated) tables.emplace_back("sobol_indices.csv", sobol_indices_csv(runs, scatter));
  return tables;
}

}  // namespace creepcontact::study
