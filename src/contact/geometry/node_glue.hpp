#pragma once
/// Tied surfaces whose meshes match, in whole or in part: joined node to node there, as a single mesh would join them.

#include <cstdint>
#include <map>
#include <vector>

#include "continued_surface.hpp"
#include "creepcontact/contact/geometry/node_ties.hpp"

namespace creepcontact::contact {

/// Slave facets all of whose nodes lie on those of a master facet of the same type, and the ties of these nodes.
class NodeGlue {
 public:
  /// Both surfaces continued by those of adjacent sectors, with their facets.
  struct Side {
    const Surface& surface;
    const ContinuedSurface& continued;
    const std::vector<Facet>& facets;
  };

  /// No ties.
  NodeGlue() = default;
  /// Cost: O(n log n) for n facets.
  NodeGlue(const Side& slave, const SurfaceNormals& slave_normals, const Side& master);

  bool empty() const { return ties_.empty(); }
  /// @param facet  own one of the slave
  bool holds(std::size_t facet) const { return !is_matched_.empty() && is_matched_[facet] != 0; }
  /// @param node  of the slave
  bool ties(std::int64_t node) const { return tied_.contains(node); }
  /// Appends the ties to the nodes and rows of a tied coupling, with the tractions that its multipliers mean.
  void append_to(MortarCoupling& coupling) const;

 private:
  struct Tie {
    std::int64_t slave = 0, master = 0;           // of the sector itself
    Matrix3 master_turned = Matrix3::Identity();  // from the master node to its image opposite to the slave
    Vector3 position = Vector3::Zero(), normal = Vector3::Zero();
    double area = 0;
    double hat_area = 0;  // integral of the hat functions of the corners here; 0 if the node is none
    double distance = 0;  // of the two nodes along the normal
    FreeAxes free;
  };
  /// Which tie holds a node: its own one, or that of the node which it follows by cyclic symmetry.
  struct Holder {
    std::size_t tie = 0;
    const mechanics::NodeLinks::Turned* link = nullptr;

    Matrix3 rotation() const { return link != nullptr ? link->rotation : Matrix3(Matrix3::Identity()); }
  };
  using Masters = std::map<std::int64_t, std::int64_t>;  // master node (continued) by slave node

  Masters match(const Side& slave, const Side& master);
  void number_ties(const Masters& masters, const Side& slave, const Side& master);
  void add_facet(std::size_t f, const Facet& facet, const SurfaceNormals& normals);
  void set_axes(const Side& slave, const Side& master);

  std::vector<char> is_matched_;  // by own slave facet
  std::vector<Tie> ties_;
  std::map<std::int64_t, Holder> tied_;                               // by slave node
  std::map<std::int64_t, Vector3> normal_of_follower_;                // by slave node
  std::map<std::int64_t, std::map<std::int64_t, double>> hats_;       // by corner and node: hat of the corner there
  std::map<std::int64_t, std::vector<std::int64_t>> corners_around_;  // of nodes between corners
};

}  // namespace creepcontact::contact
