#pragma once
/// Extrapolation of a state over many similar cycles of its loads, each jump checked by a cycle computed in full.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "creepcontact/base/memory.hpp"
#include "creepcontact/base/team.hpp"

namespace creepcontact::ode {

/// The change per cycle G is taken as a smooth function of the number of cycles s: (s^power G) is constant (order 1) or
/// linear in log s (order 2) from the last cycles computed on. power 0 suits a change that stays the same, 1 to 1.25
/// stress that relaxes; of powers and orders those go on that would have predicted the last cycle best. A jump adds the
/// integral of the extrapolated G. The cycle after it gives the G that is there, and the integral of the interpolation
/// through it corrects the jump; the correction is the estimate of its error. That is a linearly implicit
/// Adams-Bashforth-Moulton step in the number of cycles: the difference of both G is damped by the point-wise Jacobian
/// (LogAdams does so in time), so that modes which relax within few cycles do not bound the jumps.
/// Where a jump over a single cycle fails, the next one is tried after a pause, twice as long each time and half as
/// long again after a jump that succeeds: cycles that cannot be extrapolated cost little more than without jumps.
/// Sources: C. W. Gear, I. G. Kevrekidis, SIAM J. Sci. Comput. 24 (2003), projective integration; D. Cojocaru, A. M.
/// Karlsson, Int. J. Fatigue 28 (2006), cycle jumps under error control.
/// Cycles are numbered from 0. Memory: four vectors, and five more during a check. Calls are collective.
class CycleExtrapolation {
 public:
  /// damped = (I - weight J)^-1 change, with J the Jacobian of the change per cycle or its point-wise part; an estimate
  /// is enough. @param damped  of the same size, overwritten
  using Damping = std::function<void(double weight, std::span<const double> change, std::span<double> damped)>;

  /// @param team  must outlive the object
  /// @param tolerance  error of a jump, relative to System::scale() @throws ConfigError if it is not positive
  CycleExtrapolation(const Team& team, double tolerance);
  ~CycleExtrapolation();

  /// Forgets all cycles: other loads begin with this one.
  void begin(std::int64_t cycle);
  /// A cycle that was computed in full without a jump before it. @param before, after  the states at its ends
  void add_cycle(std::int64_t cycle, std::span<const double> before, std::span<const double> after);
  /// How many cycles the next jump may pass over; 0: the next cycle is to be computed.
  std::int64_t proposal() const;

  /// Replaces the state after the last cycle by the one `n` cycles later. @param n  at least 1
  /// @throws std::logic_error before two cycles have been seen, or while checking
  void jump(std::int64_t n, std::span<double> y);
  /// True from a jump to the end of the cycle after it.
  bool is_checking() const { return jumped_ > 0; }
  /// Number of cycles of the jump that is being checked.
  std::int64_t jumped() const { return jumped_; }
  /// Ends the cycle after a jump.
  /// @param scale  System::scale() @param y  the state computed for its end
  /// @returns true if the jump is accepted: y is then corrected; false: y is the state before the jump
  bool check(std::span<const double> scale, const Damping& damping, std::span<double> y);
  /// Gives up the jump, for another reason than its error. @param y  set to the state before it
  void give_up(std::span<double> y);
  /// Error of the last jump checked, relative to what is allowed.
  double error() const { return error_; }

  using Memory = creepcontact::Memory;
  /// Not while checking. @param numbers, states  as in RestartPoint
  void save(Memory& numbers, Memory& states) const;
  /// @throws std::out_of_range if an entry is missing
  void restore(const Memory& numbers, const Memory& states);

 private:
  struct Weights;
  struct Damped;
  class Norm;
  Weights weights(int order, double power) const;
  /// Error of the correction, relative to what is allowed.
  double error_of(const Weights& weights, const Damped& damped) const;
  /// The place of the change of a cycle: its middle.
  double middle(std::int64_t cycle) const { return static_cast<double>(cycle - begin_) + 0.5; }
  void choose_prediction(const Damped& damped);
  void keep(std::vector<double> change, double place);

  std::unique_ptr<Norm> norm_;
  std::int64_t begin_ = 0;  // first cycle of these loads
  std::int64_t last_ = -1;  // last cycle computed
  std::int64_t seen_ = 0;   // since begin()
  std::int64_t jumped_ = 0;
  double next_ = 1;                    // length of the next jump
  std::int64_t pause_ = 1, wait_ = 0;  // cycles to compute after a jump of one that fails
  int order_ = 2;
  double power_ = 0, error_ = 0;
  double new_place_ = 0, old_place_ = 0;         // of the last two changes
  std::vector<double> new_change_, old_change_;  // damped as the jumps to them were corrected
  std::vector<double> before_, predicted_;       // of the jump that is checked
  static constexpr auto saved_members = std::tuple{
      Member{"begin", &CycleExtrapolation::begin_},         Member{"last", &CycleExtrapolation::last_},
      Member{"seen", &CycleExtrapolation::seen_},           Member{"next", &CycleExtrapolation::next_},
      Member{"order", &CycleExtrapolation::order_},         Member{"power", &CycleExtrapolation::power_},
      Member{"new_place", &CycleExtrapolation::new_place_}, Member{"old_place", &CycleExtrapolation::old_place_},
      Member{"pause", &CycleExtrapolation::pause_},         Member{"wait", &CycleExtrapolation::wait_}};
};

}  // namespace creepcontact::ode
