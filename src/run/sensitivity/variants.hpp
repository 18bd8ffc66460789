#pragma once
/// The models from which derivatives are taken, next to that of the run: two for each value, with more and with less of
/// it. They share its mesh, as far as they can its factors, and their passes are made together.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "changed_values.hpp"
#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/creep/distribution.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/probes.hpp"
#include "creepcontact/run/run.hpp"

namespace creepcontact::run {

/// One of the models, with its system.
class Variant {
 public:
  /// @param config, kept  must outlive the object @throws as build_model() and make_system()
  Variant(const config::Config& config, double sign, std::size_t value, Kept& kept, linalg::GatheredPasses& passes);

  double sign() const { return sign_; }         ///< 1: more, -1: less
  std::size_t value() const { return value_; }  ///< number of the changed value
  const model::Model& model() const { return model_; }
  creep::CreepSystem& system() { return system_; }
  std::span<const std::unique_ptr<results::Probe>> probes() const { return probes_; }

  /// Takes over the segment of the run, and passes the breakpoint at which it begins. @param y  the state there
  void follow_segment(double begin, double end, std::span<const double> y);
  /// f of the snapshot at (t, y). @throws as CreepSystem::evaluate_output()
  template <typename F>
  auto with_snapshot(double t, std::span<const double> y, const F& f) {
    const creep::Evaluation& at = system_.evaluate_output(t, y);
    results::Snapshot snapshot(system_.laws(), solver_.interface(), t, at);
    return f(snapshot);
  }

  /// What the checkpoint has of it; resume() then takes up the state.
  void save(creep::Memory& memory) const { system_.save(memory); }
  void restore(creep::Memory memory);
  void resume(double t, std::span<const double> y);

 private:
  Stopwatch watch_;
  double sign_;
  std::size_t value_;
  model::Model model_;
  std::vector<std::unique_ptr<results::Probe>> probes_;
  creep::Distribution distribution_;
  creep::EquilibriumSolver solver_;
  creep::CreepSystem system_;
  std::optional<std::pair<double, double>> segment_;
  std::optional<creep::Memory> restored_;
};

class Variants {
 public:
  /// @param base, kept  of the run; they and `values` must outlive the object
  /// @throws as Variant
  Variants(const std::vector<ChangedValue>& values, creep::CreepSystem& base, Kept& kept,
           linalg::GatheredPasses& passes);

  creep::CreepSystem& base() { return base_; }

  std::span<const std::unique_ptr<Variant>> all() const { return variants_; }

  /// Calls f for all variants, and `of_base` with them, side by side. The states that they get are those of the run
  /// with the changes that belong to them.
  /// @param whole  the state of the run, and for each value its derivative with respect to value/change
  /// @throws what the first of the calls that failed has thrown
  void for_each(std::span<const double> whole, const std::function<void(Variant&, std::span<const double> y)>& f,
                const std::function<void()>& of_base = {});
  /// Its number in all(): the variant with more of value k is 2 k, that with less 2 k + 1.
  static std::size_t index_of(const Variant& variant) { return 2 * variant.value() + (variant.sign() > 0 ? 0 : 1); }

 private:
  creep::CreepSystem& base_;
  linalg::GatheredPasses& passes_;
  std::vector<std::unique_ptr<Variant>> variants_;
  std::vector<std::vector<double>> states_;
};

}  // namespace creepcontact::run
