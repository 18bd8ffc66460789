#pragma once
/// Rows of a coupling that join others.

#include <algorithm>
#include <vector>

#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

using Triplets = std::vector<Eigen::Triplet<double>>;

RowMatrix sparse(Index rows, Index columns, const Triplets& entries);

/// Rows that are hardly covered, and those that are told to, join the nearest kept row: dropping them breaks the patch
/// test by 2-5 %. The kept row shares a facet with them (forces must not wander); where there is none, the best covered
/// row is kept.
class RowGathering {
 public:
  struct Neighbour {
    int row = -1;
    double distance = 0;
    Matrix3 turned = Matrix3::Identity();  ///< from its node to the own one, if cyclic symmetry links the two sides
  };

  /// @param neighbours  of the rows that join others: those that share a facet with it
  /// @param covered  part of each row's area that the master covers; 0: the row is left out
  /// @param joins  by row @param drops  by row: those that join others and are left out where there is none
  RowGathering(const std::vector<std::vector<Neighbour>>& neighbours, const std::vector<double>& covered,
               const std::vector<char>& joins, const std::vector<char>& drops);

  const std::vector<int>& kept() const { return kept_; }
  /// kept rows x all rows, in blocks. @param block  (target, i): its entries for the rows of multiplier i, width square
  template <typename Block>
  RowMatrix matrix(int width, const Block& block) const {
    Triplets entries;
    for (const int i : order_) {
      const auto position = static_cast<int>(std::ranges::lower_bound(kept_, target_[i].row) - kept_.begin());
      const Matrix3 values = block(target_[i], i);
      for (int a = 0; a < width; ++a)
        for (int b = 0; b < width; ++b)
          if (values(a, b) != 0) entries.emplace_back(width * position + a, width * i + b, values(a, b));
    }
    return sparse(width * std::ssize(kept_), width * std::ssize(target_), entries);
  }

 private:
  std::vector<Neighbour> target_;  // the row that each is added to; itself if kept, -1 if left out
  std::vector<int> order_, kept_;
};

}  // namespace creepcontact::contact
