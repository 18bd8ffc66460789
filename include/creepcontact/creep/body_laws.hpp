#pragma once
/// The creep laws of all bodies, and the places of their states in the vector y of the differential equation.

#include <span>
#include <vector>

#include "creepcontact/creep/evaluation.hpp"
#include "creepcontact/creep/material_points.hpp"
#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

/// Immutable.
class BodyLaws {
 public:
  /// @param assembly  must outlive the object @param min_strain  one per body, see material::PointState
  BodyLaws(const Assembly& assembly, std::vector<double> min_strain);

  const Assembly& assembly() const { return *assembly_; }
  const StateLayout& layout() const { return layout_; }
  const std::vector<MaterialPoints>& points() const { return points_; }  ///< one per body
  /// Calls function(body, points) for every body that creeps, in their order.
  template <typename Function>
  void for_each_creeping(const Function& function) const {
    for (std::size_t b = 0; b < points_.size(); ++b)
      if (!points_[b].empty()) function(b, points_[b]);
  }
  const std::vector<double>& min_strain() const { return min_strain_; }
  /// What the laws of a body see. @param y  equal or close to that of `at`
  PointsState state(std::size_t body, const Evaluation& at, std::span<const double> y) const;

  /// True if some law of some body has this variable (damage, life fraction, ...).
  bool has(const material::StateVariable& variable) const;
  /// The variable at all points of a body, n_points x variable.width(); empty if none of its laws has it.
  std::vector<double> evaluate(const material::StateVariable& variable, std::size_t body, const Evaluation& at,
                               std::span<const double> y) const;

 private:
  const Assembly* assembly_;
  std::vector<double> min_strain_;
  StateLayout layout_;
  std::vector<MaterialPoints> points_;
};

}  // namespace creepcontact::creep
