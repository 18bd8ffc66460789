/// What an accepted step of an EquilibriumSolver leaves in the history, and the path of slip and flow within it.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "creepcontact/base/index.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "friction_follower.hpp"
#include "plastic_flow.hpp"

namespace creepcontact::creep {
namespace {

constexpr int max_parts = 8;
constexpr double share_of_flow = 0.05;  // of the tolerance in a step: errors of one way add up

/// Creep strains between those of the last step and those of now.
class CreepBetween {
 public:
  CreepBetween(const Assembly& assembly, const History& from, EquilibriumSolver::CreepStrains to)
      : assembly_(assembly), from_(from.plastic), closures_before_(from.gaskets.creep), to_(to) {}

  EquilibriumSolver::CreepStrains at(double part) {
    if (part == 1) return to_;
    views_.assign(to_.bodies().begin(), to_.bodies().end());
    values_.resize(to_.size());
    for (std::size_t b = 0; b < to_.size(); ++b) {
      if (to_[b].empty()) continue;
      const std::vector<double>& before = from_.bodies[b].creep;  // empty: none yet
      values_[b].resize(6 * assembly_.bodies()[b].discretization().n_points());
      for (std::size_t p = 0; 6 * p < values_[b].size(); ++p) {
        tensor::Map now = tensor::writable(values_[b], p);
        now = part * to_[b].at(p);
        if (!before.empty()) now += (1 - part) * tensor::view(before, p);
      }
      views_[b] = {values_[b], 6};
    }
    closures_.assign(to_.closures().begin(), to_.closures().end());
    for (std::size_t i = 0; i < closures_.size() && !closures_before_.empty(); ++i)
      closures_[i] = part * closures_[i] + (1 - part) * closures_before_[i];
    return {views_, closures_};
  }

