#include <algorithm>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/contact/solver/active_set_system.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "spring_regularization.hpp"

namespace creepcontact::contact {
namespace {

constexpr int max_updates = 100;
constexpr int max_single_changes = 10000;

class ActiveSetSolver final : public ContactSolver {
 public:
  explicit ActiveSetSolver(const ContactProblem& problem) : problem_(problem), system_(problem) {}

  ContactResult solve(const ContactLoad& load, const ContactState& warm) override {
    ContactResult result;
    result.state.active = first_set(problem_, load, warm);
    if (iterate(load, result) || (problem_.n_motions() > 0 && iterate_springs(load, result))) return result;
    throw SolverError("contact: the active-set method found no consistent set of contact nodes");
  }

  void flexibility_changed() override {
    system_.flexibility_changed();
    springs_.reset();
  }

  void set_recorder(IterationRecorder* recorder) override { recorder_ = recorder; }
  void set_stop(const StopRequest& stop) override {
    stop_ = stop;
    system_.set_stop(stop);
    springs_.reset();
  }

 private:
  /// Updates the set until it repeats; one row at a time if sets recur (only without rigid-body modes, where that
  /// ends).
  bool iterate(const ContactLoad& load, ContactResult& result) {
    std::vector<int> active = result.state.active;
    const double rounding = multiplier_rounding(problem_, load);
    std::set<std::vector<int>> seen;
    bool one_at_a_time = false;
    for (int change = 0; change < max_single_changes; ++change) {
      stop_.heed();
      ActiveSetSolution solution = system_.solve(active, load);
      if (!solution.balanced) return false;
      result.gap = contact_gaps(problem_, load, solution.state);
      Eigen::VectorXd opening = result.gap;  // what is left of the set's own gaps is none
      for (const int row : active) opening[row] = 0;
      std::vector<int> next = updated_set(problem_, load, active, solution.state.multiplier, opening, rounding);
      if (recorder_) recorder_->record({result.set_changes, 1, "active_set", 0.0, active.size()});
      ++result.set_changes;
      if (next == active) {
        result.state = std::move(solution.state);
        return true;
      }
      one_at_a_time = one_at_a_time || change > max_updates || !seen.insert(active).second;
      if (one_at_a_time && problem_.n_motions() > 0) return false;
      active = one_at_a_time ? change_least_index(active, next) : std::move(next);
    }
    return false;
  }

  bool iterate_springs(const ContactLoad& load, ContactResult& result) {
    if (!springs_) springs_ = std::make_unique<SpringRegularization>(problem_, stop_);
    return springs_->search(load, result.set_changes, [&](const ContactState& held) {
      result.state.active = held.active;
      return iterate(load, result);
    });
  }

  /// Murty (1974): of all rows on the wrong side, only the one of least index changes.
  static std::vector<int> change_least_index(std::vector<int> active, const std::vector<int>& wanted) {
    std::vector<int> wrong;
    std::set_symmetric_difference(active.begin(), active.end(), wanted.begin(), wanted.end(),
                                  std::back_inserter(wrong));
    const auto position = std::lower_bound(active.begin(), active.end(), wrong.front());
    if (position != active.end() && *position == wrong.front())
      active.erase(position);
    else
      active.insert(position, wrong.front());
    return active;
  }

  const ContactProblem& problem_;
  ActiveSetSystem system_;
  std::unique_ptr<SpringRegularization> springs_;  // made when first needed
  IterationRecorder* recorder_ = nullptr;
  StopRequest stop_;
};

}  // namespace

std::unique_ptr<ContactSolver> active_set_solver(const ContactProblem& problem) {
  return std::make_unique<ActiveSetSolver>(problem);
}

}  // namespace creepcontact::contact
