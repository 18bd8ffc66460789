#pragma once
/// Everything known at one output time, and the nodal fields made from it on demand.

#include <array>
#include <map>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"

namespace creepcontact::results {

/// Values at one place of a body.
struct Sample {
  Vector3 place = Vector3::Zero();
  Vector3 displacement = Vector3::Zero();
  Tensor6 stress = Tensor6::Zero(), strain = Tensor6::Zero(), creep_strain = Tensor6::Zero();
  double temperature = 0, damage = 0, life_fraction = 0;
};

enum class PointField { stress, strain, creep_strain, temperature, damage, life_fraction };
inline constexpr std::array point_fields{PointField::stress,      PointField::strain, PointField::creep_strain,
                                         PointField::temperature, PointField::damage, PointField::life_fraction};

/// What laws tell of the points of a body beside strain: n_points each, or empty where no law knows it.
struct PointMeasures {
  std::vector<double> damage = {}, life_fraction = {};
};

/// Fields of one body at its integration points and, smoothed, at its nodes.
class BodyFields {
 public:
  /// @param conditions, state  of the equilibrium; state must outlive the object
  BodyFields(const mechanics::Body& body, const mechanics::BodyConditions& conditions, const creep::BodyState& state,
             mechanics::CreepStrainView creep, PointMeasures measures);

  std::size_t n_nodes() const { return body_.mesh().nodes.size(); }
  std::size_t n_points() const { return body_.discretization().n_points(); }
  Sample at_node(std::size_t node) const;
  /// Displacement is that of the nodes and not known here (zero).
  Sample at_point(std::size_t point) const;
  const mechanics::Body& body() const { return body_; }
  /// Point values: n_points x 6 (Mandel) of tensors, n_points of scalars.
  const std::vector<double>& point_values(PointField field) const { return points_[static_cast<std::size_t>(field)]; }

 private:
  const mechanics::Body& body_;
  const creep::BodyState& state_;
  std::array<std::vector<double>, point_fields.size()> points_, nodes_;  // by PointField
};

/// State of the model at an output time. Smoothed fields are made when they are first asked for.
class Snapshot {
 public:
  /// @param system, at  must outlive the object
  Snapshot(const creep::CreepSystem& system, double time, const creep::Evaluation& at);

  double time() const { return time_; }
  const creep::Assembly& assembly() const { return system_.assembly(); }
  const creep::Equilibrium& equilibrium() const { return at_.equilibrium; }
  bool knows(material::Measure measure) const { return system_.knows(measure); }
  const BodyFields& fields(std::size_t body);
  /// Nodal residual integral B^T sigma - F of a body without its contact forces: the reactions of its supports.
  const std::vector<double>& reactions(std::size_t body);

 private:
  const creep::CreepSystem& system_;
  double time_;
  const creep::Evaluation& at_;
  std::map<std::size_t, BodyFields> fields_;
  std::map<std::size_t, std::vector<double>> reactions_;
};

}  // namespace creepcontact::results
