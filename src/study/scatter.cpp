#include "scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace creepcontact::study {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

statistics::Basis basis_of(const config::RandomKey& key) {
  const bool is_of_score = std::holds_alternative<statistics::Normal>(key.distribution) ||
                           std::holds_alternative<statistics::Lognormal>(key.distribution);
  return is_of_score ? statistics::Basis::normal_score : statistics::Basis::probability;
}

void count_runs(const std::vector<StudyRow>& rows, ScatterGroup& group) {
  group.planned = group.runs.size();
  for (const std::size_t run : group.runs) {
    group.succeeded += rows[run].succeeded();
    group.ruptured += rows[run].status == "ruptured";
    group.failed += rows[run].status == "failed";
  }
  group.missing = group.planned - group.succeeded - group.failed;
}

void add_quantiles(const Histories& histories, const std::vector<double>& quantiles, ScatterGroup& group) {
  group.times = histories.common_times(group.runs);
  for (std::size_t p = 0; p < histories.probes().size(); ++p) {
    QuantileCourse& course = group.probes.emplace_back();
    for (const double time : group.times) {
      const std::vector<double> sorted = sorted_known(histories.at(group.runs, p, time));
      std::vector<QuantileEstimate>& estimates = course.at.emplace_back();
      course.samples.push_back(sorted.size());
      for (const double quantile : quantiles) estimates.push_back(quantile_estimate(sorted, quantile));
      Fan& fan = course.fan.emplace_back();
      for (std::size_t i = 0; i < fan.size(); ++i)
        fan[i] = sorted.empty() ? ProbeCourse::unknown : statistics::quantile(sorted, fan_probabilities[i]);
    }
  }
}

/// Names that some run of the group has.
std::set<std::string> names_of(const std::vector<StudyRow>& rows, const ScatterGroup& group,
                               std::map<std::string, double> StudyRow::*of) {
  std::set<std::string> names;
  for (const std::size_t run : group.runs)
    if (rows[run].succeeded())
      for (const auto& [name, value] : rows[run].*of) names.insert(name);
  return names;
}

double value_in(const std::map<std::string, double>& values, const std::string& name, double otherwise) {
  const auto found = values.find(name);
  return found == values.end() || std::isnan(found->second) ? otherwise : found->second;
}

void add_results(const std::vector<StudyRow>& rows, const std::vector<std::string>& probes, ScatterGroup& group) {
  const auto add = [&](const std::string& name, const auto& value) {
    RunResult& result = group.results.emplace_back();
    result.name = name;
    for (const std::size_t run : group.runs)
      result.values.push_back(rows[run].succeeded() ? value(rows[run]) : ProbeCourse::unknown);
  };
  for (std::size_t p = 0; p < probes.size(); ++p) {
    const auto course = [p](const StudyRow& row) { return p < row.courses.size() ? row.courses[p] : ProbeCourse{}; };
    // A run that ruptured ends at another time than the others.
    add(probes[p] + "_end",
        [&](const StudyRow& row) { return row.status == "completed" ? course(row).end : ProbeCourse::unknown; });
    add(probes[p] + "_min", [&](const StudyRow& row) { return course(row).min; });
    add(probes[p] + "_max", [&](const StudyRow& row) { return course(row).max; });
  }
  for (const std::string& name : names_of(rows, group, &StudyRow::criteria))
    add("criterion_" + name, [&](const StudyRow& row) { return value_in(row.criteria, name, ProbeCourse::unknown); });
  for (const std::string& name : names_of(rows, group, &StudyRow::events))
    add("event_" + name, [&](const StudyRow& row) { return value_in(row.events, name, never); });
}

void add_happenings(const std::vector<StudyRow>& rows, ScatterGroup& group) {
  const auto add = [&](const std::string& name, bool is_at_end, const auto& time) {
    Happening& one = group.happenings.emplace_back();
    one.name = name;
    one.is_at_end = is_at_end;
    for (const std::size_t run : group.runs)
      if (rows[run].succeeded()) one.times.push_back(time(rows[run]));
    std::ranges::sort(one.times);
  };
  for (const std::string& name : names_of(rows, group, &StudyRow::events))
    add(name, false, [&](const StudyRow& row) { return value_in(row.events, name, never); });
  if (group.ruptured > 0)
    add("rupture", false, [](const StudyRow& row) { return row.status == "ruptured" ? row.end_time : never; });
  for (const std::string& name : names_of(rows, group, &StudyRow::criteria))
    add("not_met_" + name, true,
        [&](const StudyRow& row) { return value_in(row.criteria, name, 0) > 1 ? 0.0 : never; });
}

