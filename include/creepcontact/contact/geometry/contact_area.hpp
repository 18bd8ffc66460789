#pragma once
/// Area in contact. The edge of contact is located between the multiplier nodes.

#include <Eigen/Core>
#include <vector>

#include "creepcontact/contact/geometry/contact_edge.hpp"

namespace creepcontact::contact {

/// The area in contact of one unilateral pair. Each row counts with the part of its standard hat function that lies
/// inside the edge (ContactEdge); surfaces that are closed everywhere count in full.
class ContactArea {
 public:
  /// @param pair  must outlive the object @param slave  mesh of the slave body
  ContactArea(const contact::Pair& pair, const mesh::Mesh& slave);
  ContactArea(const ContactArea&) = delete;
  ContactArea& operator=(const ContactArea&) = delete;

  /// Area in contact [length^2]. @param closed  1 where a multiplier node of the pair is in contact (closed_nodes),
  /// else 0 @param gap  weighted, of these nodes Cost: O(rows), and the quadrature points near the edge.
  double value(const std::vector<char>& closed, const Eigen::VectorXd& gap) const;
  /// Areas in contact of the multiplier nodes; value() is their sum.
  Eigen::VectorXd of_nodes(const std::vector<char>& closed, const Eigen::VectorXd& gap) const;

 private:
  void add_inside(const ContactGrid::Facet& facet, const Eigen::VectorXd& level, Eigen::VectorXd& inside,
                  Eigen::VectorXd& whole) const;

  const contact::MortarCoupling& coupling_;
  ContactGrid grid_;
  ContactEdge edge_;  // refers to the grid
};

}  // namespace creepcontact::contact
