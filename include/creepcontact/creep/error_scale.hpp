#pragma once
/// How large the stress is: what the accuracy of the creep strain is measured by.

#include <span>
#include <vector>

#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

/// Scale of the state: typical stress / Young's modulus, body by body. A creep strain that is wrong by a share of it
/// makes the stress wrong by no more than that share. It follows the stress: with the stress at the beginning as the
/// measure, the relative error would grow as the stress relaxes.
class ErrorScale {
 public:
  /// @param assembly must outlive the object
  /// @param elastic_stress  largest typical stress of every body under the loads of the run, without creep; not all
  ///        zero, or empty if nothing creeps
  ErrorScale(const Assembly& assembly, const std::vector<double>& elastic_stress);

  /// Typical stress of every body: root mean square of the equivalent stress over its points. Collective.
  static std::vector<double> typical(const Assembly& assembly, const Equilibrium& at);

  /// Takes the stress of an accepted step.
  void follow(const Equilibrium& at);

  std::span<const double> values() const { return values_; }
  /// Every body's scale: all that follow() has left behind.
  const std::vector<double>& strain() const { return strain_; }
  void restore(const std::vector<double>& strain);

 private:
  void set(std::size_t body, double strain);

  const Assembly& assembly_;
  StateLayout layout_;
  double least_ = 0;
  std::vector<double> strain_;  // per body
  std::vector<double> values_;
};

}  // namespace creepcontact::creep
