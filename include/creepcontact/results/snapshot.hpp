#pragma once
/// Everything known at one output time, including nodal fields computed on demand.

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/heat/local_values.hpp"

namespace creepcontact::results {

class Probe;

/// Values at one point of a body. Tensors in Mandel order.
struct Sample {
  Vector3 position = Vector3::Zero();
  Vector3 displacement = Vector3::Zero();
  Tensor6 stress = Tensor6::Zero(), strain = Tensor6::Zero(), creep_strain = Tensor6::Zero();
  double temperature = 0;
  Vector3 heat_flux = Vector3::Zero();
  /// material::state_variables() in turn, StateVariable::width() numbers each; empty: all zero.
  std::vector<double> state = {};
};

/// Fields defined at the integration points.
enum class PointField { stress, strain, creep_strain, temperature };
inline constexpr std::size_t n_tensors = 3;  ///< the first of them

/// A state variable of the laws of a body, n_points x width().
struct PointState {
  const material::StateVariable* variable;
  std::vector<double> values;
};

/// What is known of a body whose temperature is computed.
struct BodyHeat {
  std::vector<double> temperature;  ///< n_nodes; empty: it is not computed
  std::vector<double> flux;         ///< n_points x 3
};

/// Fields of one body at its integration points, and smoothed at its nodes: computed where they are used first. One
/// thread at a time.
class BodyFields {
 public:
  /// @param body, state, conditions, creep  of one equilibrium, must outlive the object
  /// @param variables  in the order of material::state_variables(); those that are missing are zero
  BodyFields(const mechanics::Body& body, const mechanics::BodyConditions& conditions, const creep::BodyState& state,
             mechanics::CreepStrainView creep, std::vector<PointState> variables, BodyHeat heat);
  BodyFields(const BodyFields&) = delete;
  BodyFields& operator=(const BodyFields&) = delete;

  std::size_t n_nodes() const { return body_.mesh().n_cell_nodes(); }
  std::size_t n_points() const { return body_.discretization().n_points(); }
  Sample at_node(std::size_t node) const;
  /// The displacement is a nodal field and not available here: it is zero.
  Sample at_point(std::size_t point) const;
  const mechanics::Body& body() const { return body_; }
  /// Temperatures of the nodes; empty unless they are computed.
  const std::vector<double>& computed_temperature() const { return heat_.temperature; }
  /// Point values: n_points x 6 (Mandel order) for tensors, n_points for scalars.
  const std::vector<double>& point_values(PointField field) const;

 private:
  /// Fields smoothed at the nodes.
  struct Nodal {
    std::vector<double> tensors, temperature;  // n_nodes x n_tensors x 6, n_nodes
    std::vector<double> heat_flux;             // n_nodes x 3; empty: zero
    std::vector<double> state;                 // one row as Sample::state each; empty: all zero
  };
  const Nodal& nodal() const;
  Tensor6 creep_strain_at(std::size_t point) const;
  Tensor6 strain_at(std::size_t point) const;
  double temperature_at(std::size_t point) const;

  const mechanics::Body& body_;
  const mechanics::BodyConditions& conditions_;
  const creep::BodyState& state_;
  mechanics::CreepStrainView creep_;
  mutable std::array<std::vector<double>, n_tensors + 1> points_;  // indexed by PointField; empty: not used yet
  std::vector<PointState> variables_;
  const PointState* plastic_strain_ = nullptr;  // of variables_
  std::vector<double> state_at_points_;         // one row as Sample::state each; empty: all zero
  BodyHeat heat_;
  mutable std::optional<Nodal> nodal_;
};

/// State of the model at one output time. Smoothed fields are computed at their first use.
class Snapshot {
 public:
  /// @param laws, interface, at  must outlive the object
  Snapshot(const creep::BodyLaws& laws, const contact::CondensedInterface& interface, double time,
           const creep::Evaluation& at);
  Snapshot(const creep::CreepSystem& system, double time, const creep::Evaluation& at)
      : Snapshot(system.laws(), system.solver().interface(), time, at) {}

  double time() const { return time_; }
  const creep::Assembly& assembly() const { return laws_.assembly(); }
  const creep::Equilibrium& equilibrium() const { return at_.equilibrium; }
  bool has(const material::StateVariable& variable) const { return laws_.has(variable); }
  /// Position and displacement alone, which need no fields.
  Sample moved_node(std::size_t body, std::size_t node) const;
  /// Fields of a body; computed at the first call.
  const BodyFields& fields(std::size_t body);
  /// What passes the nodes of contact, of all pairs; empty unless the temperature is computed. Computed at the first
  /// call.
  const std::vector<heat::NodeOfInterface>& heat_of_contact();
  /// Temperatures of the nodes of all bodies; empty unless they are computed.
  const std::vector<std::vector<double>>& computed_temperatures();
  /// Support reactions of a body (3 n_nodes): nodal residual integral B^T sigma - F without the contact forces.
  /// Computed at the first call.
  const std::vector<double>& reactions(std::size_t body);
  /// Value of a probe; computed at the first call. Collective.
  double value(const Probe& probe);

 private:
  const creep::BodyLaws& laws_;
  const contact::CondensedInterface& interface_;
  double time_;
  const creep::Evaluation& at_;
  std::map<std::size_t, BodyFields> fields_;
  std::map<std::size_t, std::vector<double>> reactions_;
  std::vector<std::vector<double>> temperatures_;
  std::vector<heat::NodeOfInterface> heat_of_contact_;
  std::map<const Probe*, double> values_;
};

}  // namespace creepcontact::results
