#pragma once
/// The magnitude of the stress, against which the error of the creep strain is measured.

#include <span>
#include <vector>

#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

/// Scale of the state per body: typical stress / Young's modulus. An error of the creep strain of a fraction of this
/// scale causes a relative error of the stress of at most the same fraction. The scale follows the stress as it
/// relaxes; otherwise the relative error would grow. Damage and life fractions have the scale 1.
class ErrorScale {
 public:
  /// @param assembly  must outlive the object
  /// @param elastic_stress  per body, the largest typical stress that the loads of the run cause without creep
  /// (ElasticSurvey::stress); not all zero, or empty if nothing creeps. No body counts as stressed by less than 1 % of
  /// the largest.
  ErrorScale(const Assembly& assembly, const std::vector<double>& elastic_stress);

  /// Typical stress per body: root mean square of the von Mises stress over its points. Collective.
  static std::vector<double> typical(const Assembly& assembly, const Equilibrium& at);

  /// Adapts the scale to the stress of an accepted step; a body changes only if its scale would change by more than
  /// 10 %.
  /// Collective.
  void follow(const Equilibrium& at);

  /// Scale of every entry of y (StateLayout).
  std::span<const double> values() const { return values_; }
  /// Scale per body: the complete state of the object, for restore().
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
