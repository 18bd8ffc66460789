#pragma once
/// *TRANSFORM: nodes whose degrees of freedom are along turned directions.

#include <unordered_map>
#include <vector>

#include "loading.hpp"

namespace creepcontact::deck {

struct Transform {
  bool is_cylindrical = false;
  Vector3 a = Vector3::Zero(), b = Vector3::Zero();  ///< as given: points of the axis, or of the first two directions
  Place place;
  /// Unit vectors 1, 2, 3 at a position, as columns.
  Matrix3 directions(const Vector3& position) const;
  /// A node on the axis of cylindrical directions has no radial and no tangential one.
  bool is_on_axis(const Vector3& position) const;
  Vector3 axis() const { return (b - a).normalized(); }
};

class NodeFrames {
 public:
  /// @param impossible  gets transforms that say no direction
  NodeFrames(const Deck& deck, const Resolver& resolver, std::vector<Note>& impossible);

  /// nullptr: x, y, z
  const Transform* of(std::int64_t node) const;
  /// Unit vectors 1, 2, 3 of a node that exists.
  Matrix3 directions(std::int64_t node) const;
  /// False for a radial or tangential direction (1, 2) on the axis.
  bool has_direction(std::int64_t node, int direction) const;
  /// Forces at turned nodes along x, y and z. @param impossible  gets forces without a direction
  void turn_forces(Loading& loading, std::vector<Note>& impossible) const;

 private:
  const Deck& deck_;
  std::vector<Transform> transforms_;
  std::unordered_map<std::int64_t, std::size_t> of_node_;
};

}  // namespace creepcontact::deck
