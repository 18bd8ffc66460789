#pragma once
/// Solution of the equations of one active set by sweeps or conjugate gradients, with what was made for the last sets.

#include "active_set_cache.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "projected_cg.hpp"
#include "schwarz_sweeps.hpp"

namespace creepcontact::contact {

/// What it returns depends on its arguments, and on whether sweeps have failed.
class SetSolver {
 public:
  /// @param problem  must outlive the object
  SetSolver(const ContactProblem& problem, const SchwarzOptions& options);

  /// @param start  multipliers on the set @param total  counts the iterations
  InnerResult solve(const std::vector<int>& active, const ActiveSetLoad& load, const Eigen::VectorXd& start,
                    ContactResult& total);
  void flexibility_changed();
  void set_recorder(IterationRecorder* recorder) { recorder_ = recorder; }
  void set_stop(const StopRequest& stop) { stop_ = stop; }
  bool has_given_up_sweeps() const { return sweeps_fail_; }
  void give_up_sweeps() { sweeps_fail_ = true; }

 private:
  const ContactProblem& problem_;
  SchwarzOptions options_;
  ActiveSetCache<SchwarzSweeps> sweeps_;
  ActiveSetCache<ProjectedCg> cg_;
  IterationRecorder* recorder_ = nullptr;
  StopRequest stop_;
  bool sweeps_fail_ = false;
};

/// Logs a warning of contact unless it has been logged.
void warn_once(const char* message, bool& warned);

}  // namespace creepcontact::contact
