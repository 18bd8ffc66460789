#pragma once
/// Area in contact, with the edge of contact found between the multiplier nodes.

#include <Eigen/Core>

#include "creepcontact/contact/geometry/contact_edge.hpp"

namespace creepcontact::contact {

/// The area of one unilateral pair. A row counts with the share of its hat that lies inside the edge (ContactEdge).
/// Surfaces closed all over count in full.
class ContactArea {
 public:
  /// @param pair  must outlive the object
  ContactArea(const contact::Pair& pair, const mesh::Mesh& slave);
  ContactArea(const ContactArea&) = delete;
  ContactArea& operator=(const ContactArea&) = delete;

  /// @param pressure, gap  of the pair's multiplier nodes; the gaps are the weighted ones. Cost: O(rows), and the
  /// quadrature points near the edge
  double value(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const;

 private:
  void add_inside(const ContactGrid::Facet& facet, const Eigen::VectorXd& level, Eigen::VectorXd& inside,
                  Eigen::VectorXd& whole) const;

  const contact::MortarCoupling& coupling_;
  ContactGrid grid_;
  ContactEdge edge_;  // refers to the grid
};

}  // namespace creepcontact::contact
