#include "creepcontact/contact/problem.hpp"

#include <algorithm>

namespace creepcontact::contact {
namespace {

constexpr double no_change = 1e-12;

/// A row that neither body can move along (held on both sides) carries no multiplier.
bool is_movable(const ContactProblem& problem, int row) {
  return problem.total(row, row) > 1e-14 * problem.total.diagonal().maxCoeff();
}

}  // namespace

Eigen::VectorXd contact_gaps(const ContactProblem& problem, const ContactLoad& load, const ContactState& state) {
  Eigen::VectorXd gap = load.gap + problem.total * state.multiplier;
  if (problem.n_motions() > 0) gap += problem.rigid * state.rigid;
  return gap;
}

std::vector<int> updated_set(const ContactProblem& problem, const std::vector<int>& current,
                             const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap) {
  const double scale = problem.n_rows() > 0 ? multiplier.cwiseAbs().maxCoeff() : 0.0;
  std::vector<int> next;
  auto it = current.begin();
  for (int i = 0; i < problem.n_rows(); ++i) {
    const bool was_active = it != current.end() && *it == i;
    if (was_active) ++it;
    if (!is_movable(problem, i)) continue;
    const double indicator = multiplier[i] - gap[i] / problem.total(i, i);
    const double threshold = was_active ? -no_change * scale : no_change * scale;
    if (problem.bilateral[static_cast<std::size_t>(i)] || indicator > threshold) next.push_back(i);
  }
  return next;
}

std::vector<int> first_set(const ContactProblem& problem, const Eigen::VectorXd& initial_gap,
                           const ContactState& warm) {
  if (warm.multiplier.size() == problem.n_rows() && problem.n_rows() > 0) return warm.active;
  return updated_set(problem, {}, Eigen::VectorXd::Zero(problem.n_rows()), initial_gap);
}

}  // namespace creepcontact::contact