 private:
  const Assembly& assembly_;
  const PlasticHistory& from_;
  const std::vector<double>& closures_before_;
  EquilibriumSolver::CreepStrains to_;
  std::vector<double> closures_;
  std::vector<std::vector<double>> values_;
  std::vector<mechanics::CreepStrainView> views_;
};

}  // namespace

SlipHistory EquilibriumSolver::slip_until(const Equilibrium& at, const History& history) const {
  const PathPoint from{history.contact, history.friction};
  return slip_advance_->advanced(from, at.time, slip_advance_->reference(from, at.time), at.contact, at.gaps);
}

std::optional<double> EquilibriumSolver::return_error(const Equilibrium& at, const History& history) const {
  constexpr double of_pair = 0.5;  // each step is in two pairs
  if (!at.plastic.flows) return 0;
  if (history.plastic.before.empty()) return std::nullopt;
  const PlasticFlow flow(assembly_, history.plastic, at.time, at.conditions, options_.plastic_tolerance, false);
  return of_pair * flow.redone_error(history.plastic.before, at);
}

void EquilibriumSolver::keep_flow(const Equilibrium& at, CreepStrains creep, std::optional<double> error,
                                  History& history) const {
  PlasticHistory& flow = history.plastic;
  if (flow.bodies.empty()) return;
  const double sum = flow.error + error.value_or(0);
  std::vector<PlasticState> before = std::move(flow.bodies);
  flow = at.plastic;
  flow.before = std::move(before);
  flow.error = sum;
  for (std::size_t b = 0; b < creep.size(); ++b) {
    if (assembly_.bodies()[b].material().plasticity) flow.bodies[b].stress = at.bodies[b].stress;
    std::vector<double>& kept = flow.bodies[b].creep;
    kept.assign(creep[b].empty() ? 0 : 6 * assembly_.bodies()[b].discretization().n_points(), 0.0);
    for (std::size_t p = 0; 6 * p < kept.size(); ++p) tensor::writable(kept, p) = creep[b].at(p);
  }
}

void EquilibriumSolver::settle(const Equilibrium& at, CreepStrains creep, History& history) const {
  keep_flow(at, creep, 0, history);  // nothing flows
  history.plastic.before.clear();
}

std::vector<PathPoint> EquilibriumSolver::take(const Equilibrium& at, CreepStrains creep, std::optional<double> error,
                                               History& history, const PathOptions& options) {
  std::vector<PathPoint> path = friction_->follow(at, history, options);
  const contact::ContactState& contact = path.empty() ? at.contact : path.back().contact;
  std::vector<int> changed;
  std::ranges::set_symmetric_difference(history.contact.active, contact.active, std::back_inserter(changed));
  auto row = changed.begin();
  Index end = 0;
  for (std::size_t p = 0; p < assembly_.pairs().size() && !history.contact.active.empty(); ++p) {
    end += assembly_.pairs()[p].coupling.n_rows();
    const auto next = std::lower_bound(row, changed.end(), end);
    if (next != row) ++history.set_changes[p];
    row = next;
  }
  history.friction = path.empty() ? at.friction : path.back().friction;
  keep_flow(at, creep, error, history);
  history.gaskets.advance(at.time, contact.closure);
  history.gaskets.creep = at.creep_closure;
  history.contact = contact;
  if (!iterates()) return path;
  std::vector<History::Accepted>& accepted = history.accepted;
  if (!accepted.empty() && accepted.front().time == at.time) accepted.erase(accepted.begin());
  accepted.insert(accepted.begin(), {at.time, at.displacements, at.factors});
  if (accepted.size() > 2) accepted.pop_back();
  return path;
}

EquilibriumSolver::FlowPath EquilibriumSolver::in_parts(int n, const Equilibrium& at, CreepStrains creep,
                                                        const History& from, const PathOptions& options) {
  const double begin = from.plastic.time;
  CreepBetween course(assembly_, from, creep);
  FlowPath path{{}, from};
  Equilibrium end;
  try {
    for (int i = 1; i <= n; ++i) {
      const double part = static_cast<double>(i) / n, t = part == 1 ? at.time : begin + part * (at.time - begin);
      const CreepStrains now = course.at(part);
      solve(t, now, path.end, end);
      PathLeg& leg = path.legs.emplace_back(PathLeg{path.end, t, {}});
      leg.before.plastic.before.clear();
      leg.points = take(end, now, return_error(end, path.end), path.end, options);
    }
  } catch (const SolverError&) {
    return {};
  }
  return path;
}

EquilibriumSolver::FlowPath EquilibriumSolver::follow_flow(const Equilibrium& at, CreepStrains creep,
                                                           std::optional<double> error, const History& from,
                                                           const PathOptions& options) {
  const double allowed = share_of_flow * options.tolerance;
  const auto enough = [&](double left, int of) {
    return static_cast<int>(std::min<double>(max_parts, std::ceil(of * std::sqrt(left / allowed))));
  };
  int n = error ? enough(*error, 1) : std::isfinite(allowed) ? 2 : 1;
  if (n <= 1) return {};
  FlowPath path;
  PlasticHistory coarse = at.plastic;
  for (std::size_t b = 0; b < coarse.bodies.size(); ++b) coarse.bodies[b].stress = at.bodies[b].stress;
  const PlasticFlow flow(assembly_, from.plastic, at.time, at.conditions, options_.plastic_tolerance, false);
  for (int before = 1; n > before;) {
    FlowPath finer = in_parts(n, at, creep, from, options);
    if (finer.legs.empty()) break;
    path = std::move(finer);
    // The return is of second order: the difference that the finer path makes tells what it leaves.
    const double ratio = static_cast<double>(n) / before;
    const double left = flow.difference(coarse, path.end.plastic) / (ratio * ratio - 1);
    coarse = path.end.plastic;
    before = std::exchange(n, left > allowed ? std::max(enough(left, n), std::min(2 * n, max_parts)) : n);
  }
  return path;
}

std::vector<PathLeg> EquilibriumSolver::accept(const Equilibrium& at, CreepStrains creep, History& history,
                                               const PathOptions& options) {
  if (!at.plastic.flows && history.friction.slip.size() == 0 && history.gaskets.largest.size() == 0) {
    take(at, creep, 0, history, options);
    return {};
  }
  const std::optional<double> error = return_error(at, history);
  if (at.plastic.flows && at.time > history.plastic.time)
    if (FlowPath path = follow_flow(at, creep, error, history, options); !path.legs.empty()) {
      history = std::move(path.end);
      return std::move(path.legs);
    }
  std::vector<PathLeg> whole;
  PathLeg& leg = whole.emplace_back(PathLeg{history, at.time, {}});
  leg.before.plastic.before.clear();
  leg.points = take(at, creep, error, history, options);
  return whole;
}

}  // namespace creepcontact::creep
