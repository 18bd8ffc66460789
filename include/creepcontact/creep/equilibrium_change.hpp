#pragma once
/// First-order changes of an equilibrium: what changes its equations, and how it follows while what is closed stays
/// closed. Plain values.

#include <functional>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/creep/equilibrium.hpp"

namespace creepcontact::creep {

/// Changes of the equations at the displacements and multipliers that the equilibrium has.
struct EquationChange {
  FreeDisplacements forces;  ///< per body, n_free: of the external forces less those of the stress
  Eigen::VectorXd gap;       ///< of the weighted gaps of all rows
  Eigen::VectorXd work;      ///< of the external forces on unit rigid-body modes, RigidBodyModes::size()
  /// What `forces` come from, which adds to the change of the stress: per body that of the stress at all points,
  /// n_points x 6, or that of the initial strain, or neither.
  std::vector<std::vector<double>> stress;
  std::vector<mechanics::CreepStrainView> strain;
};

/// What an equilibrium changes by.
struct EquilibriumChange {
  std::vector<std::vector<double>> displacement;  ///< 3 n_nodes per body, without that of prescribed displacements
  std::vector<std::vector<double>> stress;        ///< n_points x 6 per body
  Eigen::VectorXd multiplier, rigid;              ///< as in ContactState
  Eigen::VectorXd gap;                            ///< weighted gaps of all rows
};

/// A change that is wanted, and where it goes: memory of an earlier one, or new.
struct ChangeTask {
  EquationChange* equations;  ///< its forces are overwritten
  EquilibriumChange* change;
};

/// Changes of an equilibrium that is being solved, by its own passes. It is called when time and conditions of the
/// equilibrium are known, and nothing else of it.
using CarriedChanges = std::function<std::vector<ChangeTask>(const Equilibrium& begun)>;

}  // namespace creepcontact::creep
