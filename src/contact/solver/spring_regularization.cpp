#include "spring_regularization.hpp"

#include "unbalanced_load.hpp"

namespace creepcontact::contact {

/// F + N P N^T without the matrix.
class SpringRegularization::HeldOperator final : public FlexibilityOperator {
 public:
  HeldOperator(const ContactProblem& problem, const Eigen::VectorXd& compliance)
      : problem_(problem),
        compliance_(compliance),
        diagonal_(problem.large->diagonal() + problem.rigid.cwiseAbs2() * compliance) {}

  Eigen::VectorXd gaps(const Eigen::VectorXd& multiplier) const override {
    const Eigen::VectorXd motion = compliance_.cwiseProduct(problem_.rigid.transpose() * multiplier);
    return problem_.large->gaps(multiplier) + problem_.rigid * motion;
  }
  const Eigen::VectorXd& diagonal() const override { return diagonal_; }
  std::unique_ptr<Preconditioner> preconditioner(const std::vector<int>& set,
                                                 const Eigen::VectorXd& compliance) const override {
    return problem_.large->preconditioner(set, compliance);
  }

 private:
  const ContactProblem& problem_;
  const Eigen::VectorXd& compliance_;
  Eigen::VectorXd diagonal_;
};

namespace {

constexpr double softness = 1e4;  // against the bodies' own flexibility: the springs carry next to nothing
constexpr int max_spring_updates = 40;
constexpr int patience = 2;  // updates before it is asked whether the bodies fly off

}  // namespace

SpringRegularization::SpringRegularization(const ContactProblem& problem, const StopRequest& stop)
    : problem_(problem), held_(ContactProblem::with_nodes_of(problem)) {
  const double flexibility = flexibility_diagonal(problem).sum();
  compliance_ = problem.rigid.colwise().squaredNorm().transpose();
  for (double& c : compliance_) c = c > 0 ? softness * flexibility / c : 0.0;
  if (problem.large) {
    operator_ = std::make_unique<HeldOperator>(problem, compliance_);
    held_.large = operator_.get();
  } else {
    held_.total = problem.flexibility() + problem.rigid * compliance_.asDiagonal() * problem.rigid.transpose();
  }
  held_.compliance = problem.compliance;
  solver_ = active_set_solver(held_);
  solver_->set_stop(stop);
}

SpringRegularization::~SpringRegularization() = default;

bool SpringRegularization::search(const ContactLoad& load, int& set_changes, const Attempt& attempt) {
  const Eigen::VectorXd resultant =
      load.resultant.size() > 0 ? load.resultant : Eigen::VectorXd(Eigen::VectorXd::Zero(problem_.n_motions()));
  Eigen::VectorXd rigid = compliance_.cwiseProduct(resultant);
  ContactState state;
  for (int update = 0; update < max_spring_updates; ++update) {
    ContactResult held = solver_->solve({load.gap + problem_.rigid * rigid, {}, {}, load.idle}, state);
    set_changes += held.set_changes;
    state = std::move(held.state);
    if (attempt(state)) return true;
    const Eigen::VectorXd unbalanced = problem_.rigid.transpose() * state.multiplier + resultant;
    // No pressures balance these loads if the nearest ones do not: asked only when the springs do not settle.
    if (update == patience) throw_if_unbalanced(problem_, {load.gap, resultant, {}, load.idle, load.force});
    rigid += compliance_.cwiseProduct(unbalanced);
  }
  return false;
}

}  // namespace creepcontact::contact
