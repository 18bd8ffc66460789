#pragma once
/// What time decides about a body: its temperature and what the material makes of it, loads, prescribed displacements.

#include <optional>
#include <span>
#include <vector>

#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::mechanics {

/// Values of one body at one time, made by Body::at() or Body::update(). Owned by the caller.
struct BodyConditions {
  double time = 0;
  std::vector<double> temperature;     ///< n_points; empty if none is given
  std::vector<double> thermal_strain;  ///< n_points, of each normal strain; empty if there is none
  std::vector<Moduli> moduli;          ///< one for all points, or n_points
  std::vector<double> external;        ///< external forces F(t), 3 (n_nodes + n_inner)
  std::vector<double> prescribed;      ///< displacement prescribed by supports, 3 n_nodes
  std::vector<double> known;           ///< F(t) - K prescribed on the nodes, 3 n_nodes
  bool has_inner_force = false;        ///< external forces act on inner displacements

  /// Elastic constants, thermal strain and forces on inner displacements; refers to this object.
  ElasticState elastic() const {
    return {moduli, thermal_strain, has_inner_force ? std::span(external).subspan(known.size()) : std::span<double>{}};
  }
  /// External forces on the nodes, 3 n_nodes.
  std::span<const double> external_forces() const { return std::span(external).first(known.size()); }

  /// Set by Body::update(): what it need not evaluate again.
  std::optional<double> updated_to;
  TemperatureMemo memo;
};

}  // namespace creepcontact::mechanics
