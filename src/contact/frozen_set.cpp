#include "frozen_set.hpp"

namespace creepcontact::contact {
namespace {

constexpr double nearly_all = 0.8;

}  // namespace

FrozenSet::FrozenSet(const ContactProblem& problem, std::vector<int> active)
    : problem_(problem),
      active_(std::move(active)),
      balance_(problem, active_),
      diagonal_(row_flexibility(problem)(active_)),
      copied_(static_cast<double>(active_.size()) < nearly_all * problem.n_rows()) {
  if (copied_) flexibility_ = problem.total(active_, active_);
}

Eigen::VectorXd FrozenSet::gaps(const Eigen::VectorXd& multiplier) const {
  if (copied_) return flexibility_.selfadjointView<Eigen::Lower>() * multiplier;
  Eigen::VectorXd all = Eigen::VectorXd::Zero(problem_.n_rows());
  all(active_) = multiplier;
  const Eigen::VectorXd gap = problem_.total.selfadjointView<Eigen::Lower>() * all;
  return gap(active_);
}

}  // namespace creepcontact::contact
