#include <memory>
#include <set>

#include "creepcontact/base/log.hpp"
#include "creepcontact/contact/contact_solver.hpp"
#include "schwarz_sweeps.hpp"

namespace creepcontact::contact {
namespace {

class Schwarz final : public ContactSolver {
 public:
  Schwarz(const ContactProblem& problem, const SchwarzOptions& options)
      : problem_(problem), options_(options), fallback_(active_set_solver(problem)) {}

  ContactResult solve(const ContactLoad& load, const ContactState& warm) override {
    if (problem_.n_motions() > 0) return fallback_->solve(load, warm);
    const Eigen::VectorXd& initial_gap = load.gap;
    ContactResult result;
    std::vector<int> active = first_set(problem_, initial_gap, warm);
    Eigen::VectorXd multiplier = warm.multiplier.size() == problem_.n_rows()
                                     ? warm.multiplier
                                     : Eigen::VectorXd(Eigen::VectorXd::Zero(problem_.n_rows()));
    std::set<std::vector<int>> seen;
    while (seen.insert(active).second) {
      const SweepResult inner = solve_frozen(active, initial_gap(active), multiplier(active), result.iterations);
      if (!inner.converged) break;
      multiplier.setZero();
      multiplier(active) = inner.multiplier;
      const Eigen::VectorXd gap = initial_gap + problem_.total * multiplier;
      // What the iteration left of the gaps of the set is no opening.
      Eigen::VectorXd opening = gap;
      opening(active).setZero();
      std::vector<int> next = updated_set(problem_, active, multiplier, opening);
      ++result.set_changes;
      if (next == active) {
        result.state = {std::move(multiplier), {}, std::move(active)};
        return result;
      }
      active = std::move(next);
    }
    warn_once("the Schwarz iteration found no consistent contact state; the active-set method takes over");
    ContactResult direct = fallback_->solve(load, warm);
    direct.iterations = result.iterations;
    return direct;
  }

 private:
  SweepResult solve_frozen(const std::vector<int>& active, const Eigen::VectorXd& gap, const Eigen::VectorXd& start,
                           int& iterations) {
    if (options_.acceleration != SchwarzOptions::Acceleration::cg && !sweeps_diverge_) {
      if (!sweeps_ || sweeps_->active() != active)
        sweeps_ = std::make_unique<SchwarzSweeps>(problem_, options_, active);
      const SweepResult result = sweeps_->solve(gap, start);
      iterations += result.iterations;
      if (result.converged) return result;
      sweeps_diverge_ = true;
      warn_once(
          "Schwarz sweeps did not converge with these parameters; conjugate gradients take over "
          "(contact_solver.acceleration = \"cg\" asks for them from the start)");
    }
    if (!gradients_ || gradients_->active() != active)
      gradients_ = std::make_unique<SchwarzGradients>(problem_, options_, active);
    const SweepResult result = gradients_->solve(gap, start);
    iterations += result.iterations;
    return result;
  }

  void warn_once(const char* message) {
    if (!warned_) log::warning("contact: {}", message);
    warned_ = true;
  }

  const ContactProblem& problem_;
  SchwarzOptions options_;
  std::unique_ptr<ContactSolver> fallback_;
  std::unique_ptr<SchwarzSweeps> sweeps_;
  std::unique_ptr<SchwarzGradients> gradients_;
  bool sweeps_diverge_ = false, warned_ = false;
};

}  // namespace

std::unique_ptr<ContactSolver> schwarz_solver(const ContactProblem& problem, const SchwarzOptions& options) {
  return std::make_unique<Schwarz>(problem, options);
}

}  // namespace creepcontact::contact
