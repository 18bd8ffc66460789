#pragma once
/// The derivatives of a run: how they and its probes change.

#include <memory>
#include <span>
#include <vector>

#include "changed_values.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/run.hpp"

namespace creepcontact::run {

/// The forward sensitivity equations ds/dt = (df/dy) s + df/dp of a run, for each of some values. `whole` is the state
/// of the run, followed by its derivative with respect to each value in units of its change.
/// Source: Hindmarsh and Serban, User documentation for CVODES, section 2.6.
class Derivatives {
 public:
  /// @param values, base  must outlive the object
  Derivatives(const std::vector<ChangedValue>& values, creep::CreepSystem& base) : values_(values), base_(base) {}
  virtual ~Derivatives() = default;
  Derivatives(const Derivatives&) = delete;
  Derivatives& operator=(const Derivatives&) = delete;

  const std::vector<ChangedValue>& values() const { return values_; }
  creep::CreepSystem& base() const { return base_; }
  std::size_t n_blocks() const { return values_.size() + 1; }
  std::size_t size() const { return n_blocks() * base_.size(); }
  /// Block 0 is that of the run, block k + 1 that of value k.
  template <typename T>
  std::span<T> block(std::span<T> of_whole, std::size_t i) const {
    return of_whole.subspan(i * base_.size(), base_.size());
  }

  /// The rates of all blocks. @throws as CreepSystem::rate()
  virtual void rate(double t, std::span<const double> whole, std::span<double> rate) = 0;
  /// CreepSystem::start_increment() of all blocks.
  virtual void start_increment(double t, std::span<const double> whole, double stress_time, double duration,
                               std::span<double> change) = 0;
  virtual void jacobian_times(double t, std::span<const double> whole, std::span<const double> v,
                              std::span<double> product) = 0;
  /// Accepts a step, of the run too.
  virtual void accept(double t, std::span<const double> whole) = 0;
  virtual bool rate_has_jumped() const = 0;
  virtual void forget_evaluations() = 0;

  /// Takes up what the run has taken up at a breakpoint. @param whole  the state before it
  virtual void pass_breakpoint(double t, std::span<const double> whole) = 0;
  /// Follows a step of the run that has no state.
  virtual void follow_loads(double t) = 0;

  struct OfProbes {
    std::vector<double> derivatives;  ///< by probe, with respect to value/change
    bool is_one_sided = false;        ///< other nodes are in contact with a little more than with a little less of it
  };
  /// One for each value. @throws as CreepSystem::evaluate_output()
  virtual std::vector<OfProbes> of_probes(double t, std::span<const double> whole) = 0;
  /// True if these are differences of models with a little more and a little less of a value, which are on both sides
  /// of a kink that is so near; false if they are those of the state's own side.
  virtual bool are_differences() const = 0;

  /// What the checkpoint has beyond `whole`; resume() then takes up the state.
  virtual void save(creep::Memory& memory) const = 0;
  virtual void restore(const creep::Memory& memory) = 0;
  virtual void resume(double t, std::span<const double> whole) = 0;

 private:
  const std::vector<ChangedValue>& values_;
  creep::CreepSystem& base_;
};

/// @param of_model, of_run  whether creep begins with an infinite rate @throws ConfigError if one of them does
void require_same_start(const ChangedValue& value, bool of_model, bool of_run);

/// The derivative with respect to value/change, from results with more and less of a value.
inline double central_difference(double more, double less) {
  return (more - less) / (2 * relative_change);
}

/// Linear responses of the run's own equilibrium where that is exact, else differences of models that run next to it.
/// @param values, system, solver, kept, passes, watch  of the run; they must outlive the result
/// @throws ConfigError for values with which there are no derivatives; as build_model() and make_system()
std::unique_ptr<Derivatives> make_derivatives(const std::vector<ChangedValue>& values, const model::Model& model,
                                              creep::CreepSystem& system, creep::EquilibriumSolver& solver, Kept& kept,
                                              linalg::GatheredPasses& passes, Stopwatch& watch);

}  // namespace creepcontact::run
