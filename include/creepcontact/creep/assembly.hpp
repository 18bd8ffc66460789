#pragma once
/// The bodies of a model and the contact pairs between them.

#include <functional>
#include <span>
#include <vector>

#include "creepcontact/base/team.hpp"
#include "creepcontact/contact/floating_motions.hpp"
#include "creepcontact/contact/geometry/pair.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::creep {

/// Immutable, so any number of threads may use one assembly. Movable; what the accessors refer to stays where it is.
class Assembly {
 public:
  /// Makes pair number `pair`, one of two surfaces, anew: these relative motions, which only the facets of its surfaces
  /// hinder, shall not change its gaps.
  using Remake = std::function<contact::Pair(const std::vector<mechanics::Body>& bodies, std::size_t pair,
                                             std::span<const mechanics::RigidMotion> sliding)>;

  /// Numbers the contact rows of the pairs. @param remake  if empty, sliding pairs stay as they are
  /// @param team  the processes that share the bodies, each with some elements of them; must outlive the object
  Assembly(std::vector<mechanics::Body> bodies, std::vector<contact::Pair> pairs, const Remake& remake = {},
           const Team& team = serial_team());
  Assembly(Assembly&&) noexcept = default;
  Assembly& operator=(Assembly&&) noexcept = default;

  const std::vector<mechanics::Body>& bodies() const { return bodies_; }
  const std::vector<contact::Pair>& pairs() const { return pairs_; }
  const contact::FloatingMotions& floating() const { return floating_; }
  const Team& team() const { return *team_; }
  /// Some material creeps.
  bool creeps() const;

  /// Conditions of all bodies, in their order. See Body::update().
  void update(double t, std::vector<mechanics::BodyConditions>& conditions) const;
  std::vector<mechanics::BodyConditions> at(double t) const;

 private:
  const Team* team_;
  std::vector<mechanics::Body> bodies_;
  std::vector<contact::Pair> pairs_;
  contact::FloatingMotions floating_;
};

}  // namespace creepcontact::creep
