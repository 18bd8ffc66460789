#pragma once
/// The bodies of a model and the contact pairs between them.

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/contact/rigid_body_modes.hpp"
#include "creepcontact/heat/conduction.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::creep {

/// How the bodies conduct heat, if their temperature is computed.
struct HeatModel {
  heat::Definition definition;  ///< on the meshes of the bodies
  /// The flow of heat depends on contact, and the temperature is part of the state. Only then:
  bool is_state = false;
  bool is_steady = false;          ///< the temperature does not change in time
  bool is_alone = false;           ///< nothing else is computed
  std::vector<double> start = {};  ///< temperatures at t = 0, or, if they are to be found, a guess
  bool start_is_steady = false;
  double range = 0;                               ///< of the temperatures that are given
  std::vector<std::vector<int>> unknown_of = {};  ///< by body and node
};

/// Bodies, contact pairs and rigid-body modes of a model, in fixed order. Immutable, so any number of threads may use
/// one assembly. Movable; references returned by the accessors stay valid after a move.
class Assembly {
 public:
  /// Rebuilds pair number `pair`, a pair of two surfaces, such that the given relative rigid-body modes leave its gaps
  /// unchanged. Only the facets of the meshes resist these motions.
  using Remake = std::function<contact::Pair(const std::vector<mechanics::Body>& bodies, std::size_t pair,
                                             std::span<const mechanics::RigidMotion> sliding)>;

  /// Numbers the contact rows of the pairs and finds the rigid-body modes.
  /// @param remake  called for each pair that can slide (RigidBodyModes::sliding); if empty, sliding pairs stay as they
  /// are
  /// @param team  the processes that share the bodies, each with some of their elements; must outlive the object
  Assembly(std::vector<mechanics::Body> bodies, std::vector<contact::Pair> pairs, const Remake& remake = {},
           const Team& team = serial_team());
  Assembly(Assembly&&) noexcept = default;
  Assembly& operator=(Assembly&&) noexcept = default;

  const std::vector<mechanics::Body>& bodies() const { return bodies_; }
  const std::vector<contact::Pair>& pairs() const { return pairs_; }
  const contact::RigidBodyModes& rigid_body_modes() const { return rigid_body_modes_; }
  const Team& team() const { return *team_; }
  /// Null unless the temperature is part of the state.
  const HeatModel* heat() const { return heat_ && heat_->is_state ? heat_.get() : nullptr; }
  /// Null unless the temperature is computed.
  const heat::Definition* conduction() const { return heat_ ? &heat_->definition : nullptr; }
  bool is_heat_alone() const { return heat_ && heat_->is_alone; }
  bool has_steady_heat() const { return heat_ && heat_->is_steady; }
  void set_heat(HeatModel heat) { heat_ = std::make_shared<const HeatModel>(std::move(heat)); }
  /// For parts of an assembly, which must outlive them.
  void share_heat(const Assembly& whole) { heat_ = whole.heat_; }
  /// True if at least one material or gasket creeps.
  bool creeps() const;

  /// Conditions at time t, one per body in the order of bodies(). Collective: all members of the team must call it.
  /// update() reuses what `conditions` holds already, see Body::update(). @throws ModelError as Body::at()
  /// @param temperatures  one list per body, or none, see Body::update()
  void update(double t, std::vector<mechanics::BodyConditions>& conditions,
              std::span<const std::vector<double>> temperatures = {}) const;
  std::vector<mechanics::BodyConditions> at(double t) const;

 private:
  const Team* team_;
  std::vector<mechanics::Body> bodies_;
  std::vector<contact::Pair> pairs_;
  contact::RigidBodyModes rigid_body_modes_;
  std::shared_ptr<const HeatModel> heat_;
};

}  // namespace creepcontact::creep
