#include "preload_search.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::creep {
namespace {

constexpr double tolerance = 1e-9;     // of the force
constexpr double loosely_held = 1e-6;  // of the stiffness with all rows closed: the contact is open, or gives way
constexpr double not_held = 1e-9;      // of the stiffness of the single rows
constexpr double overshoot = 0.9;      // of the first slope
constexpr double shortest = 1e-9;      // part of a step
constexpr int max_iterations = 100;
constexpr double largest_interference = 1e6;  // of the interference that the closed contact would need

std::string unreachable(const PreloadSearch& search, Index worst, double largest, const std::string& cause) {
  return fmt::format(
      "contact '{}': the preload of {:.6g} cannot be reached at t = {:.6g}; the largest normal force is {:.6g}: {}",
      search.names[static_cast<std::size_t>(worst)], search.forces[worst], search.time, largest, cause);
}

}  // namespace

Eigen::VectorXd PreloadSearch::find(Eigen::VectorXd interference) const {
  const auto stiffness = [&](const contact::ContactState& at) {
    Eigen::MatrixXd result(forces.size(), forces.size());
    for (Index q = 0; q < forces.size(); ++q) result.col(q) = -gaps.transpose() * change(at, gaps.col(q));
    return result;
  };
  const auto forces_of = [&](const contact::ContactState& at) {
    return Eigen::VectorXd(-gaps.transpose() * at.multiplier);
  };
  contact::ContactState state = solve(interference);
  Eigen::VectorXd present = forces_of(state), largest = present;
  const Eigen::MatrixXd closed_stiffness = stiffness(closed(state));
  const Eigen::VectorXd stiffest = closed_stiffness.diagonal();
  double growth = 1;
  std::string failure;
  for (int iteration = 0;; ++iteration) {
    const Eigen::VectorXd missing = forces - present;
    Index worst = 0;
    if (missing.cwiseQuotient(forces).cwiseAbs().maxCoeff(&worst) <= tolerance) return interference;
    for (Index p = 0; p < forces.size(); ++p)
      if (!(stiffest[p] > not_held * stiffest.maxCoeff()) && std::abs(missing[p]) > tolerance * forces[p])
        throw ModelError(unreachable(*this, p, present[p],
                                     "it does not depend on the interference, since supports hold both surfaces or "
                                     "the other loads alone determine it"));
    const double far = largest_interference * forces[worst] / stiffest[worst];
    if (iteration == max_iterations || !(std::abs(interference[worst]) < far))
      throw ModelError(unreachable(*this, worst, largest[worst],
                                   "a larger interference opens other contacts or moves the bodies" + failure));
    const Eigen::MatrixXd tangent = stiffness(state);
    const bool is_loose = (tangent.diagonal().array() < loosely_held * stiffest.array()).any();
    growth = is_loose ? 2 * growth : 1;
    const Eigen::VectorXd step =
        (is_loose ? growth : 1.0) *
        (is_loose ? closed_stiffness : tangent).completeOrthogonalDecomposition().solve(missing);
    const double slope = missing.dot(step);
    for (double length = 1;; length /= 2) {
      if (length < shortest)
        throw ModelError(unreachable(*this, worst, largest[worst],
                                     "a larger interference opens other contacts or moves the bodies" + failure));
      try {
        state = solve(interference + length * step);
      } catch (const Error& error) {  // too far: a body has lost its contact
        failure = fmt::format(" ({})", error.what());
        continue;
      }
      const Eigen::VectorXd reached = forces_of(state);
      if (slope > 0 && (forces - reached).dot(step) < -overshoot * slope) continue;
      interference += length * step;
      present = reached;
      largest = largest.cwiseMax(present);
      break;
    }
  }
}

}  // namespace creepcontact::creep
