#pragma once
/// Bounds steps where a law has an elastic range, within which nothing flows.

#include <span>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// The error estimates of integrators compare rates at the ends of steps and a few stages. Where these are zero they
/// say nothing of a stress that leaves the elastic range in between. So the stress of bodies whose laws yield
/// (material::CreepLaw::yields) may change by a tenth of its size in a step. Calls are collective.
class YieldSteps {
 public:
  /// @param assembly  must outlive the object
  explicit YieldSteps(const Assembly& assembly);

  /// The loads from here on have nothing to do with those before.
  void begin_segment();
  /// An accepted step. Cost: one pass over the points of the bodies that yield.
  void accept(const Equilibrium& at);
  /// True if some law yields.
  bool is_needed() const { return !bodies_.empty(); }
  /// The longest next step from t, in a segment of the loads up to `end`; infinity if no law yields.
  double longest(double t, double end) const;

  /// The complete state, but for the stress of the last accepted step.
  std::vector<double> memory() const;
  /// @param at  the state from which the run goes on
  void resume(const Equilibrium& at, std::span<const double> memory);

 private:
  void keep(const Equilibrium& at);

  const Assembly& assembly_;
  std::vector<std::size_t> bodies_;          // whose laws yield
  double time_ = 0;                          // of the last accepted step
  std::vector<std::vector<double>> stress_;  // of these bodies, at that time
  bool has_stress_ = false;
  std::vector<double> size_;  // largest stress of these bodies in the last steps
  double longest_ = 0;        // 0: not known
};

}  // namespace creepcontact::creep
