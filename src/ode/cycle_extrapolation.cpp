#include "creepcontact/ode/cycle_extrapolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "error_norm.hpp"

namespace creepcontact::ode {
namespace {

constexpr std::int64_t cycles_before_jumps = 3;  // the first may differ from all others
constexpr std::array<double, 4> change_powers{0, 0.5, 1, 1.25};
constexpr double change_of_prediction = 0.8;  // another one must have this share of the error of the present one
constexpr std::int64_t longest_pause = 64;
constexpr double jump_safety = 0.8, largest_jump_growth = 2, smallest_jump_cut = 0.5, largest_jump_cut = 0.2;

/// Integrals over [a, b] of s^-power and of s^-power log(s/unit).
std::array<double, 2> power_integrals(double a, double b, double unit, double power) {
  const double q = 1 - power, u = std::log(a / unit), v = std::log(b / unit);
  if (q == 0) return {v - u, (v * v - u * u) / 2};
  const double A = std::pow(a, q), B = std::pow(b, q);
  return {(B - A) / q, (B * v - A * u) / q - (B - A) / (q * q)};
}

}  // namespace

/// Factors of the last two changes, from which the jump and the change of the cycle after it are predicted.
struct CycleExtrapolation::Weights {
  double jump_new, jump_old;      // the jump
  double change_new, change_old;  // the change of the cycle after it
  double correction;              // of the jump, per difference of that change
};

/// Changes of the cycle after the jump and of the two before it, damped.
struct CycleExtrapolation::Damped {
  std::vector<double> found, newer, older;
};

class CycleExtrapolation::Norm : public ErrorNorm {
 public:
  using ErrorNorm::ErrorNorm;
};

CycleExtrapolation::CycleExtrapolation(const Team& team, double tolerance)
    : norm_(std::make_unique<Norm>(team, tolerance)) {}

CycleExtrapolation::~CycleExtrapolation() = default;

void CycleExtrapolation::begin(std::int64_t cycle) {
  begin_ = cycle;
  seen_ = jumped_ = 0;
  next_ = 1;
  pause_ = 1;
  wait_ = 0;
  order_ = 2;
  power_ = 0;
}

void CycleExtrapolation::keep(std::vector<double> change, double place) {
  old_change_ = std::move(new_change_);
  old_place_ = new_place_;
  new_change_ = std::move(change);
  new_place_ = place;
}

void CycleExtrapolation::add_cycle(std::int64_t cycle, std::span<const double> before, std::span<const double> after) {
  std::vector<double> change(after.size());
  for_each_index(change.size(), [&](std::size_t i) { change[i] = after[i] - before[i]; });
  last_ = cycle;
  keep(std::move(change), middle(cycle));
  ++seen_;
  if (--wait_ <= 0) next_ = std::max(next_, 1.0);
}

std::int64_t CycleExtrapolation::proposal() const {
  return seen_ < cycles_before_jumps ? 0 : static_cast<std::int64_t>(std::floor(next_));
}

CycleExtrapolation::Weights CycleExtrapolation::weights(int order, double power) const {
  const double begin = middle(last_) + 0.5, end = begin + static_cast<double>(jumped_), place = end + 0.5;
  const auto [plain, logarithmic] = power_integrals(begin, end, new_place_, power);
  const double newer = std::pow(new_place_, power), older = std::pow(old_place_, power);
  const double slope = order > 1 ? 1 / std::log(new_place_ / old_place_) : 0;  // per difference of the two
  const double distance = std::log(place / new_place_), at_place = std::pow(place, power);
  return {.jump_new = newer * (plain + slope * logarithmic),
          .jump_old = -older * slope * logarithmic,
          .change_new = newer * (1 + slope * distance) / at_place,
          .change_old = -older * slope * distance / at_place,
          .correction = at_place * logarithmic / distance};
}

void CycleExtrapolation::jump(std::int64_t n, std::span<double> y) {
  if (n < 1 || seen_ < 2 || is_checking()) throw std::logic_error("a jump needs two cycles before it");
  jumped_ = n;
  before_.assign(y.begin(), y.end());
  const Weights w = weights(order_, power_);
  for_each_index(y.size(), [&](std::size_t i) { y[i] += w.jump_new * new_change_[i] + w.jump_old * old_change_[i]; });
  predicted_.assign(y.begin(), y.end());
}

double CycleExtrapolation::error_of(const Weights& w, const Damped& damped) const {
  return (*norm_)([&](std::size_t begin, std::size_t n) {
    return w.correction * (piece(damped.found.data(), begin, n) - w.change_new * piece(damped.newer.data(), begin, n) -
                           w.change_old * piece(damped.older.data(), begin, n));
  });
}

bool CycleExtrapolation::check(std::span<const double> scale, const Damping& damping, std::span<double> y) {
  const Weights w = weights(order_, power_);
  std::vector<double> change(y.size());
  for_each_index(y.size(), [&](std::size_t i) { change[i] = y[i] - predicted_[i]; });
  Damped damped{change, new_change_, old_change_};
  if (damping) {
    damping(w.correction, change, damped.found);
    damping(w.correction, new_change_, damped.newer);
    damping(w.correction, old_change_, damped.older);
  }
  norm_->set_scale(scale);
  error_ = error_of(w, damped);
  const auto n = static_cast<double>(jumped_);
  const double factor = jump_safety / std::cbrt(std::max(error_, 1e-6));
  if (!(error_ <= 1)) {  // also if the error is not a number
    if (order_ > 1 && error_of(weights(1, power_), damped) < error_) order_ = 1;
    give_up(y);
    next_ = n * (error_ < 1e9 ? std::clamp(factor, largest_jump_cut, smallest_jump_cut) : largest_jump_cut);
    if (next_ < 1) {
      wait_ = pause_;
      pause_ = std::min(2 * pause_, longest_pause);
    }
    return false;
  }
  for_each_index(y.size(), [&](std::size_t i) {
    const double difference = damped.found[i] - w.change_new * damped.newer[i] - w.change_old * damped.older[i];
    change[i] = w.change_new * new_change_[i] + w.change_old * old_change_[i] + difference;
    y[i] = predicted_[i] + w.correction * difference + change[i];
  });
  choose_prediction(damped);
  last_ += jumped_ + 1;
  ++seen_;
  jumped_ = 0;
  keep(std::move(change), middle(last_));
  next_ = std::max(1.0, n * std::min(factor, largest_jump_growth));
  pause_ = n > 1 ? 1 : std::max<std::int64_t>(pause_ / 2, 1);
  return true;
}

void CycleExtrapolation::choose_prediction(const Damped& damped) {
  const int present_order = order_;
  const double present_power = power_;
  double least = std::numeric_limits<double>::infinity();
  for (const int order : {2, 1})
    for (const double power : change_powers) {
      const bool is_present = order == present_order && power == present_power;
      const double error = error_of(weights(order, power), damped) * (is_present ? change_of_prediction : 1);
      if (!(error < least)) continue;
      least = error;
      order_ = order;
      power_ = power;
    }
}

void CycleExtrapolation::give_up(std::span<double> y) {
  std::ranges::copy(before_, y.begin());
  next_ = smallest_jump_cut * static_cast<double>(jumped_);
  jumped_ = 0;
}

void CycleExtrapolation::save(Memory& numbers, Memory& states) const {
  numbers.save("extrapolation", *this, saved_members);
  if (seen_ > 0) states["new_change"] = new_change_;
  if (seen_ > 1) states["old_change"] = old_change_;
}

void CycleExtrapolation::restore(const Memory& numbers, const Memory& states) {
  numbers.restore("extrapolation", *this, saved_members);
  if (seen_ > 0) new_change_ = states.at("new_change");
  if (seen_ > 1) old_change_ = states.at("old_change");
  jumped_ = 0;
}

}  // namespace creepcontact::ode
