#pragma once
/// Bounds steps where a law has an elastic range, within which nothing flows.

#include <functional>
#include <optional>
#include <vector>

#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// The error estimates of integrators compare rates at the ends of steps and a few stages. Where these are zero they
/// say nothing of a stress that leaves the elastic range in between. So the stress of bodies whose laws yield
/// (material::CreepLaw::yields) may change by a tenth of its size in a step; where the loads of a segment make
/// something flow (material::Plasticity), they may change the stress by a tenth of the yield stress. Calls are
/// collective.
class YieldSteps {
 public:
  /// @param assembly  must outlive the object
  explicit YieldSteps(const Assembly& assembly);

  /// The loads from here on have nothing to do with those before.
  void begin_segment();
  /// An accepted step. Cost: one pass over the points of the bodies that yield.
  void accept(const Equilibrium& at);
  /// The longest next step from t, in a segment of the loads up to `end`; infinity if nothing bounds it.
  /// @param excursion  EquilibriumSolver::yielding_excursion() of the loads at `end`; called once in each segment
  double longest(double t, double end, const std::function<double()>& excursion);

  /// Saves the complete state but for the stress of the last accepted step.
  void save(Memory& memory) const;
  /// Inverse of save(). @param at  the state from which the run goes on; asked for only if some law yields
  /// @throws std::out_of_range if an entry is missing
  void resume(const Memory& memory, const std::function<const Equilibrium&()>& at);

 private:
  void keep(const Equilibrium& at);

  const Assembly& assembly_;
  std::vector<std::size_t> bodies_;          // whose laws yield
  bool may_flow_ = false;                    // some material has plasticity
  double time_ = 0;                          // of the last accepted step
  std::vector<std::vector<double>> stress_;  // of these bodies, at that time
  bool has_stress_ = false;
  struct State {
    std::vector<double> size;    // largest stress of these bodies in the last steps
    double longest = 0;          // next step; 0: not known
    std::optional<double> flow;  // longest step of this segment for what flows; empty: not known
    static constexpr auto members =
        std::tuple{Member{"size", &State::size}, Member{"longest", &State::longest}, Member{"flow", &State::flow}};
  };
  State state_;
};

}  // namespace creepcontact::creep
