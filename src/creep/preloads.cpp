/// Preloads by force of an EquilibriumSolver.

#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"
#include "creepcontact/creep/elastic_survey.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "preload_search.hpp"

namespace creepcontact::creep {

namespace {

bool is_hold_due(const contact::Pair& pair, double t, const History& history) {
  return pair.is_relative && pair.from > history.preloaded_until && pair.from <= t;
}

}  // namespace

std::vector<std::size_t> EquilibriumSolver::preloads_due(double t, const History& history) const {
  std::vector<std::size_t> due;
  for (std::size_t p = 0; p < assembly_.pairs().size(); ++p) {
    const auto& preload = assembly_.pairs()[p].preload;
    if (preload && preload->time > history.preloaded_until && preload->time <= t) due.push_back(p);
  }
  return due;
}

bool EquilibriumSolver::has_preload_due(double t, const History& history) const {
  const auto& pairs = assembly_.pairs();
  return !preloads_due(t, history).empty() ||
         std::ranges::any_of(pairs, [&](const contact::Pair& pair) { return is_hold_due(pair, t, history); });
}

void EquilibriumSolver::hold_what_is_reached(double t, CreepStrains creep, History& history) {
  std::vector<const contact::Pair*> due;
  for (const contact::Pair& pair : assembly_.pairs())
    if (is_hold_due(pair, t, history)) due.push_back(&pair);
  if (due.empty()) return;
  const double before = just_before(due.front()->from);
  Equilibrium equilibrium;
  solve(before, creep, history, equilibrium);
  if (history.reached.size() == 0) history.reached.setZero(interface_.n_rows());
  for (const contact::Pair* pair : due) {
    auto rows = history.reached.segment(pair->first_row, pair->coupling.n_rows());
    rows -= equilibrium.gaps.segment(pair->first_row, pair->coupling.n_rows()) - pair->initial_gap(before);
  }
}

Eigen::VectorXd EquilibriumSolver::interference_gaps(const std::vector<double>& interference) const {
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(interface_.n_rows());
  for (std::size_t p = 0; p < interference.size(); ++p)
    if (const contact::Pair& pair = assembly_.pairs()[p]; interference[p] != 0)
      gaps.segment(pair.first_row, pair.coupling.n_rows()) += interference[p] * pair.interference_gap();
  return gaps;
}

void EquilibriumSolver::apply_preloads(double t, double at, CreepStrains creep, History& history) {
  hold_what_is_reached(t, creep, history);
  Equilibrium equilibrium;
  if (const std::vector<std::size_t> due = preloads_due(t, history); !due.empty())
    find_interference(due, 1, history, [&](const History& trial) -> const Equilibrium& {
      solve(at, creep, trial, equilibrium);
      return equilibrium;
    });
  history.preloaded_until = t;
}

void EquilibriumSolver::find_interference(const std::vector<std::size_t>& pairs, double part, History& history,
                                          const std::function<const Equilibrium&(const History&)>& solve) {
  const contact::ContactProblem& problem = interface_.problem();
  const auto n = static_cast<Index>(pairs.size());
  History trial = history;
  double scale = 1;
  PreloadSearch search;
  search.forces.resize(n);
  search.part = part;
  search.is_yielding = !history.plastic.bodies.empty();
  if (search.is_yielding) search.tolerance = std::max(search.tolerance, options_.plastic_tolerance);
  search.gaps.setZero(problem.n_rows(), n);
  Eigen::VectorXd start(n);
  for (Index k = 0; k < n; ++k) {
    const std::size_t p = pairs[static_cast<std::size_t>(k)];
    const contact::Pair& pair = assembly_.pairs()[p];
    search.names.push_back(pair.name);
    search.forces[k] = part * pair.preload.value().force;
    search.gaps.col(k).segment(pair.first_row, pair.coupling.n_rows()) = pair.interference_gap();
    search.time = pair.preload->time;
    start[k] = history.interference[p];
  }
  search.solve = [&](const Eigen::VectorXd& interference) -> const contact::ContactState& {
    for (Index k = 0; k < n; ++k) trial.interference[pairs[static_cast<std::size_t>(k)]] = interference[k];
    const Equilibrium& found = solve(trial);
    scale = found.stiffness_scale;
    trial.contact = found.contact;
    return found.contact;
  };
  search.change = [&](const contact::ContactState& at, const Eigen::VectorXd& gap) {
    return Eigen::VectorXd(scale * contact_change(at, gap).multiplier);
  };
  search.closed = [&](const contact::ContactState& at) {
    contact::ContactState closed = at;
    const std::vector<int>& immovable = interface_.flexibility().immovable();
    for (int row = 0; row < problem.n_rows(); ++row) {
      if (std::ranges::binary_search(immovable, row)) continue;
      closed.active.push_back(row);
      if (!closed.nodes.empty()) closed.nodes[problem.node_of_row[row]].status = contact::ContactStatus::stick;
    }
    std::ranges::sort(closed.active);
    closed.active.erase(std::unique(closed.active.begin(), closed.active.end()), closed.active.end());
    return closed;
  };
  const Eigen::VectorXd found = search.find(start);
  for (Index k = 0; k < n; ++k) history.interference[pairs[static_cast<std::size_t>(k)]] = found[k];
}

}  // namespace creepcontact::creep
