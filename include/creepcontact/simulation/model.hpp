#pragma once
/// The bodies and contact pairs of a configuration, ready to be factored.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/contact/condensed_interface.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "creepcontact/mechanics/body.hpp"
#include "creepcontact/simulation/temperature_watch.hpp"

namespace creepcontact::simulation {

struct Model {
  std::vector<std::unique_ptr<mechanics::Body>> bodies;
  std::vector<contact::Pair> pairs;
  std::optional<mechanics::TemperatureField> temperature;
  TemperatureWatch temperature_watch;
  bool use_schwarz = true;
  contact::SchwarzOptions schwarz;
  double dense_limit_mb = 0;        ///< of the contact zone's dense matrices
  double refactor_change = 0;       ///< of the stiffness, relative, beyond which it is factored anew
  std::vector<double> breakpoints;  ///< kinks in time of all loads, supports, gaps, temperatures; ascending

  /// @returns bodies.size() if there is none of this name
  std::size_t find_body(const std::string& name) const;
  /// Bodies that have cells on a group.
  std::vector<std::size_t> bodies_with(const std::string& group) const;
  bool creeps() const;
};

/// Reads the mesh and makes the model; nothing is factored.
/// @throws ModelError with every mistake found, each with its place in the configuration
Model build_model(const config::Config& config);

/// What to say of a body's mesh: parts that hang together nowhere, elements that lock or are folded. One entry each.
std::vector<std::string> mesh_warnings(const mechanics::Body& body);

std::unique_ptr<contact::ContactSolver> make_contact_solver(const Model& model, const contact::ContactProblem& problem);

}  // namespace creepcontact::simulation
