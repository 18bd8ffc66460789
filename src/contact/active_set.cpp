#include <algorithm>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/contact/contact_solver.hpp"
#include "creepcontact/contact/frozen_system.hpp"

namespace creepcontact::contact {
namespace {

constexpr int most_updates = 100;
constexpr int most_single_changes = 10000;

class ActiveSet final : public ContactSolver {
 public:
  explicit ActiveSet(const ContactProblem& problem) : problem_(problem), frozen_(problem) {}

  ContactResult solve(const Eigen::VectorXd& initial_gap, const ContactState& warm) override {
    ContactResult result;
    std::vector<int> active = first_set(problem_, initial_gap, warm);
    std::set<std::vector<int>> seen;
    bool one_at_a_time = false;
    for (int change = 0; change < most_single_changes; ++change) {
      Eigen::VectorXd multiplier = frozen_.solve(active, initial_gap);
      const Eigen::VectorXd gap = initial_gap + problem_.total * multiplier;
      std::vector<int> next = updated_set(problem_, active, multiplier, gap);
      result.set_changes = change + 1;
      if (next == active) {
        result.state = {std::move(multiplier), std::move(active)};
        return result;
      }
      one_at_a_time = one_at_a_time || change > most_updates || !seen.insert(active).second;
      active = one_at_a_time ? change_least_index(active, next) : std::move(next);
    }
    throw SolverError("contact: the active-set method found no consistent set of contact nodes");
  }

 private:
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
};

}  // namespace

std::unique_ptr<ContactSolver> active_set_solver(const ContactProblem& problem) {
  return std::make_unique<ActiveSet>(problem);
}

}  // namespace creepcontact::contact
