#include "extrema.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace creepcontact::model {
namespace {

constexpr std::size_t n_blocks = 64, first_samples = 128;  // per block
constexpr double rounding_of_constants = 1e-12;            // of the values
constexpr double min_turn = 0.01;                          // of the range of the values
constexpr std::size_t least_gap = 6, denser = 2;           // samples between turns; refinement
constexpr int finest_window = 6;                           // each eight times as close as the one before
constexpr std::size_t window_samples = 17, many_in_window = 3;
constexpr double rise_low = 0.2, rise_high = 0.8;  // of the way from a turn to the next
constexpr double steps_per_rise = 2.5;             // a sine then has 12 per period
constexpr double rise_of_gap = 0.41;               // of a sine
constexpr double sudden = 1e-6;                    // a rise shorter than this part of the distance is a jump
constexpr double outstanding = 5, smallest_jump = 0.01;
constexpr std::size_t most_suspects = 2000;
constexpr double seen = 32;  // samples per turn that show a kink between two of them
constexpr std::size_t few_turns = 10;

struct Samples {
  std::vector<double> t, v;
};

/// Indices of the samples at which the values turn back by more than `turn`.
std::vector<std::size_t> turns_of(const std::vector<double>& values, double turn) {
  std::vector<std::size_t> found;
  int direction = 0;        // +1 rising, -1 falling, 0 not known yet
  std::size_t extreme = 0;  // the highest point of a rise, the lowest of a fall
  std::size_t lowest = 0, highest = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (direction == 0) {
      if (values[i] < values[lowest]) lowest = i;
      if (values[i] > values[highest]) highest = i;
      if (!(values[highest] - values[lowest] > turn)) continue;
      direction = highest > lowest ? 1 : -1;
      extreme = i;
      continue;
    }
    const double change = values[i] - values[extreme];
    if (direction * change > 0) {
      extreme = i;
    } else if (std::abs(change) > turn) {
      found.push_back(extreme);
      direction = -direction;
      extreme = i;
    }
  }
  return found;
}

/// The part of the run that one block of samples covers.
struct Block {
  double begin, end;
  std::size_t n = first_samples;
  std::optional<double> gap = {};  ///< between turns, of a block that cannot be resolved
};

class TurnSearch {
 public:
  TurnSearch(const Course& course, Interval over, double evaluations, int samples)
      : course_(course), over_(over), evaluations_(evaluations), dense_gap_(seen * (over.high - over.low) / samples) {}

  Extrema run() {
    const double width = (over_.high - over_.low) / n_blocks;
    for (std::size_t k = 0; k < n_blocks; ++k) {
      blocks_.push_back({over_.low + width * static_cast<double>(k), over_.low + width * static_cast<double>(k + 1)});
      samples_.push_back(sampled(k));
    }
    for (Block& block : blocks_) refine(block);
    // What is constant but for rounding, as an interpolated temperature, does not turn.
    if (!(high_ - low_ > rounding_of_constants * std::max(std::abs(high_), std::abs(low_)))) return {};
    for (std::size_t k = 0; k < n_blocks; ++k) resolve(k);
    return found();
  }

 private:
  double turn() const { return min_turn * (high_ - low_); }

  double value(double t) {
    ++n_evaluations_;
    const double v = course_(t);
    if (!std::isfinite(v)) return std::isfinite(low_) ? std::clamp(0.0, low_, high_) : 0.0;
    if (v < low_) {
      low_ = v;
      lowest_ = t;
    }
    if (v > high_) {
      high_ = v;
      highest_ = t;
    }
    return v;
  }

  /// Shifted from block to block, so that no period divides all distances.
  Samples sampled(std::size_t k) {
    const Block& block = blocks_[k];
    const double step = (block.end - block.begin) / static_cast<double>(block.n);
    const double shift = std::fmod(static_cast<double>(k) * std::numbers::phi, 1.0);
    Samples result;
    for (std::size_t i = 0; i < block.n; ++i) {
      result.t.push_back(block.begin + step * (static_cast<double>(i) + shift));
      result.v.push_back(value(result.t.back()));
    }
    return result;
  }

