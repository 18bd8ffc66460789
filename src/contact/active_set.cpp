#include <algorithm>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/contact/contact_solver.hpp"
#include "creepcontact/contact/frozen_system.hpp"
#include "flying_off.hpp"

namespace creepcontact::contact {
namespace {

constexpr int most_updates = 100;
constexpr int most_single_changes = 10000;
constexpr int most_spring_updates = 40;

/// The problem without rigid motions whose springs hold the bodies: F + N P N^T, with P so soft that the springs carry
/// next to nothing.
ContactProblem held_by_springs(const ContactProblem& problem, Eigen::VectorXd& compliance) {
  constexpr double softness = 1e4;  // against the bodies' own flexibility
  ContactProblem held;
  held.slave_body = problem.slave_body;
  held.master_body = problem.master_body;
  held.bilateral = problem.bilateral;
  const double flexibility = problem.total.trace();
  compliance = problem.rigid.colwise().squaredNorm().transpose();
  for (double& c : compliance) c = c > 0 ? softness * flexibility / c : 0.0;
  held.total = problem.total + problem.rigid * compliance.asDiagonal() * problem.rigid.transpose();
  return held;
}

class ActiveSet final : public ContactSolver {
 public:
  explicit ActiveSet(const ContactProblem& problem) : problem_(problem), frozen_(problem) {}

  ContactResult solve(const ContactLoad& load, const ContactState& warm) override {
    ContactResult result;
    result.state.active = first_set(problem_, load.gap, warm);
    if (iterate(load, result)) return result;
    if (problem_.n_motions() > 0 && iterate_springs(load, result)) return result;
    throw SolverError("contact: the active-set method found no consistent set of contact nodes");
  }

 private:
  /// Updates the set until it repeats; one row at a time if sets recur (only without rigid motions, where that ends).
  bool iterate(const ContactLoad& load, ContactResult& result) {
    std::vector<int> active = result.state.active;
    std::set<std::vector<int>> seen;
    bool one_at_a_time = false;
    for (int change = 0; change < most_single_changes; ++change) {
      FrozenSolution solution = frozen_.solve(active, load);
      if (!solution.balanced) return false;
      const Eigen::VectorXd gap = contact_gaps(problem_, load, solution.state);
      std::vector<int> next = updated_set(problem_, active, solution.state.multiplier, gap);
      ++result.set_changes;
      if (next == active) {
        result.state = std::move(solution.state);
        return true;
      }
      one_at_a_time = one_at_a_time || change > most_updates || !seen.insert(active).second;
      if (one_at_a_time && problem_.n_motions() > 0) return false;
      active = one_at_a_time ? change_least_index(active, next) : std::move(next);
    }
    return false;
  }

  /// Method of multipliers for the balance of the resultants; ends with the exact solution on the set so found.
  bool iterate_springs(const ContactLoad& load, ContactResult& result) {
    if (!held_) {
      held_ = std::make_unique<ContactProblem>(held_by_springs(problem_, compliance_));
      held_solver_ = std::make_unique<ActiveSet>(*held_);
    }
    const Eigen::VectorXd resultant =
        load.resultant.size() > 0 ? load.resultant : Eigen::VectorXd(Eigen::VectorXd::Zero(problem_.n_motions()));
    Eigen::VectorXd rigid = compliance_.cwiseProduct(resultant);
    ContactState state;
    for (int update = 0; update < most_spring_updates; ++update) {
      ContactResult held = held_solver_->solve({load.gap + problem_.rigid * rigid, {}}, state);
      result.set_changes += held.set_changes;
      state = std::move(held.state);
      result.state.active = state.active;
      if (iterate(load, result)) return true;
      const Eigen::VectorXd unbalanced = problem_.rigid.transpose() * state.multiplier + resultant;
      // No pressures balance these loads if the nearest ones do not: asked only when the springs do not settle.
      if (update == 2) throw_if_flying_off(problem_, resultant);
      rigid += compliance_.cwiseProduct(unbalanced);
    }
    return false;
  }

  /// Murty (1974): of all rows on the wrong side, only the one of least index changes.
  static std::vector<int> change_least_index(std::vector<int> active, const std::vector<int>& wanted) {
    std::vector<int> wrong;
    std::set_symmetric_difference(active.begin(), active.end(), wanted.begin(), wanted.end(),
                                  std::back_inserter(wrong));
    const auto place = std::lower_bound(active.begin(), active.end(), wrong.front());
    if (place != active.end() && *place == wrong.front())
      active.erase(place);
    else
      active.insert(place, wrong.front());
    return active;
  }

  const ContactProblem& problem_;
  FrozenSystem frozen_;
  std::unique_ptr<ContactProblem> held_;  // made when first needed
  std::unique_ptr<ActiveSet> held_solver_;
  Eigen::VectorXd compliance_;
};

}  // namespace

std::unique_ptr<ContactSolver> active_set_solver(const ContactProblem& problem) {
  return std::make_unique<ActiveSet>(problem);
}

}  // namespace creepcontact::contact
