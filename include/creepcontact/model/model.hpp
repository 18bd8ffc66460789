#pragma once
/// The model described by a configuration and its mesh, ready to be solved.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/heat/figures.hpp"
#include "creepcontact/model/load_cycles.hpp"
#include "creepcontact/model/mesh_store.hpp"
#include "creepcontact/model/step_limits.hpp"

namespace creepcontact::model {

/// Bodies, supports, loads and contacts as an assembly, with the options to solve it.
struct Model {
  creep::Assembly assembly;
  creep::SolverOptions solver;
  std::optional<mechanics::TemperatureField> temperature;
  /// Times at which functions of the configuration jump, change their slope or turn back, ascending.
  std::vector<double> breakpoints;
  StepLimits step_limits;                  ///< where functions vibrate
  std::optional<LoadCycles> cycles;        ///< given time.cycle
  std::optional<heat::Figures> heat = {};  ///< given [heat]

  /// Breakpoints at which the loads are not those of an earlier cycle.
  std::vector<double> distinct_breakpoints() const { return cycles ? cycles->distinct_breakpoints() : breakpoints; }
  const std::vector<mechanics::Body>& bodies() const { return assembly.bodies(); }
  const std::vector<contact::Pair>& pairs() const { return assembly.pairs(); }
};

/// Index of a body. @returns bodies.size() if the name is unknown
std::size_t find_body(const std::vector<mechanics::Body>& bodies, const std::string& name);
/// Indices of the bodies that have cells of a group, ascending.
std::vector<std::size_t> bodies_with(const std::vector<mechanics::Body>& bodies, const std::string& group);

/// Reads the mesh and builds the model; nothing is factored.
/// @throws ModelError with one line per error, each with its location in the configuration
/// @param meshes_read  those that need not be read again; may be null
Model build_model(const config::Config& config, MeshStore* meshes_read = nullptr);

/// Remarks on what is allowed and seldom meant, one entry each: moduli that differ as units do; friction above 1.5; one
/// axial strain for bodies of unlike expansion. Also bodies without cyclic symmetry where another body has it, and
/// contacts that few elements resolve. Cost: a pass through the loads and surfaces.
std::vector<std::string> model_warnings(const config::Config& config, const Model& model);

/// Warnings about the mesh of a body, one entry each: separate pieces, elements that lock, folded elements.
std::vector<std::string> mesh_warnings(const mechanics::Body& body);

}  // namespace creepcontact::model