  /// Windows of close samples: vibrations that the samples do not resolve.
  void refine(Block& block) {
    double step = (block.end - block.begin) / static_cast<double>(block.n);
    for (int level = 1; level <= finest_window; ++level) {
      step /= 8;
      const double share = std::fmod(0.37 + level * std::numbers::phi, 1.0);
      const double begin = block.begin + 0.8 * share * (block.end - block.begin);
      std::vector<double> values;
      for (std::size_t i = 0; i < window_samples; ++i) values.push_back(value(begin + step * static_cast<double>(i)));
      const std::size_t n = turns_of(values, turn()).size();
      if (n < many_in_window) continue;
      const double gap = step * window_samples / static_cast<double>(n);
      block.gap = gap;
    }
    if (!block.gap) return;
    const double needed = (block.end - block.begin) / *block.gap * static_cast<double>(least_gap + 2);
    if (needed * n_blocks > evaluations_) return;  // not to be resolved
    block.n = std::max(block.n, static_cast<std::size_t>(needed));
    block.gap.reset();
  }

  void resolve(std::size_t k) {
    Block& block = blocks_[k];
    if (block.gap) return;
    if (block.n > samples_[k].t.size()) samples_[k] = sampled(k);
    for (;;) {
      const std::vector<std::size_t> turns = turns_of(samples_[k].v, turn());
      // Two turns close together may be a jump; three are a vibration.
      std::size_t closest = 2 * least_gap;
      for (std::size_t i = 2; i < turns.size(); ++i) closest = std::min(closest, turns[i] - turns[i - 2]);
      if (closest >= 2 * least_gap) return;
      if (n_evaluations_ + static_cast<double>(denser * block.n) > evaluations_) {
        block.gap = (block.end - block.begin) / static_cast<double>(turns.size());
        return;
      }
      block.n *= denser;
      samples_[k] = sampled(k);
    }
  }

  Extrema found() {
    Extrema result;
    for (std::size_t k = 0; k < n_blocks; ++k) {
      if (!blocks_[k].gap) {
        all_.t.insert(all_.t.end(), samples_[k].t.begin(), samples_[k].t.end());
        all_.v.insert(all_.v.end(), samples_[k].v.begin(), samples_[k].v.end());
        continue;
      }
      const double gap = *blocks_[k].gap;
      result.count += (blocks_[k].end - blocks_[k].begin) / gap;
      result.limits.push_back({blocks_[k].begin, blocks_[k].end, rise_of_gap / steps_per_rise * gap});
      add_dense({blocks_[k].begin, blocks_[k].end}, result.dense);
    }
    if (all_.t.empty()) {
      add_highest_and_lowest(result);
      return result;
    }
    const std::vector<std::size_t> turns = turns_of(all_.v, turn());
    result.count += static_cast<double>(turns.size());
    if (result.count <= static_cast<double>(most_turns)) {
      for (const std::size_t i : turns) result.turns.push_back(sharpened(i));
    } else {
      add_highest_and_lowest(result);
      add_jumps(result);
    }
    std::vector<std::size_t> nodes{0};
    nodes.insert(nodes.end(), turns.begin(), turns.end());
    nodes.push_back(all_.t.size() - 1);
    for (std::size_t i = 1; i < nodes.size(); ++i) add_limit(nodes[i - 1], nodes[i], result.limits);
    for (std::size_t first = 1, i = 1; i + 1 < nodes.size(); ++i) {  // stretches of turns that are close
      if (i + 2 < nodes.size() && all_.t[nodes[i + 1]] - all_.t[nodes[i]] < dense_gap_) continue;
      if (i >= first + few_turns) add_dense({all_.t[nodes[first]], all_.t[nodes[i]]}, result.dense);
      first = i + 1;
    }
    std::ranges::sort(result.dense, {}, &Interval::low);
    return result;
  }

  void add_highest_and_lowest(Extrema& to) const {
    const double gap = (over_.high - over_.low) / to.count;
    for (const double t : {std::min(lowest_, highest_), std::max(lowest_, highest_)})
      to.turns.push_back({t, 0.1 * gap});
  }

  static void add_dense(Interval stretch, std::vector<Interval>& to) {
    if (!to.empty() && stretch.low <= to.back().high * (1 + 1e-9))
      to.back().high = std::max(to.back().high, stretch.high);
    else
      to.push_back(stretch);
  }

  /// The turn at sample i, located by golden-section search between the neighbouring samples.
  Turn sharpened(std::size_t i) {
    const double before = i > 0 ? all_.t[i - 1] : over_.low;
    const double after = i + 1 < all_.t.size() ? all_.t[i + 1] : over_.high;
    const double error = std::max(all_.t[i] - before, after - all_.t[i]);
    const double sign = i > 0 && all_.v[i] < all_.v[i - 1] ? -1 : 1;
    constexpr double golden = std::numbers::phi - 1;
    double low = before, high = after;
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double at_left = sign * value(left), at_right = sign * value(right);
    for (int section = 0; section < 30; ++section) {
      if (at_left >= at_right) {
        high = right;
        right = left;
        at_right = at_left;
        left = high - golden * (high - low);
        at_left = sign * value(left);
      } else {
        low = left;
        left = right;
        at_left = at_right;
        right = low + golden * (high - low);
        at_right = sign * value(right);
      }
    }
    return {rounded(0.5 * (low + high), 1e-3 * error), error};
  }

