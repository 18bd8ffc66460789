#pragma once
/// One maker of probes for each support of output variables.

#include <limits>
#include <span>

#include "creepcontact/results/probes.hpp"
#include "creepcontact/results/quantities.hpp"
#include "point_location.hpp"

namespace creepcontact::results {

/// What a probe is made of.
struct ProbeRequest {
  const config::Probe& probe;
  const Quantity& quantity;
  const model::Model& model;
  std::span<const PointLocator> locators;  ///< one per body, if the probe is at a point
};

// One maker for each support. @throws ModelError if the model has no such place

/// Makes a probe at a point of a body (fields interpolated in the element that holds it, or in the nearest one on
/// faceted surfaces), over a group, or over a whole body from its nodes.
std::unique_ptr<Probe> make_probe(const AtNodes& nodes, const ProbeRequest& request);
/// Makes a probe at the same places, but over a whole body from its integration points.
std::unique_ptr<Probe> make_probe(const AtPoints& points, const ProbeRequest& request);
/// Makes a probe on a surface of a pair, or on a surface that has faces of one.
std::unique_ptr<Probe> make_probe(const AtMultipliers& multipliers, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const OverWidth& width, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const OnSpring& spring, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const OnContactSurface& surface, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const AreaInContact& area, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const OnSupports& supports, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const OnCrossSection& section, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const OnPlane& plane, const ProbeRequest& request);
std::unique_ptr<Probe> make_probe(const ThroughSurface& surface, const ProbeRequest& request);

/// A value of other probes. @param all  the probes of the configuration; those that the expression names exist already
/// @param probes  their configurations, in the same order
std::unique_ptr<Probe> expression_probe(const config::Probe& probe, std::span<const config::Probe> probes,
                                        std::span<const std::unique_ptr<Probe>> all);

/// Weighted values to one number. Where processes share a model, each adds its own values.
class Reduction {
 public:
  explicit Reduction(config::Reduce kind) : kind_(kind) {}
  void add(double value, double weight);
  /// The reduction of what all members of the team have added. Collective.
  double result(const Team& team) const;

 private:
  config::Reduce kind_;
  double sum_ = 0, weight_ = 0;
  double max_ = -std::numeric_limits<double>::infinity(), min_ = std::numeric_limits<double>::infinity();
};

/// Bodies a probe may look at: the one it names, or all that have its group. @throws ModelError if there is none
std::vector<std::size_t> probe_bodies(const config::Probe& probe, const model::Model& model);

}  // namespace creepcontact::results
