#pragma once
/// What the runs of a study with random keys tell together: quantiles, probabilities, and which key decides.

#include <array>
#include <string>
#include <vector>

#include "creepcontact/config/study.hpp"
#include "creepcontact/statistics/estimates.hpp"
#include "creepcontact/statistics/variance_shares.hpp"
#include "histories.hpp"
#include "study_results.hpp"

namespace creepcontact::study {

/// A quantile and its bounds; NaN: the sample is too small to bound it.
struct QuantileEstimate {
  double value = ProbeCourse::unknown, low = ProbeCourse::unknown, high = ProbeCourse::unknown;
};

/// What a fan chart shows at a time: quantiles of 5, 25, 50, 75 and 95 %.
using Fan = std::array<double, 5>;
inline constexpr Fan fan_probabilities{0.05, 0.25, 0.5, 0.75, 0.95};

/// Quantiles of a probe over time.
struct QuantileCourse {
  std::vector<std::vector<QuantileEstimate>> at;  ///< [time][quantile]
  std::vector<std::size_t> samples;               ///< runs with a value, per time
  std::vector<Fan> fan;                           ///< per time with values
};

/// A number that each run has, such as a probe at the end.
struct RunResult {
  std::string name;            ///< "stress_end", "event_leak"
  std::vector<double> values;  ///< per sample; NaN: none; an event that did not happen: infinity
};

/// Something that happens in some runs.
struct Happening {
  std::string name;           ///< of the event, "rupture", or "not_met_<criterion>"
  bool is_at_end = false;     ///< a criterion, known at the end alone
  std::vector<double> times;  ///< per counted run, in ascending order; infinity: does not happen
};

/// The samples of one combination of the axes.
struct ScatterGroup {
  std::size_t first_run = 0;  ///< its settings are those of all
  std::string label;          ///< empty if there is one group
  std::size_t planned = 0, succeeded = 0, ruptured = 0, failed = 0, missing = 0;
  std::vector<std::size_t> runs;  ///< indices of all, by sample
  std::vector<double> times;      ///< that all whole runs have
  std::vector<QuantileCourse> probes;
  std::vector<RunResult> results;
  std::vector<Happening> happenings;
  std::vector<std::vector<double>> rank_correlations;  ///< [result][key]
  std::vector<statistics::VarianceShares> shares;      ///< [result]; empty if keys are correlated
};

struct Scatter {
  std::vector<double> quantiles;
  std::vector<std::string> probes, keys;
  std::vector<ScatterGroup> groups;
  std::vector<double> scores;  ///< of the samples, as config::scores_of()
  bool is_correlated = false, is_thinned = false;
};

/// Cost: for 100 000 runs some seconds.
Scatter scatter_of(const config::Study& study, const std::vector<config::PlannedRun>& runs,
                   const std::vector<StudyRow>& rows, const Histories& histories);

/// The values that are known, in ascending order, and a quantile of them with its bounds.
std::vector<double> sorted_known(std::vector<double> values);
QuantileEstimate quantile_estimate(const std::vector<double>& sorted, double probability);

/// "05" for 0.05, "97_5" for 0.975: the end of a name of a column.
std::string percent_name(double probability);

/// The share of the runs in which it has happened by a time.
statistics::Proportion probability_at(const Happening& one, double time);

/// Index of the result "<probe>_end".
std::size_t end_of_probe(std::size_t probe);
/// The key with the largest rank correlation with a result; the number of keys: none has one.
std::size_t leading_key(const ScatterGroup& group, std::size_t result);

}  // namespace creepcontact::study
