#include "histories.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace creepcontact::study {
namespace {

constexpr double same_time = 1e-9;  // relative: files may have fewer digits

/// Position of a time in an ascending list; its size: it is not there.
std::size_t position_of(const std::vector<double>& times, double time) {
  const double tolerance = same_time * std::abs(time);
  const auto found = std::ranges::lower_bound(times, time - tolerance);
  const bool is_there = found != times.end() && *found <= time + tolerance;
  return is_there ? static_cast<std::size_t>(found - times.begin()) : times.size();
}

}  // namespace

Histories::Histories(std::vector<std::string> probes, std::size_t runs, std::size_t most)
    : probes_(std::move(probes)), n_runs_(runs), most_(most), runs_(runs) {}

void Histories::take(std::size_t run, const io::CsvTable& history, bool is_whole) {
  const std::vector<double>* const times = history.column("time");
  const std::size_t rows = history.rows() - (is_whole || history.rows() == 0 ? 0 : 1);
  if (times == nullptr || rows == 0) return;
  if (stride_ == 0) stride_ = std::max<std::size_t>(1, rows * probes_.size() * n_runs_ / most_ + 1);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rows; ++i)
    if (i % stride_ == 0 || (is_whole && i + 1 == rows)) kept.push_back(i);
  std::vector<double> kept_times;
  kept_times.reserve(kept.size());
  for (const std::size_t i : kept) kept_times.push_back((*times)[i]);
  Run& one = runs_[run];
  one.is_whole = is_whole;
  one.times = times_of(std::move(kept_times));
  for (const std::string& probe : probes_) {
    const std::vector<double>* const column = history.column(probe);
    for (const std::size_t i : kept)
      one.values.push_back(column != nullptr ? (*column)[i] : std::numeric_limits<double>::quiet_NaN());
  }
}

std::size_t Histories::times_of(std::vector<double> times) {
  const auto [found, is_new] = known_times_.try_emplace(times, times_.size());
  if (is_new) times_.push_back(std::move(times));
  return found->second;
}

std::vector<double> Histories::common_times(const std::vector<std::size_t>& runs) const {
  std::set<std::size_t> lists;
  for (const std::size_t run : runs)
    if (runs_[run].is_whole) lists.insert(runs_[run].times);
  if (lists.empty()) return {};
  std::vector<double> common = times_[*lists.begin()];
  for (const std::size_t list : lists)
    std::erase_if(common, [&](double time) { return position_of(times_[list], time) == times_[list].size(); });
  return common;
}

std::vector<double> Histories::at(const std::vector<std::size_t>& runs, std::size_t probe, double time) const {
  std::map<std::size_t, std::size_t> positions;  // by list of times
  std::vector<double> values;
  values.reserve(runs.size());
  for (const std::size_t run : runs) {
    const Run& one = runs_[run];
    if (one.times == none) {
      values.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const std::vector<double>& times = times_[one.times];
    const auto [found, is_new] = positions.try_emplace(one.times);
    if (is_new) found->second = position_of(times, time);
    values.push_back(found->second < times.size() ? one.values[probe * times.size() + found->second]
                                                  : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

}  // namespace creepcontact::study
