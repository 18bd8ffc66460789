#pragma once
/// Position of the edge of contact between the multiplier nodes.

#include <Eigen/Core>
#include <map>
#include <vector>

#include "creepcontact/contact/geometry/contact_grid.hpp"

namespace creepcontact::contact {

/// Signed distances of the multiplier nodes (rows) of one unilateral pair from the edge of contact.
///
/// The edge is found from the gap, not from the pressure. Where smooth bodies touch, the gap outside the edge is a
/// series in half-integer powers of the distance from it. This holds for elastic contact and for contact that has grown
/// by linear viscoelasticity (the displacement outside a growing contact is that of an elastic one: E. H. Lee and
/// J. R. M. Radok, J. Appl. Mech. 27, 1960), whereas the pressure inside depends on the whole history.
///
/// The true edge moves continuously, but the set of closed rows changes by whole rows. Between two changes the closed
/// rows act like a punch with a fixed end at the distance d = 0. A punch that ends k inside the edge of the smooth
/// contact opens a gap proportional to
///   d^(3/2) - 3/2 k d^(1/2) + b d^(5/2) + ...
/// (M. L. Williams, J. Appl. Mech. 24, 1957). The gap is linear in the unknown coefficients, which are fitted by least
/// squares to the weighted gaps. The first open row has a small weight, since elements do not resolve it.
class ContactEdge {
 public:
  /// @param coupling, grid  of the pair; must outlive the object
  ContactEdge(const contact::MortarCoupling& coupling, const ContactGrid& grid) : coupling_(coupling), grid_(grid) {}

  /// Signed distance per row of the grid: positive inside, negative outside. Rows more than two rows away from the edge
  /// get plus or minus the size of the surface.
  /// @param closed  1 where a row of the pair is in contact, else 0 @param gap  weighted, of these rows
  /// Cost: the quadrature points of the rows near the edge, for each open row next to it.
  Eigen::VectorXd distances(const std::vector<char>& closed, const Eigen::VectorXd& gap) const;

 private:
  struct State;  // per row: open or closed, mean gap
  /// The edge near an open row that has a closed neighbour.
  struct Edge {
    Vector3 outward;
    double length = 0;     // of the elements, measured across the edge
    double curvature = 0;  // of the lines of equal gap; positive around a round contact
    bool smooth = false;   // true if the gap opens smoothly along the normal
    double to_punch = 0;   // from the row inwards to the end of the punch, in units of `length`
  };
  std::vector<int> open_around(int row, int steps, const State& state) const;
  Edge edge_near(int row, const State& state) const;
  double distance_to(int row, const Edge& edge, const State& state) const;
  /// Mean of to_punch over the neighbouring rows: the closed rows may end unevenly along the edge.
  double mean_to_punch(int row, const std::map<int, Edge>& edges) const;
  void continue_inwards(std::vector<std::pair<int, Vector3>> known, Eigen::VectorXd& distance) const;
  double far_distance() const;

  const contact::MortarCoupling& coupling_;
  const ContactGrid& grid_;
};

}  // namespace creepcontact::contact
