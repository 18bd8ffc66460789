#include "set_solver.hpp"

#include <stdexcept>

#include "creepcontact/base/log.hpp"

namespace creepcontact::contact {

void warn_once(const char* message, bool& warned) {
  if (!warned) log::warning("contact: {}", message);
  warned = true;
}

SetSolver::SetSolver(const ContactProblem& problem, const SchwarzOptions& options)
    : problem_(problem), options_(options) {
  if (options.acceleration == SchwarzOptions::Acceleration::anderson && !options.anderson)
    throw std::invalid_argument("schwarz_solver: Anderson's method was not handed over");
}

InnerResult SetSolver::solve(const std::vector<int>& active, const ActiveSetLoad& load, const Eigen::VectorXd& start,
                             ContactResult& total) {
  stop_.heed();
  const InnerLog log{recorder_, total.set_changes, stop_};
  if (options_.acceleration != SchwarzOptions::Acceleration::cg && !sweeps_fail_) {
    const SchwarzSweeps& sweeps =
        sweeps_.at(active, [&](const auto& set) { return SchwarzSweeps(problem_, options_, set); });
    InnerResult result = sweeps.solve(load, start, log);
    total.iterations += result.iterations;
    if (result.converged) return result;
    warn_once(
        "Schwarz sweeps did not converge with these parameters; conjugate gradients are used instead "
        "(contact_solver.acceleration = \"cg\" uses them from the start)",
        sweeps_fail_);
  }
  const ProjectedCg& gradients = cg_.at(active, [&](const auto& set) { return ProjectedCg(problem_, options_, set); });
  InnerResult result = gradients.solve(load, start, log);
  total.iterations += result.iterations;
  return result;
}

void SetSolver::flexibility_changed() {
  sweeps_.clear();
  cg_.clear();
}

}  // namespace creepcontact::contact
