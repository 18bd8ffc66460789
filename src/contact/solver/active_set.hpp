#pragma once
/// What the solvers of the equations of an active set share: the rows' flexibility, the coarse problem of the
/// rigid-body modes, and the outcome.

#include "creepcontact/base/stop_request.hpp"
#include "creepcontact/contact/solver/iteration_recorder.hpp"
#include "rigid_balance.hpp"

namespace creepcontact::contact {

/// What the loads ask of the rows of a set.
struct ActiveSetLoad {
  Eigen::VectorXd gap;
  Eigen::VectorXd resultant;  ///< of all motions; empty: none
  double rounding = 0;        ///< of the multipliers
};

/// Outcome on an active set; `multiplier` is indexed like the set.
struct InnerResult {
  Eigen::VectorXd multiplier;
  int iterations = 0;
  bool converged = false;
};

/// Tells the recorder, if there is one, of the iterations on one set; each heeds the request to end.
struct InnerLog {
  IterationRecorder* recorder = nullptr;
  int set_change = 0;
  StopRequest stop = {};
  void operator()(std::string_view method, int iteration, double residual, std::size_t active) const {
    stop.heed();
    if (recorder) recorder->record({set_change, iteration, method, residual, active});
  }
};

class ActiveSet {
 public:
  ActiveSet(const ContactProblem& problem, std::vector<int> active);

  const std::vector<int>& active() const { return active_; }
  const RigidBalance& balance() const { return balance_; }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  const ContactProblem& problem() const { return problem_; }
  /// F_II multiplier. Cost: reads half of F_II, or of F where the set is nearly all of it and a copy would not pay.
  Eigen::VectorXd gaps(const Eigen::VectorXd& multiplier) const;

 private:
  const ContactProblem& problem_;
  std::vector<int> active_;
  RigidBalance balance_;
  Eigen::VectorXd diagonal_;  // row_flexibility of the set
  bool copied_ = false;
  Eigen::MatrixXd flexibility_;
};

}  // namespace creepcontact::contact
