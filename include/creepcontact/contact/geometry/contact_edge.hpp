#pragma once
/// Where the edge of contact runs between the multiplier nodes.

#include <Eigen/Core>
#include <map>
#include <vector>

#include "creepcontact/contact/geometry/contact_grid.hpp"

namespace creepcontact::contact {

/// Signed distances of the multiplier nodes (rows) of one unilateral pair from the edge of contact.
///
/// The gap tells where the edge is, not the pressure: outside an edge at which smooth bodies touch, the gap is a series
/// in half-integer powers of the distance from it, whether the contact is elastic or has grown by linear
/// viscoelasticity (the displacement outside a growing contact is that of an elastic one: E. H. Lee and J. R. M. Radok,
/// J. Appl. Mech. 27, 1960), while the pressure inside depends on the whole history.
///
/// The edge moves smoothly, but the set of closed rows by whole rows. Between two sets the closed rows act like a punch
/// whose end stands still, at the distance d = 0. A punch that ends k inside the edge of the smooth contact opens the
/// gap
///   d^(3/2) - 3/2 k d^(1/2) + b d^(5/2) + ...
/// (M. L. Williams, J. Appl. Mech. 24, 1957), linear in what is unknown and thus fitted by least squares to the
/// weighted gaps. Elements do not resolve the first open row, so it counts little.
class ContactEdge {
 public:
  /// @param coupling, grid  of the pair; must outlive the object
  ContactEdge(const contact::MortarCoupling& coupling, const ContactGrid& grid) : coupling_(coupling), grid_(grid) {}

  /// Positive inside, negative outside. Rows further than two rows from the edge: plus or minus the size of the
  /// surface.
  /// @param pressure, gap  of all rows; the gaps are the weighted ones
  /// Cost: the quadrature points of the rows near the edge, for each open row next to it.
  Eigen::VectorXd distances(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const;

 private:
  struct State;  // of all rows: open or closed, mean gap
  /// The edge near an open row next to a closed one.
  struct Edge {
    Vector3 outward;
    double length = 0;     // of the elements across the edge
    double curvature = 0;  // of lines of equal gap; positive around a round contact
    bool smooth = false;   // the gap opens smoothly along the normal
    double to_punch = 0;   // from the row inwards to the end of the punch, in lengths
  };
  std::vector<int> open_around(int row, int steps, const State& state) const;
  Edge edge_near(int row, const State& state) const;
  double distance_to(int row, const Edge& edge, const State& state) const;
  /// Mean over the rows beside it: closed rows may end unevenly along the edge.
  double mean_to_punch(int row, const std::map<int, Edge>& edges) const;
  void continue_inwards(std::vector<std::pair<int, Vector3>> known, Eigen::VectorXd& distance) const;
  double far_distance() const;

  const contact::MortarCoupling& coupling_;
  const ContactGrid& grid_;
};

}  // namespace creepcontact::contact
