#include "sudden_loss.hpp"

#include <algorithm>
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
  const auto after = std::ranges::lower_bound(entries_, time, {}, &Entry::time);
  if (after == entries_.begin()) return after->force;
  const Entry &from = *std::prev(after), &to = *after;
  return from.force + (to.force - from.force) * (time - from.time) / (to.time - from.time);
}

std::optional<SuddenLoss::Loss> SuddenLoss::observe(double time, double force) {
  const bool was_lost = entries_.empty() || entries_.back().force <= nothing * largest_;
  if (!entries_.empty() && entries_.back().time == time)
    entries_.back().force = force;
  else
    entries_.push_back({time, force});
  largest_ = std::max(largest_, force);
  const double begin = time - 2 * window_;
  while (entries_.size() > 1 && entries_[1].time <= begin) entries_.pop_front();
  if (was_lost || force > nothing * largest_ || entries_.front().time > begin) return std::nullopt;
  if (const auto change = std::ranges::lower_bound(load_changes_, begin);
      change != load_changes_.end() && *change <= time)
    return std::nullopt;
  const double before = force_at(time - window_);
  if (before < notable * largest_ || force_at(begin) - before > slow * before) return std::nullopt;
  const auto last = std::ranges::find_if(entries_.rbegin(), entries_.rend(),
                                         [&](const Entry& entry) { return entry.force >= before / 2; });
  return Loss{time, before, before / largest_, last->time};
}

void SuddenLoss::save(const std::string& name, Memory& memory) const {
  std::vector<double> numbers{largest_};
  for (const Entry& entry : entries_) numbers.insert(numbers.end(), {entry.time, entry.force});
  memory[name] = std::move(numbers);
}

void SuddenLoss::restore(const std::string& name, const Memory& memory) {
  const auto found = memory.find(name);
  if (found == memory.end() || found->second.empty()) return;
  const std::vector<double>& numbers = found->second;
  largest_ = numbers[0];
  entries_.clear();
  for (std::size_t i = 1; i + 1 < numbers.size(); i += 2) entries_.push_back({numbers[i], numbers[i + 1]});
}

}  // namespace creepcontact::run
