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

  /// Saves the complete state but for the stress of the last accepted step.
  void save(Memory& memory) const;
  /// Inverse of save(). @param at  the state from which the run goes on
  /// @throws std::out_of_range if an entry is missing
  void resume(const Equilibrium& at, const Memory& memory);

 private:
  void keep(const Equilibrium& at);

  const Assembly& assembly_;
  std::vector<std::size_t> bodies_;          // whose laws yield
  double time_ = 0;                          // of the last accepted step
  std::vector<std::vector<double>> stress_;  // of these bodies, at that time
  bool has_stress_ = false;
  struct State {
    std::vector<double> size;  // largest stress of these bodies in the last steps
    double longest = 0;        // next step; 0: not known
    static constexpr auto members = std::tuple{Member{"size", &State::size}, Member{"longest", &State::longest}};
  };
  State state_;
};

}  // namespace creepcontact::creep
