#include "active_set.hpp"

#include "creepcontact/linalg/dense_products.hpp"

namespace creepcontact::contact {
namespace {

constexpr double nearly_all = 0.8;

}  // namespace

ActiveSet::ActiveSet(const ContactProblem& problem, std::vector<int> active)
    : problem_(problem),
      active_(std::move(active)),
      balance_(problem, active_),
      diagonal_(row_flexibility(problem)(active_)),
      copied_(!problem.large &&
              static_cast<double>(active_.size()) < nearly_all * static_cast<double>(problem.n_rows())) {
  if (!copied_) return;
  flexibility_ = problem.flexibility()(active_, active_);
  flexibility_.diagonal() += problem.compliance_on(active_);
}

Eigen::VectorXd ActiveSet::gaps(const Eigen::VectorXd& multiplier) const {
  if (copied_) return linalg::symmetric_product(flexibility_, multiplier);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(problem_.n_rows());
  all(active_) = multiplier;
  return flexibility_product(problem_, all)(active_);
}

}  // namespace creepcontact::contact
