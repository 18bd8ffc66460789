#include "creepcontact/creep/last_path.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace creepcontact::creep {

void LastPath::solve(EquilibriumSolver& solver, double t, EquilibriumSolver::CreepStrains creep,
                     Equilibrium& into) const {
  const PathLeg& leg = *std::ranges::find_if(legs_, [t](const PathLeg& own) { return t < own.end; });
  const std::vector<PathPoint>& points = leg.points;
  if (points.empty()) return solver.solve(t, creep, leg.before, into);
  auto next = std::ranges::find_if(points, [t](const PathPoint& point) { return point.friction.time > t; });
  if (next == points.end()) --next;
  const PathPoint& from = next == points.begin() ? *next : *std::prev(next);
  History history = leg.before;
  history.contact = from.contact;
  history.friction = from.friction;
  solver.solve(t, creep, history, into);
  SlipHistory& found = into.friction;
  found.path = found.path.cwiseMin(next->friction.path).cwiseMax(from.friction.path);
  for (std::size_t p = 0; p < found.dissipated.size(); ++p)
    found.dissipated[p] =
        std::max(from.friction.dissipated[p], std::min(found.dissipated[p], next->friction.dissipated[p]));
}

void ReportedSlip::raise(SlipHistory& friction) {
  if (friction.time >= last_.time && last_.path.size() == friction.path.size()) {
    friction.path = friction.path.cwiseMax(last_.path);
    std::ranges::transform(friction.dissipated, last_.dissipated, friction.dissipated.begin(),
                           [](double a, double b) { return std::max(a, b); });
  }
  last_.time = friction.time;
  last_.path = friction.path;
  last_.dissipated = friction.dissipated;
}

}  // namespace creepcontact::creep
