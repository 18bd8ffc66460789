#include "creepcontact/linalg/stiffness_solver.hpp"

#include <stdexcept>

#include "creepcontact/linalg/gathered_passes.hpp"

namespace creepcontact::linalg {

TaskList& StiffnessSolver::tasks_of_several(PassDirection /*direction*/, std::span<const PassVector> /*vectors*/) {
  throw std::logic_error("a solver that does not share its factor makes passes of one vector");
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
  for (const Substitution& part : of_bodies)
    lists.push_back(direction == PassDirection::forward ? &part.solver->forward_tasks(part.from, part.into)
                                                        : &part.solver->backward_tasks(part.from, part.into));
  run(lists, pass_in_parallel_from);
}

void pass_several(PassDirection direction, std::span<const SeveralSubstitutions> of_bodies) {
  std::vector<TaskList*> lists;
  for (const SeveralSubstitutions& part : of_bodies) {
    if (part.vectors.empty()) continue;
    if (part.solver->shared_factor() != nullptr) {
      lists.push_back(&part.solver->tasks_of_several(direction, part.vectors));
      continue;
    }
    for (const PassVector& vector : part.vectors)
      direction == PassDirection::forward ? part.solver->forward(vector.from, vector.into)
                                          : part.solver->backward(vector.from, vector.into);
  }
  run(lists, pass_in_parallel_from);
}

}  // namespace creepcontact::linalg