  /// Where the values pass a level between two samples of which one lies below and one above it.
  double crossing(double level, std::size_t from, std::size_t to) {
    const bool rises = all_.v[to] > all_.v[from];
    std::size_t i = from + 1;
    while (i < to && (rises ? all_.v[i] < level : all_.v[i] > level)) ++i;
    double low = all_.t[i - 1], high = all_.t[i];
    for (int halving = 0; halving < 4; ++halving) {
      const double middle = 0.5 * (low + high), v = value(middle);
      ((rises ? v < level : v > level) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  void add_limit(std::size_t from, std::size_t to, std::vector<StepLimit>& limits) {
    const double change = all_.v[to] - all_.v[from], gap = all_.t[to] - all_.t[from];
    if (!(std::abs(change) > turn()) || !(gap > 0)) return;
    const double first = crossing(all_.v[from] + rise_low * change, from, to);
    const double last = crossing(all_.v[from] + rise_high * change, from, to);
    const double rise = last - first;
    // A jump, or the end of a block that could not be resolved.
    if (!(rise > sudden * gap) || is_sudden(first, last, change)) return;
    const StepLimit limit{std::max(all_.t[from], first - rise), std::min(all_.t[to], last + rise),
                          rise / steps_per_rise};
    // Equal steps integrate a vibration more exactly than steps that change: the errors of its periods cancel.
    constexpr double alike = 0.6;
    const bool joins = !limits.empty() && limits.back().end >= limit.begin;
    const double least = joins ? std::min(limits.back().step, limit.step) : 0;
    if (joins && least > alike * std::max(limits.back().step, limit.step)) {
      limits.back().end = limit.end;
      limits.back().step = least;
    } else {
      limits.push_back(limit);
    }
  }

  /// Most of the change happens in one thousandth of the rise seen by the samples.
  bool is_sudden(double first, double last, double change) {
    const double rise = last - first;
    double low = first, high = last, at_low = value(first), at_high = value(last);
    for (int halving = 0; halving < 10; ++halving) {
      const double middle = 0.5 * (low + high), v = value(middle);
      if (std::abs(v - at_low) < std::abs(at_high - v)) {
        low = middle;
        at_low = v;
      } else {
        high = middle;
        at_high = v;
      }
    }
    return high - low < 1e-2 * rise && std::abs(at_high - at_low) > 0.3 * std::abs(change);
  }

  /// Adds the jumps: changes between two samples that are much larger than the neighbouring ones.
  void add_jumps(Extrema& to) {
    const std::vector<double>&t = all_.t, &v = all_.v;
    constexpr std::size_t beside = 4;
    std::size_t n_suspects = 0;
    for (std::size_t i = beside; i + beside + 1 < v.size() && n_suspects < most_suspects; ++i) {
      const double here = std::abs(v[i + 1] - v[i]);
      if (!(here > smallest_jump * (high_ - low_))) continue;
      double largest = 0;
      for (std::size_t k = 1; k <= beside; ++k)
        largest = std::max({largest, std::abs(v[i + 1 + k] - v[i + k]), std::abs(v[i + 1 - k] - v[i - k])});
      if (!(here > outstanding * largest) && !(here > 1.7 * largest && here > 0.2 * (high_ - low_))) continue;
      ++n_suspects;
      if (const auto jump = jump_between(course_, t[i], t[i + 1])) to.jumps.push_back(*jump);
    }
  }

  const Course& course_;
  Interval over_;
  double evaluations_, dense_gap_, n_evaluations_ = 0;
  double low_ = HUGE_VAL, high_ = -HUGE_VAL;  // of all values ...
  double lowest_ = 0, highest_ = 0;           // ... and their times
  std::vector<Block> blocks_;
  std::vector<Samples> samples_;  // of each block
  Samples all_;
};

}  // namespace

Extrema find_extrema(const Course& course, Interval over, double evaluations, int samples) {
  return TurnSearch(course, over, evaluations, samples).run();
}

}  // namespace creepcontact::model
