#include "creepcontact/model/step_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace creepcontact::model {

StepLimits::StepLimits(const std::vector<StepLimit>& limits) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (limits.empty()) return;
  std::vector<std::pair<double, double>> begins, ends;  // time, step
  for (const StepLimit& limit : limits) {
    begins.emplace_back(limit.begin, limit.step);
    ends.emplace_back(limit.end, limit.step);
  }
  std::ranges::sort(begins);
  std::ranges::sort(ends);
  std::multiset<double> active;
  begins_.push_back(-never);
  steps_.push_back(never);
  for (std::size_t b = 0, e = 0; e < ends.size();) {
    const double t = b < begins.size() ? std::min(begins[b].first, ends[e].first) : ends[e].first;
    for (; b < begins.size() && begins[b].first <= t; ++b) active.insert(begins[b].second);
    for (; e < ends.size() && ends[e].first <= t; ++e) active.erase(active.find(ends[e].second));
    if (!active.empty() || steps_.back() < never) {
      if (steps_.back() < never) n_steps_ += (t - begins_.back()) / steps_.back();
      begins_.push_back(t);
      steps_.push_back(active.empty() ? never : *active.begin());
    }
  }
  ahead_.assign(begins_.size(), never);
  double earliest = never;
  auto next = begins.rbegin();
  for (std::size_t i = begins_.size(); i-- > 0;) {
    const double piece_end = i + 1 < begins_.size() ? begins_[i + 1] : never;
    for (; next != begins.rend() && next->first >= piece_end; ++next)
      earliest = std::min(earliest, next->first + next->second);
    ahead_[i] = earliest;
  }
}

double StepLimits::latest_end(double t) const {
  if (begins_.empty()) return std::numeric_limits<double>::infinity();
  const auto piece = static_cast<std::size_t>(std::ranges::upper_bound(begins_, t) - begins_.begin()) - 1;
  return std::min(t + steps_[piece], ahead_[piece]);
}

}  // namespace creepcontact::model
