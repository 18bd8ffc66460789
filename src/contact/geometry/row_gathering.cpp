#include "row_gathering.hpp"

#include <limits>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {

RowMatrix sparse(Index rows, Index columns, const Triplets& entries) {
  RowMatrix matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

RowGathering::RowGathering(const std::vector<std::vector<Neighbour>>& neighbours, const std::vector<double>& covered,
                           const std::vector<char>& joins, const std::vector<char>& drops)
    : target_(covered.size()) {
  for (int i = 0; i < std::ssize(covered); ++i)
    if (covered[i] > 0) order_.push_back(i);
  std::ranges::stable_sort(
      order_, [&](int i, int j) { return joins[i] != joins[j] ? joins[i] < joins[j] : covered[i] > covered[j]; });
  for (const int i : order_) {
    target_[i] = {i, 0, Matrix3::Identity()};
    if (joins[i] == 0) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Neighbour& other : neighbours[i]) {
      if (other.row == i || target_[other.row].row != other.row || other.distance >= nearest) continue;
      nearest = other.distance;
      target_[i] = other;
    }
    if (drops[i] != 0 && target_[i].row == i) target_[i].row = -1;
  }
  std::erase_if(order_, [&](int i) { return target_[i].row < 0; });
  for (std::size_t i = 0; i < target_.size(); ++i)
    if (target_[i].row == static_cast<int>(i)) kept_.push_back(target_[i].row);
}

}  // namespace creepcontact::contact