void add_influences(const config::Study& study, const std::vector<config::PlannedRun>& runs, const Scatter& scatter,
                    ScatterGroup& group) {
  std::vector<std::vector<double>> keys(scatter.keys.size());
  for (const std::size_t run : group.runs)
    for (std::size_t k = 0; k < keys.size(); ++k) keys[k].push_back(runs[run].sampled[k]);
  std::vector<statistics::Basis> bases;
  for (const config::RandomKey& key : study.random->keys) bases.push_back(basis_of(key));
  for (const RunResult& result : group.results) {
    std::vector<double>& own = group.rank_correlations.emplace_back();
    for (const std::vector<double>& key : keys) own.push_back(statistics::rank_correlation(key, result.values));
    if (!scatter.is_correlated)
      group.shares.push_back(statistics::variance_shares(scatter.scores, bases, result.values));
  }
}

/// The values of the axes and settings that distinguish a combination.
std::string label_of(const config::PlannedRun& run) {
  std::string label;
  for (const config::Setting& setting : run.settings)
    label += fmt::format("{}{} = {}", label.empty() ? "" : ", ", setting.key, setting.value.label);
  return label.empty() ? "as the base" : label;
}

}  // namespace

std::vector<double> sorted_known(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::ranges::sort(values);
  return values;
}

QuantileEstimate quantile_estimate(const std::vector<double>& sorted, double probability) {
  QuantileEstimate estimate;
  if (sorted.empty()) return estimate;
  estimate.value = statistics::quantile(sorted, probability);
  const statistics::QuantileBounds bounds = statistics::quantile_bounds(sorted.size(), probability);
  if (bounds.low) estimate.low = sorted[*bounds.low];
  if (bounds.high) estimate.high = sorted[*bounds.high];
  return estimate;
}

std::string percent_name(double probability) {
  std::string text = fmt::format("{:.10g}", 100 * probability);
  std::ranges::replace(text, '.', '_');
  return text.find('_') == 1 || text.size() == 1 ? "0" + text : text;
}

Scatter scatter_of(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                   const std::vector<StudyRow>& rows, const Histories& histories) {
  Scatter scatter;
  scatter.quantiles = study.random->quantiles;
  scatter.probes = histories.probes();
  for (const config::RandomKey& key : study.random->keys) scatter.keys.push_back(key.key.name);
  scatter.scores = config::scores_of(*study.random);
  scatter.is_correlated = !study.random->factor.empty();
  scatter.is_thinned = histories.is_thinned();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (runs[r].combination == scatter.groups.size()) scatter.groups.emplace_back().first_run = r;
    scatter.groups.back().runs.push_back(r);
  }
  for (ScatterGroup& group : scatter.groups) {
    if (scatter.groups.size() > 1) group.label = label_of(runs[group.first_run]);
    count_runs(rows, group);
    add_quantiles(histories, scatter.quantiles, group);
    add_results(rows, scatter.probes, group);
    add_happenings(rows, group);
    add_influences(study, runs, scatter, group);
  }
  return scatter;
}

statistics::Proportion probability_at(const Happening& one, double time) {
  const auto happened = std::ranges::upper_bound(one.times, time) - one.times.begin();
  return statistics::proportion(static_cast<std::size_t>(happened), one.times.size());
}

std::size_t end_of_probe(std::size_t probe) {
  constexpr std::size_t results_of_probe = 3;
  return results_of_probe * probe;
}

std::size_t leading_key(const ScatterGroup& group, std::size_t result) {
  const std::vector<double>& all = group.rank_correlations[result];
  std::size_t leading = all.size();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!std::isnan(all[k]) && (leading == all.size() || std::abs(all[k]) > std::abs(all[leading]))) leading = k;
  return leading;
}

}  // namespace creepcontact::study
