#pragma once
/// What happens in one cycle of the loads.

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/run/step_view.hpp"

namespace creepcontact::run {

/// Results of one cycle.
struct CycleRecord {
  struct Probe {
    double min = std::numeric_limits<double>::infinity(), max = -std::numeric_limits<double>::infinity(), end = 0;
    double range() const { return max - min; }
  };
  /// A fraction of life.
  struct Life {
    double largest = 0;    ///< over the points, at the end
    double per_cycle = 0;  ///< largest increase in the cycle
  };
  struct Body {
    double inelastic_strain_range = 0;  ///< largest over the points
    double strain_range = 0;            ///< likewise, of elastic and inelastic strain together
    std::vector<Life> life;             ///< of the variables of CycleWatch::life_of()
    /// Whole cycles since t = 0 after which the last of these variables is 1 at some point, if all later cycles are
    /// like this one; infinity: never.
    double limit = std::numeric_limits<double>::infinity();
  };
  std::vector<Body> bodies;
  std::vector<Probe> probes;
  /// Largest change of the stress from the begin to the end, relative to the typical stress of its body.
  double stress_change = 0;
};

/// Observes the states at the breakpoints of a cycle, where piecewise smooth loads have their extremes, and takes
/// ranges between all of them. Calls are collective. Cost: an evaluation for each state, unless a step has made it;
/// memory: six numbers per point and breakpoint, and for bodies that creep or yield twelve.
class CycleWatch {
 public:
  /// @param system  must outlive the object
  explicit CycleWatch(creep::CreepSystem& system);

  /// The variables that count life, of one body.
  const std::vector<const material::StateVariable*>& life_of(std::size_t body) const { return life_[body]; }

  /// The state at the begin of the cycle.
  const std::vector<double>& first() const { return first_; }

  /// Forgets what it has observed, and observes the begin of a cycle. @throws RecoverableError without equilibrium
  void begin(StepView& view);
  /// A state within the cycle, or at its end.
  void observe(StepView& view);
  /// Values of all probes at another time of the cycle.
  void observe_probes(std::span<const double> values);

  /// Adds what the cycle does to the internal variables of laws that count cycles. @returns true if there are any
  /// @throws ModelError as MaterialPoints::add_cycle
  bool add_cycle(std::span<double> y) const;
  /// After the state at the end has been observed. @param y  that state, with what the cycle has added
  /// @param end  as `y`, or corrected @param number  of whole cycles since t = 0
  CycleRecord record(std::span<const double> y, std::span<const double> end, std::int64_t number) const;

 private:
  /// Tensors of all points of a body, one array per state.
  using States = std::vector<std::vector<double>>;
  struct Body {
    States strain;     // elastic and inelastic; deviators
    States inelastic;  // creep and plastic strain; empty if there is neither
    std::vector<double> highest_temperature;
    std::vector<double> first_stress, last_stress;
    double typical_stress = 0;
  };
  /// Largest equivalent difference between two states, at each point.
  static std::vector<double> ranges(const States& states, std::size_t n_points);
  void observe_body(std::size_t body, const creep::Evaluation& at, const mechanics::CreepStrainView& creep);
  double stress_change() const;

  creep::CreepSystem& system_;
  std::vector<std::vector<const material::StateVariable*>> life_;  // per body
  std::vector<Body> bodies_;
  std::vector<CycleRecord::Probe> probes_;
  std::vector<double> first_;  // the state at the begin
};

}  // namespace creepcontact::run
