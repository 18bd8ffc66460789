#pragma once
/// Area in contact, with the edge of contact found between the multiplier nodes.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "creepcontact/contact/condensed_interface.hpp"

namespace creepcontact::simulation {

/// The area of one unilateral pair. Next to an edge of smooth contact the square of the pressure falls linearly to zero
/// (Hertz); so it is continued linearly from the rows under pressure to the open rows beside them, and the edge is
/// where it vanishes. A row counts with the share of its hat that lies inside. Surfaces closed all over count in full.
class ContactArea {
 public:
  ContactArea(const contact::Pair& pair, const mesh::Mesh& slave);

  /// @param pressure  of the pair's multiplier nodes. Cost: O(rows)
  double value(const Eigen::VectorXd& pressure) const;

 private:
  struct Facet {
    std::array<int, 4> rows{};
    std::size_t n_corners = 0;
  };
  bool carries(std::size_t row, const Eigen::VectorXd& pressure) const;
  double continued(std::size_t row, const std::vector<char>& carrying, const Eigen::VectorXd& squared) const;
  void add_inside(const Facet& facet, const Eigen::VectorXd& level, Eigen::VectorXd& inside,
                  Eigen::VectorXd& whole) const;

  std::vector<Facet> facets_;
  std::vector<Vector3> place_, normal_;       // of each row
  std::vector<double> area_;                  // of each row
  std::vector<std::vector<int>> neighbours_;  // rows of the facets around each row, itself excepted
};

}  // namespace creepcontact::simulation
