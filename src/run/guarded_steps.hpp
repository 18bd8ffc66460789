#pragma once
/// Ends time steps before changes of the loads or of the laws that they would not see.

#include <optional>
#include <span>
#include <vector>

#include "creepcontact/base/memory.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/step_guard.hpp"

namespace creepcontact::run {

/// Before each step, model::StepGuard looks at the functions over the length that the integrator proposes. A jump ends
/// the step, always; anything else does if the creep rate within the step shows that it matters.
class GuardedSteps {
 public:
  /// @param system  must outlive the object
  GuardedSteps(const config::Config& config, const model::Model& model, creep::CreepSystem& system);

  struct End {
    double time = 0;
    bool is_jump = false;  ///< of a function: the integration restarts there
  };
  /// Where the next step from the accepted state y at t, which may reach `to`, has to end. Collective.
  /// @param is_proposed  `to` is the length that the integrator proposes; else it is only a limit of it.
  /// @param segment  between the breakpoints around t. @returns nullopt: where it likes.
  /// Cost: see StepGuard::examine(); one elastic solve where a course deviates and it is not known whether that
  /// matters.
  std::optional<End> end_of_step(double t, std::span<const double> y, double to, bool is_proposed,
                                 const model::StepGuard::Segment& segment);

  /// Stores what later calls depend on, for a checkpoint.
  void save(creep::Memory& memory) const;
  void restore(const creep::Memory& memory);

 private:
  /// What is known of the effect of a course on creep.
  struct Effect {
    double per_deviation = 0;  ///< change of the rate [allowed errors/time] per relative deviation of the course
    double largest = 0;        ///< relative deviation for which it was found; 0: not known
    double age = 0;            ///< findings since then
    static constexpr auto members = std::tuple{Member{"per_deviation", &Effect::per_deviation},
                                               Member{"largest", &Effect::largest}, Member{"age", &Effect::age}};
  };
  bool matters(const model::StepGuard::Finding& finding, double t, std::span<const double> y, double length);
  void report(const model::StepGuard::Finding& finding, double t, double to);

  creep::CreepSystem& system_;
  model::StepGuard guard_;
  bool is_fixed_;  // the user sets the steps: they end at jumps only
  std::vector<Effect> effects_;
  std::vector<char> reported_;
};

}  // namespace creepcontact::run
