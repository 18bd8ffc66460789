#include "sudden_loss.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace creepcontact::run {
namespace {

constexpr double heating_times = 100;             // in a window: the joint leaves its state slowly at first
constexpr double nothing = 1e-9, notable = 0.01;  // of the largest force
constexpr double slow = 0.25;  // change within the window before, of the force that is lost in the last one

}  // namespace

SuddenLoss::SuddenLoss(double heating_time, std::vector<double> load_changes)
    : window_(heating_times * heating_time), load_changes_(std::move(load_changes)) {}

double SuddenLoss::force_at(double time) const {
  const auto after = std::ranges::lower_bound(past_.entries, time, {}, &Past::Entry::time);
  if (after == past_.entries.begin()) return after->force;
  const Past::Entry &from = *std::prev(after), &to = *after;
  return from.force + (to.force - from.force) * (time - from.time) / (to.time - from.time);
}

std::optional<SuddenLoss::Loss> SuddenLoss::observe(double time, double force) {
  auto& [entries, largest] = past_;
  const bool was_lost = entries.empty() || entries.back().force <= nothing * largest;
  if (!entries.empty() && entries.back().time == time)
    entries.back().force = force;
  else
    entries.push_back({time, force});
  largest = std::max(largest, force);
  const double begin = time - 2 * window_;
  const auto needed = std::ranges::upper_bound(entries, begin, {}, &Past::Entry::time);  // with the one before
  if (needed - entries.begin() > 1) entries.erase(entries.begin(), needed - 1);
  if (was_lost || force > nothing * largest || entries.front().time > begin) return std::nullopt;
  if (const auto change = std::ranges::lower_bound(load_changes_, begin);
      change != load_changes_.end() && *change <= time)
    return std::nullopt;
  const double before = force_at(time - window_);
  if (before < notable * largest || force_at(begin) - before > slow * before) return std::nullopt;
  const auto last = std::ranges::find_if(entries.rbegin(), entries.rend(),
                                         [&](const Past::Entry& entry) { return entry.force >= before / 2; });
  return Loss{time, before, before / largest, last->time};
}

}  // namespace creepcontact::run
