#include "creepcontact/contact/frozen_interface.hpp"

#include <algorithm>
#include <numeric>

namespace creepcontact::contact {
namespace {

RowMatrix chosen_rows(const RowMatrix& matrix, const std::vector<int>& chosen) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    for (RowMatrix::InnerIterator it(matrix, chosen[k]); it; ++it)
      entries.emplace_back(static_cast<int>(k), it.col(), it.value());
  RowMatrix result(static_cast<int>(chosen.size()), matrix.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

FrozenInterface::FrozenInterface(const CondensedInterface& interface, const std::vector<int>& active,
                                 std::span<const linalg::SupernodalCholesky* const> factors)
    : all_(active.size()), frozen_(problem_) {
  std::iota(all_.begin(), all_.end(), 0);
  const ContactProblem& elastic = interface.problem();
  for (const int row : active) {
    const auto r = static_cast<std::size_t>(row);
    problem_.slave_body.push_back(elastic.slave_body[r]);
    problem_.master_body.push_back(elastic.master_body[r]);
    problem_.bilateral.push_back(elastic.bilateral[r]);
  }
  problem_.rigid = elastic.rigid(active, Eigen::all);
  problem_.total.setZero(n_rows(), n_rows());
  for (std::size_t b = 0; b < factors.size(); ++b) {
    const std::vector<int>& of_body = interface.rows(b).rows;
    Side side;
    std::vector<int> chosen;  // in the rows of the body
    for (std::size_t k = 0; k < active.size(); ++k) {
      const auto found = std::lower_bound(of_body.begin(), of_body.end(), active[k]);
      if (found == of_body.end() || *found != active[k]) continue;
      side.rows.push_back(static_cast<int>(k));
      chosen.push_back(static_cast<int>(found - of_body.begin()));
    }
    if (!chosen.empty()) {
      side.condensed =
          CondensedRows(chosen_rows(interface.rows(b).reduced, chosen), interface.trailing(b), *factors[b]);
      problem_.total(side.rows, side.rows) += side.condensed.flexibility();
    }
    sides_.push_back(std::move(side));
  }
}

void FrozenInterface::add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const {
  const Side& side = sides_[body];
  if (!side.rows.empty()) gap(side.rows) += side.condensed.gaps(y);
}

ContactState FrozenInterface::close(const Eigen::VectorXd& gap) {
  return frozen_.solve(all_, {gap, {}}).state;
}

void FrozenInterface::add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const {
  const Side& side = sides_[body];
  if (!side.rows.empty()) side.condensed.add_forces(multiplier(side.rows), y);
}

}  // namespace creepcontact::contact
