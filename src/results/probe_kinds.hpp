#pragma once
/// One maker for each kind of place a probe can have.

#include <limits>
#include <span>

#include "creepcontact/results/probes.hpp"
#include "creepcontact/results/quantities.hpp"
#include "point_location.hpp"

namespace creepcontact::results {

/// At a point of a body: fields interpolated in the element that holds it, or in the nearest one on faceted surfaces.
/// @param locators  of the bodies, one each
std::unique_ptr<Probe> point_probe(const config::Probe& probe, const model::Model& model,
                                   std::span<const PointLocator> locators);
/// Over a surface, curve or point group.
std::unique_ptr<Probe> group_probe(const config::Probe& probe, const model::Model& model);
/// Over a whole body, from its integration points (displacements: nodes).
std::unique_ptr<Probe> body_probe(const config::Probe& probe, const model::Model& model);
/// Contact pressure, gap, area, force and moment on a surface of a pair, or on a surface that has faces of one.
std::unique_ptr<Probe> contact_probe(const config::Probe& probe, const model::Model& model);
/// Reactions on a group.
std::unique_ptr<Probe> reaction_probe(const config::Probe& probe, const model::Model& model);

/// Force or moment that passes a plane through a body.
std::unique_ptr<Probe> section_probe(const config::Probe& probe, const model::Model& model);
/// A value of other probes. @param all  the probes of the configuration; those that the expression names exist already
/// @param probes  their configurations, in the same order
std::unique_ptr<Probe> expression_probe(const config::Probe& probe, std::span<const config::Probe> probes,
                                        std::span<const std::unique_ptr<Probe>> all);

/// Axial strain or force of a body. @throws ModelError unless the model is in generalised plane strain
std::unique_ptr<Probe> axial_probe(const config::Probe& probe, const model::Model& model);

/// Weighted values to one number. Where processes share a model, each adds its own values.
class Reduction {
 public:
  explicit Reduction(config::Reduce kind) : kind_(kind) {}
  void add(double value, double weight);
  /// Of what all members of the team have added. Collective.
  double result(const Team& team) const;

 private:
  config::Reduce kind_;
  double sum_ = 0, weight_ = 0;
  double max_ = -std::numeric_limits<double>::infinity(), min_ = std::numeric_limits<double>::infinity();
};

/// Bodies a probe may look at: the one it names, or all that have its group. @throws ModelError if there is none
std::vector<std::size_t> probe_bodies(const config::Probe& probe, const model::Model& model);

}  // namespace creepcontact::results
