#pragma once
/// Plasticity at the integration points of a body under its conditions at one time.

#include <span>
#include <vector>

#include "creepcontact/creep/equilibrium.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::creep {

/// Arrays over the points are those of PlasticState; empty ones are zero. Refers to its arguments.
class PlasticPoints {
 public:
  /// @param body  of a material with plasticity @throws SolverError for constants that are not admissible
  PlasticPoints(const mechanics::Body& body, const mechanics::BodyConditions& at);

  std::size_t size() const { return n_points_; }
  /// Width of the back stresses of a point: 6 n_back.
  std::size_t back_width() const { return 6 * law_->n_back(); }
  /// True if the constants are the same at all points: what has not flowed has one yield stress.
  bool is_uniform() const { return constants_.size() == law_->n_constants(); }
  double yield_stress(std::size_t point, const std::vector<double>& accumulated) const;
  Tensor6 back_stress(std::size_t point, const std::vector<double>& back) const;
  /// material::Plasticity::hardening() in a state.
  double hardening(std::size_t point, const PlasticState& in, const Tensor6& direction) const;
  double shear_modulus(std::size_t point) const { return elastic_.at(point).mu; }
  /// material::Plasticity::flow() since a state. @param back  back_width() numbers, set to alpha_i at the end
  material::PlasticFlowStep flow(std::size_t point, const PlasticState& since, const Tensor6& trial,
                                 std::span<double> back) const;

 private:
  double temperature(std::size_t point) const;
  std::span<const double> constants(std::size_t point) const;
  std::span<const double> back_of(std::size_t point, const std::vector<double>& back) const;

  const mechanics::Body* body_;
  const mechanics::BodyConditions* at_;
  const material::Plasticity* law_;
  mechanics::ElasticState elastic_;
  std::size_t n_points_;
  std::vector<double> constants_;  // of all points, or one set for all
};

}  // namespace creepcontact::creep
