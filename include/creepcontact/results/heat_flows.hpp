#pragma once
/// How much heat flows where.

#include <memory>
#include <optional>
#include <string>

#include "creepcontact/results/snapshot.hpp"

namespace creepcontact::results {

/// The equations of heat of a model, for sums of its flows. One thread at a time.
class HeatFlows {
 public:
  /// @param assembly  whose temperature is computed; must outlive the object
  explicit HeatFlows(const creep::Assembly& assembly);
  /// @param definition  that of the assembly with its flows in another division
  HeatFlows(const creep::Assembly& assembly, const heat::Definition& definition);

  const heat::Definition& definition() const { return problem_.definition(); }
  /// The flows at the state of a snapshot; rates are those with which the equations hold. Cost: a factorisation, unless
  /// the temperature is steady
  heat::Balance at(Snapshot& snapshot);
  /// See heat::Conduction::flow_scale().
  double scale(Snapshot& snapshot);

 private:
  const creep::Assembly& assembly_;
  heat::Conduction problem_;
};

/// The heat that leaves the bodies through a group of faces: by films, fluxes and radiation there, by flows
/// into its nodes and given temperatures of them, and across contacts.
class SurfaceHeat {
 public:
  /// @param body  only of this one; nullopt: of all
  /// @throws ModelError if no body has faces in the group
  SurfaceHeat(const creep::Assembly& assembly, const std::string& group, std::optional<std::size_t> body);
  double outwards(Snapshot& snapshot);

 private:
  std::unique_ptr<HeatFlows> flows_;
  std::vector<std::size_t> flow_parts_, point_parts_, given_parts_;
  std::vector<std::pair<std::size_t, double>> interface_parts_;  // with the sign of what leaves
};

}  // namespace creepcontact::results
