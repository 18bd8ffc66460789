#include "creepcontact/linalg/stiffness_solver.hpp"

#include <stdexcept>

#include "creepcontact/linalg/gathered_passes.hpp"

namespace creepcontact::linalg {

TaskList& StiffnessSolver::tasks_of_several(PassDirection /*direction*/, std::span<const PassVector> /*vectors*/) {
  throw std::logic_error("a solver that does not share its factor makes passes of one vector");
}

TaskList& StiffnessSolver::tasks(PassDirection direction, std::span<const PassVector> vectors) {
  if (vectors.size() > 1) return tasks_of_several(direction, vectors);
  const PassVector& only = vectors.front();
  return direction == PassDirection::forward ? forward_tasks(only.from, only.into)
                                             : backward_tasks(only.from, only.into);
}

void StiffnessSolver::forward(std::span<const double> b, std::span<double> y) {
  const Substitution whole{this, b, y};
  pass(PassDirection::forward, {&whole, 1});
}

void StiffnessSolver::backward(std::span<const double> y, std::span<double> x) {
  const Substitution whole{this, y, x};
  pass(PassDirection::backward, {&whole, 1});
}

void pass(PassDirection direction, std::span<const Substitution> of_bodies) {
  GatheredPasses* const gathering = of_bodies.empty() ? nullptr : of_bodies.front().solver->gathering();
  if (gathering != nullptr && gathering->join(direction, of_bodies)) return;
  std::vector<TaskList*> lists;
  lists.reserve(of_bodies.size());
  for (const Substitution& part : of_bodies) {
    const PassVector only{part.from, part.into};
    lists.push_back(&part.solver->tasks(direction, {&only, 1}));
  }
  run(lists, pass_in_parallel_from);
}

void pass_several(PassDirection direction, std::span<const SeveralSubstitutions> of_bodies) {
  std::vector<TaskList*> lists;
  for (const SeveralSubstitutions& part : of_bodies) {
    if (part.vectors.empty()) continue;
    if (part.solver->shared_factor() != nullptr) {
      lists.push_back(&part.solver->tasks(direction, part.vectors));
      continue;
    }
    for (const PassVector& vector : part.vectors) {
      const Substitution whole{part.solver, vector.from, vector.into};
      pass(direction, {&whole, 1});
    }
  }
  run(lists, pass_in_parallel_from);
}

}  // namespace creepcontact::linalg
