#include "creepcontact/contact/solver/active_set_system.hpp"

#include <algorithm>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/linalg/dense_products.hpp"
#include "friction_system.hpp"
#include "projected_cg.hpp"

namespace creepcontact::contact {

bool factor_semidefinite(const Eigen::MatrixXd& matrix, Eigen::LLT<Eigen::MatrixXd>& factor) {
  factor.compute(matrix);
  if (factor.info() == Eigen::Success && factor.rcond() > 1e-13) return true;
  Eigen::MatrixXd shifted = matrix;
  shifted.diagonal().array() += 1e-12 * matrix.diagonal().maxCoeff();
  factor.compute(shifted);
  return factor.info() == Eigen::Success;
}

namespace {

constexpr double weakest_held_motion = 1e-12;  // of the best held motion: below it a motion is free
constexpr double resultant_error = 1e-9;       // of the forces that make up a resultant
constexpr int max_iterations = 1000;
constexpr double change_tolerance = 1e-9;

}  // namespace

void ActiveSetSystem::factorize(const std::vector<int>& active) {
  factored_ = false;
  Eigen::MatrixXd flexibility = problem_.flexibility()(active, active);
  flexibility.diagonal() += problem_.compliance_on(active);
  if (problem_.n_motions() > 0) {
    motions_ = problem_.rigid(active, Eigen::all);
    fixing_flexibility_ = fixing_flexibility(problem_);
    flexibility.noalias() += fixing_flexibility_ * motions_ * motions_.transpose();
  }
  if (!factor_semidefinite(flexibility, factor_))
    throw SolverError("contact: the conditions of the active set contradict each other");
  if (problem_.n_motions() > 0) {
    factor_.matrixL().solveInPlace(motions_);
    coarse_inverse_ =
        linalg::symmetric_pseudo_inverse(Eigen::MatrixXd(motions_.transpose() * motions_), weakest_held_motion);
  }
  active_ = active;
  factored_ = true;
}

/// A system whose problem has one compliance of gaskets.
struct ActiveSetSystem::WithGaskets {
  WithGaskets(const ContactProblem& of, const Eigen::VectorXd& compliance, double tolerance, const StopRequest& stop)
      : problem(ContactProblem::with_compliance(of, compliance)), system(problem, tolerance) {
    system.set_stop(stop);
  }
  ContactProblem problem;
  ActiveSetSystem system;
};

ActiveSetSystem::ActiveSetSystem(const ContactProblem& problem, double tolerance)
    : problem_(problem), tolerance_(tolerance) {}
ActiveSetSystem::~ActiveSetSystem() = default;

void ActiveSetSystem::flexibility_changed() {
  gaskets_.reset();
  friction_.reset();
  factored_ = false;
  cg_.reset();
}

void ActiveSetSystem::set_stop(const StopRequest& stop) {
  stop_ = stop;
  if (friction_) friction_->set_stop(stop);
  if (gaskets_) gaskets_->system.set_stop(stop);
}

ActiveSetSolution ActiveSetSystem::solve(const std::vector<int>& active, const ContactLoad& load) {
  if (active.empty()) {
    ActiveSetSolution nothing;
    nothing.state.multiplier.setZero(problem_.n_rows());
    nothing.state.rigid.setZero(problem_.n_motions());
    nothing.balanced = load.resultant.size() == 0 || load.resultant.cwiseAbs().maxCoeff() <= resultant_rounding(load);
    return nothing;
  }
  if (problem_.large) return solve_iteratively(active, load);
  if (!factored_ || active != active_) factorize(active);
  return solve_directly(load);
}

ContactState ActiveSetSystem::solve_change(const ContactState& at, const Eigen::VectorXd& gap) {
  if (at.compliance.size() == 0) return change(at, gap);
  if (!gaskets_ || gaskets_->problem.compliance != at.compliance)
    gaskets_ = std::make_unique<WithGaskets>(problem_, at.compliance, tolerance_, stop_);
  return gaskets_->system.change(at, gap);
}

ContactState ActiveSetSystem::change(const ContactState& at, const Eigen::VectorXd& gap) {
  if (at.nodes.empty()) return solve(at.active, {gap, {}}).state;
  if (!friction_) {
    friction_ = std::make_unique<FrictionSystem>(problem_);
    friction_->set_stop(stop_);
  }
  const FrictionRows& rows = friction_->rows();
  const double tolerance = problem_.large != nullptr ? tolerance_ : change_tolerance;
  const Eigen::VectorXd right = -rows.equations(at.nodes, Eigen::VectorXd::Zero(problem_.n_rows()), gap);
  FrictionSystem::Solution change =
      friction_->solve(at.nodes, at.factored, right, Eigen::VectorXd::Zero(problem_.n_motions()), tolerance);
  return {std::move(change.multiplier), std::move(change.rigid), at.active};
}

ActiveSetSolution ActiveSetSystem::solve_directly(const ContactLoad& load) {
  const Index n_motions = problem_.n_motions();
  ActiveSetSolution solution;
  ContactState& state = solution.state;
  state.multiplier.setZero(problem_.n_rows());
  state.rigid.setZero(n_motions);
  state.active = active_;
  const double largest = load.resultant.size() > 0 ? load.resultant.cwiseAbs().maxCoeff() : 0.0;
  Eigen::VectorXd reduced = -load.gap(active_);  // L^-1 (-gap)
  linalg::substitute_forward(factor_.matrixLLT(), reduced);
  if (n_motions > 0) {
    Eigen::VectorXd unbalanced = motions_.transpose() * reduced;  // of the gaps alone
    if (largest > 0) unbalanced += load.resultant;
    state.rigid = coarse_inverse_ * unbalanced;
    reduced.noalias() -= motions_ * state.rigid;
  }
  linalg::substitute_backward(factor_.matrixLLT(), reduced);
  state.multiplier(active_) = reduced;
  if (n_motions > 0) {
    Eigen::VectorXd left = problem_.rigid(active_, Eigen::all).transpose() * reduced;
    state.rigid += fixing_flexibility_ * left;
    if (largest > 0) left += load.resultant;
    const Eigen::MatrixXd weights = problem_.rigid(active_, Eigen::all).cwiseAbs();
    const double sum = (weights.transpose() * reduced.cwiseAbs()).maxCoeff();
    const double rounding = multiplier_rounding(problem_, load) * problem_.rigid.cwiseAbs().colwise().sum().maxCoeff();
    solution.balanced = left.cwiseAbs().maxCoeff() <= std::max(resultant_error * std::max(largest, sum), rounding);
  }
  return solution;
}

ActiveSetSolution ActiveSetSystem::solve_iteratively(const std::vector<int>& active, const ContactLoad& load) {
  if (!cg_ || cg_->active() != active)
    cg_ = std::make_unique<ProjectedCg>(
        problem_, SchwarzOptions{.tolerance = tolerance_, .max_iterations = max_iterations}, active);
  const ActiveSetLoad set_load{load.gap(active), load.resultant, multiplier_rounding(problem_, load)};
  const InnerResult inner = cg_->solve(set_load, Eigen::VectorXd::Zero(set_load.gap.size()), {nullptr, 0, stop_});
  ActiveSetSolution solution;
  ContactState& state = solution.state;
  state.active = active;
  state.multiplier.setZero(problem_.n_rows());
  state.multiplier(active) = inner.multiplier;
  state.rigid.setZero(problem_.n_motions());
  solution.balanced = cg_->balance().holds(inner.multiplier, load.resultant, set_load.rounding);
  if (solution.balanced && !inner.converged)
    throw SolverError("contact: conjugate gradients did not reach their tolerance");
  if (problem_.n_motions() > 0)
    state.rigid = cg_->balance().amplitudes(set_load.gap + flexibility_product(problem_, state.multiplier)(active));
  return solution;
}

}  // namespace creepcontact::contact
