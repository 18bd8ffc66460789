#include "dirichlet_problem.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/linalg/dense_products.hpp"
#include "rigid_balance.hpp"

namespace creepcontact::contact {
namespace {

constexpr double singular = 1e-9;  // reciprocal condition

}  // namespace

DirichletProblem::DirichletProblem(const ContactProblem& problem, std::size_t body, const std::vector<int>& own,
                                   const Eigen::VectorXd& compliance, IfSingular if_singular) {
  Eigen::MatrixXd flexibility = problem.of_bodies()[body].matrix(own, own);
  flexibility.diagonal() += compliance;
  Eigen::MatrixXd basis(flexibility.rows(), 0);
  if (problem.n_motions() > 0) {
    Eigen::MatrixXd right;
    Eigen::VectorXd values;
    singular_parts(problem.rigid_of_body[body](own, Eigen::all), basis, values, right);
    if (basis.cols() > 0)
      flexibility.noalias() += flexibility.trace() / static_cast<double>(basis.cols()) * basis * basis.transpose();
  }
  flexibility_ = flexibility.diagonal();
  factor_.compute(flexibility);
  regular_ = factor_.info() == Eigen::Success && factor_.rcond() > singular;
  if (!regular_ && if_singular == IfSingular::nothing) return;
  if (!regular_) pseudo_inverse_ = linalg::symmetric_pseudo_inverse(flexibility, singular);
  if (basis.cols() == 0) return;
  carried_.resize(basis.rows(), basis.cols());
  for (Index j = 0; j < basis.cols(); ++j) carried_.col(j) = multipliers(basis.col(j));
  const Eigen::LLT<Eigen::MatrixXd> coarse(basis.transpose() * carried_);
  coarse.matrixU().solveInPlace<Eigen::OnTheRight>(carried_);
}

Eigen::VectorXd DirichletProblem::multipliers(const Eigen::VectorXd& trace) const {
  return regular_ ? linalg::solution(factor_.matrixLLT(), trace) : linalg::symmetric_product(pseudo_inverse_, trace);
}

Eigen::VectorXd DirichletProblem::balanced_multipliers(const Eigen::VectorXd& trace) const {
  Eigen::VectorXd result = multipliers(trace);
  if (carried_.cols() > 0) result.noalias() -= carried_ * (carried_.transpose() * trace);
  return result;
}

Eigen::VectorXd DirichletProblem::stiffness() const {
  if (!regular_) return flexibility_.cwiseMax(1e-14 * flexibility_.maxCoeff()).cwiseInverse();
  const Index n = flexibility_.size();
  Eigen::VectorXd diagonal = factor_.solve(Eigen::MatrixXd::Identity(n, n)).diagonal();
  if (carried_.cols() > 0) diagonal -= carried_.rowwise().squaredNorm();
  return diagonal.cwiseMax(1e-14 * diagonal.maxCoeff());
}

OwnRows own_rows(const ContactProblem& problem, std::size_t body, const std::vector<int>& set) {
  OwnRows result;
  const std::vector<int>& rows = problem.of_bodies()[body].rows;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const auto found = std::lower_bound(rows.begin(), rows.end(), set[k]);
    if (found == rows.end() || *found != set[k]) continue;
    result.positions.push_back(static_cast<int>(k));
    result.own.push_back(static_cast<int>(found - rows.begin()));
  }
  return result;
}

}  // namespace creepcontact::contact
