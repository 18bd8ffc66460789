#pragma once
/// Where the edge of contact runs between the multiplier nodes.

#include <Eigen/Dense>
#include <vector>

#include "creepcontact/contact/geometry/contact_grid.hpp"

namespace creepcontact::contact {

/// Signed distances of the multiplier nodes (rows) of one unilateral pair from the edge of contact.
///
/// The gap tells where the edge is, not the pressure: the surfaces part like distance^(3/2) from an edge at which
/// smooth bodies touch, whether the contact is elastic or has grown by creep (the displacement outside of a growing
/// contact is that of an elastic one: E. H. Lee and J. R. M. Radok, J. Appl. Mech. 27, 1960), while the pressure inside
/// depends on the whole history. So gap^(2/3), as the weighted gaps see it, is continued linearly from the open rows to
/// zero.
class ContactEdge {
 public:
  /// @param coupling, grid  of the pair; must outlive the object
  ContactEdge(const contact::MortarCoupling& coupling, const ContactGrid& grid) : coupling_(coupling), grid_(grid) {}

  /// Positive inside, negative outside. Rows further than two rows from the edge: plus or minus the size of the
  /// surface.
  /// @param pressure, gap  of all rows; the gaps are the weighted ones
  /// Cost: the quadrature points of the rows near the edge.
  Eigen::VectorXd distances(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const;

 private:
  /// An open row near the edge: gap^(2/3) is root + slope . (x - place) around it.
  struct OpenRow {
    int row = 0, ring = 0;  // 1: next to a closed row
    std::vector<int> near;  // other open rows within two facets, as indices of open rows
    double measured = 0;    // weighted mean of the gap, to the power of 2/3
    double root = 0;
    Vector3 slope = Vector3::Zero();
    double bend = 0;   // second derivative along the slope ...
    double lever = 0;  // ... and how far outside the slope is the derivative
  };
  std::vector<OpenRow> open_rows(const std::vector<char>& closed, const Eigen::VectorXd& gap) const;
  void fit_slope(OpenRow& open, const std::vector<OpenRow>& all) const;
  void fit_bend(OpenRow& open, const std::vector<OpenRow>& all) const;
  double weighted_root(const OpenRow& open) const;
  double far_distance() const;
  /// Sets the distances of the rows on both sides of the edge, and of the next rows inside.
  void add_distances(const std::vector<OpenRow>& open, const std::vector<char>& closed,
                     Eigen::VectorXd& distance) const;

  const contact::MortarCoupling& coupling_;
  const ContactGrid& grid_;
};

}  // namespace creepcontact::contact
