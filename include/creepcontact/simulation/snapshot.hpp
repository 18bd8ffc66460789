#pragma once
/// Everything known at one output time, and the nodal fields made from it on demand.

#include <map>
#include <memory>
#include <vector>

#include "creepcontact/simulation/creep_rate.hpp"

namespace creepcontact::simulation {

/// Values at one place of a body.
struct Sample {
  Vector3 place = Vector3::Zero();
  Vector3 displacement = Vector3::Zero();
  Tensor6 stress = Tensor6::Zero(), strain = Tensor6::Zero(), creep_strain = Tensor6::Zero();
  double temperature = 0, damage = 0, life_fraction = 0;
};

/// Fields of one body at its integration points and, smoothed, at its nodes.
class BodyFields {
 public:
  /// @param damage, life_fraction  n_points, or empty where they are not known
  BodyFields(mechanics::Body& body, const BodyState& state, mechanics::CreepStrainView creep, double time,
             std::vector<double> damage = {}, std::vector<double> life_fraction = {});

  std::size_t n_nodes() const { return body_.mesh().nodes.size(); }
  std::size_t n_points() const { return body_.discretization().n_points(); }
  Sample at_node(std::size_t node) const;
  /// Displacement is that of the nodes and not known here (zero).
  Sample at_point(std::size_t point) const;
  const mechanics::Body& body() const { return body_; }
  /// Point values, n_points x 6 (Mandel); temperature and what follows n_points.
  const std::vector<double>& point_values(int field) const { return points_[static_cast<std::size_t>(field)]; }
  static constexpr int stress = 0, strain = 1, creep_strain = 2, temperature = 3, damage = 4, life_fraction = 5;

 private:
  mechanics::Body& body_;
  const BodyState& state_;
  std::vector<double> points_[6], nodes_[6];
};

/// State of the model at an output time. The elasticity's last solution must be that of (time, y) and stays in use, y
/// too.
class Snapshot {
 public:
  Snapshot(const CreepRate& system, double time, std::span<const double> y);
  /// Without what creep laws tell beside the strain.
  Snapshot(const ContactElasticity& elasticity, const StateLayout& layout, double time, std::span<const double> y);

  double time() const { return time_; }
  const ContactElasticity& elasticity() const { return elasticity_; }
  bool knows(material::Measure measure) const { return system_ && system_->knows(measure); }
  /// Smoothing happens at the first call for a body.
  const BodyFields& fields(std::size_t body) const;
  /// Nodal residual integral B^T sigma - F of a body without its contact forces: the reactions of its supports.
  const std::vector<double>& reactions(std::size_t body) const;

 private:
  std::vector<double> measure(material::Measure of, std::size_t body) const;

  const ContactElasticity& elasticity_;
  const CreepRate* system_ = nullptr;
  double time_;
  std::span<const double> y_;
  std::vector<mechanics::CreepStrainView> creep_;
  mutable std::map<std::size_t, BodyFields> fields_;
  mutable std::map<std::size_t, std::vector<double>> reactions_;
};

}  // namespace creepcontact::simulation
