#pragma once
/// How large the stress is: what the accuracy of the creep strain is measured by.

#include <span>
#include <vector>

#include "creepcontact/simulation/contact_elasticity.hpp"
#include "creepcontact/simulation/state_layout.hpp"

namespace creepcontact::simulation {

/// Scale of the state: typical stress / Young's modulus, body by body. A creep strain that is wrong by a share of it
/// makes the stress wrong by no more than that share. It follows the stress: with the stress at the beginning as the
/// measure, the relative error would grow as the stress relaxes.
class StressScale {
 public:
  /// No scale yet: set_elastic() makes the first one.
  StressScale(const Model& model, const StateLayout& layout);

  /// Typical stress of a body: root mean square of the equivalent stress over its points.
  static double typical(const BodyState& state);

  /// @param stress  largest typical stress of every body under the loads of the run, without creep; not all zero
  void set_elastic(const std::vector<double>& stress);
  /// Takes the stress of an accepted step.
  void follow(const std::vector<BodyState>& states);

  std::span<const double> values() const { return values_; }
  /// Every body's scale: all that follow() has left behind.
  const std::vector<double>& strain() const { return strain_; }
  void restore(const std::vector<double>& strain);

 private:
  void set(std::size_t body, double strain);
  /// Young's modulus at the body's set time.
  double young_modulus(std::size_t body) const;

  const Model& model_;
  const StateLayout& layout_;
  double least_ = 0;
  std::vector<double> strain_;  // a body
  std::vector<double> values_;
};

}  // namespace creepcontact::simulation
