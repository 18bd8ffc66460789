#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::linalg {

namespace {

/// Entries of the factors from which threads are woken for a pass: it takes some tenths of a millisecond then.
constexpr double parallel_from = 1 << 19;

}  // namespace

void StiffnessSolver::forward(std::span<const double> b, std::span<double> y) {
  TaskList* const tasks = &forward_tasks(b, y);
  run(std::span(&tasks, 1), parallel_from);
}

void StiffnessSolver::backward(std::span<const double> y, std::span<double> x) {
  TaskList* const tasks = &backward_tasks(y, x);
  run(std::span(&tasks, 1), parallel_from);
}

void forward(std::span<const Substitution> of_bodies) {
  std::vector<TaskList*> lists;
  for (const Substitution& part : of_bodies) lists.push_back(&part.solver->forward_tasks(part.from, part.into));
  run(lists, parallel_from);
}

void backward(std::span<const Substitution> of_bodies) {
  std::vector<TaskList*> lists;
  for (const Substitution& part : of_bodies) lists.push_back(&part.solver->backward_tasks(part.from, part.into));
  run(lists, parallel_from);
}

}  // namespace creepcontact::linalg
