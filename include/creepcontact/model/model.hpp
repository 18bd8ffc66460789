#pragma once
/// What a configuration and its mesh describe, ready to be solved.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/assembly.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"

namespace creepcontact::model {

struct Model {
  creep::Assembly assembly;
  creep::SolverOptions solver;
  std::optional<mechanics::TemperatureField> temperature;
  std::vector<double> breakpoints;  ///< kinks in time of all loads, supports, gaps, temperatures; ascending

  const std::vector<mechanics::Body>& bodies() const { return assembly.bodies(); }
  const std::vector<contact::Pair>& pairs() const { return assembly.pairs(); }
};

/// @returns bodies.size() if there is none of this name
std::size_t find_body(const std::vector<mechanics::Body>& bodies, const std::string& name);
/// Bodies that have cells on a group.
std::vector<std::size_t> bodies_with(const std::vector<mechanics::Body>& bodies, const std::string& group);

/// Reads the mesh and makes the model; nothing is factored.
/// @throws ModelError with every mistake found, each with its place in the configuration
Model build_model(const config::Config& config);

/// What to say of a body's mesh: parts that hang together nowhere, elements that lock or are folded. One entry each.
std::vector<std::string> mesh_warnings(const mechanics::Body& body);

}  // namespace creepcontact::model
