#pragma once
/// Quantities of a body that depend on time: temperature, moduli, thermal strain, loads and prescribed displacements.

#include <optional>
#include <span>
#include <vector>

#include "creepcontact/mechanics/discretization.hpp"
#include "creepcontact/mechanics/temperature_field.hpp"

namespace creepcontact::mechanics {

/// Values of one body at one time, made by Body::at() or Body::update(). Owned by the caller.
struct BodyConditions {
  double time = 0;
  std::vector<double> temperature;      ///< n_points; empty if none is given
  std::vector<double> thermal_strain;   ///< n_points, equal normal strains; empty if there is none
  std::vector<double> thermal_tensors;  ///< n_points x 6 if it expands along axes or has an initial stress; else empty
  std::vector<Moduli> moduli;           ///< one for all points, or n_points
  std::vector<Matrix6> matrices;        ///< n_points of anisotropic elasticity (ElasticState); else empty
  std::vector<double> external;         ///< external forces F(t), 3 (n_nodes + n_inner)
  std::vector<double> prescribed;       ///< prescribed displacement, 3 n_nodes
  std::vector<double> known;            ///< F(t) - K prescribed at the nodes, 3 n_nodes
  bool has_inner_force = false;         ///< true if external forces act on inner displacements

  /// Moduli, thermal strain and forces on inner displacements; refers to this object.
  ElasticState elastic() const {
    return {moduli, thermal_strain, has_inner_force ? std::span(external).subspan(known.size()) : std::span<double>{},
            matrices, thermal_tensors};
  }
  /// Moduli alone.
  ElasticState stiffness() const { return {.moduli = moduli, .matrices = matrices}; }
  /// External forces on the nodes, 3 n_nodes.
  std::span<const double> external_forces() const { return std::span(external).first(known.size()); }

  /// Used by Body::update() to skip what is up to date.
  std::optional<double> updated_to;
  TemperatureMemo memo;
};

}  // namespace creepcontact::mechanics
