#include "preload_search.hpp"

#include <fmt/format.h>

#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::creep {
namespace {

constexpr double loosely_held = 1e-6;  // of the stiffness with all rows closed: the contact is open, or gives way
constexpr double not_held = 1e-9;      // of the stiffness of a single row
constexpr double overshoot = 0.9;      // of the first slope
constexpr double min_step = 1e-9;      // part of a step
constexpr double same_force = 1e-6;    // of the product of two stiffnesses
constexpr int max_iterations = 100;
constexpr double largest_interference = 1e6;  // of the interference that the closed contact would need

/// Why a preload was not reached.
class Failure {
 public:
  Failure(const PreloadSearch& search, const Eigen::VectorXd& present)
      : search_(search), largest_(present), smallest_(present) {}

  void saw(const Eigen::VectorXd& present) {
    largest_ = largest_.cwiseMax(present);
    smallest_ = smallest_.cwiseMin(present);
  }
  void saw(const Error& error) { error_ = fmt::format(" ({})", error.what()); }

  [[noreturn]] void raise(Index worst, double missing, const Eigen::MatrixXd& closed_stiffness) const {
    const std::vector<Index> same = in_series(worst, closed_stiffness);
    if (same.size() > 1) raise_series(same);
    if (missing < 0)
      raise(worst, "smallest", smallest_[worst], "the loads that act at this time press the contact with as much");
    raise(worst, "largest", largest_[worst],
          (search_.is_yielding ? "under a larger interference the bodies flow, or other contacts open"
                               : "a larger interference opens other contacts or moves the bodies") +
              error_);
  }
  [[noreturn]] void raise_constant(Index which, double present) const {
    raise(which, "largest", present,
          "it does not depend on the interference, since supports hold both surfaces, or the other loads alone "
          "determine it, such as on a body that nothing else holds");
  }

 private:
  [[noreturn]] void raise(Index which, const std::string& kind, double force, const std::string& cause) const {
    throw ModelError(fmt::format(
        "contact '{}': the preload of {:.6g} cannot be reached at t = {:.6g}; the {} normal force is {:.6g}: {}",
        name(which), search_.forces[which] / search_.part, search_.time, kind, force, cause));
  }
  [[noreturn]] void raise_series(const std::vector<Index>& contacts) const {
    std::string list;
    for (const Index p : contacts)
      list += fmt::format("{}{:.6g} of '{}'", list.empty() ? "" : ", ", search_.forces[p] / search_.part, name(p));
    throw ModelError(fmt::format(
        "the preloads at t = {:.6g} cannot all be reached: {}; one force passes through these contacts, so that only "
        "one of them can be given a preload",
        search_.time, list));
  }
  /// Preloads whose forces answer to all interferences as that of one contact does.
  std::vector<Index> in_series(Index which, const Eigen::MatrixXd& stiffness) const {
    std::vector<Index> found;
    for (Index p = 0; p < stiffness.cols(); ++p) {
      const double common = stiffness(p, which) * stiffness(p, which) / (stiffness(p, p) * stiffness(which, which));
      if (p == which || common > 1 - same_force) found.push_back(p);
    }
    return found;
  }
  const std::string& name(Index which) const { return search_.names[static_cast<std::size_t>(which)]; }

  const PreloadSearch& search_;
  Eigen::VectorXd largest_, smallest_;  // of the states on the way
  std::string error_;
};

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
  Eigen::VectorXd present = forces_of(state);
  Failure failure(*this, present);
  const contact::ContactState all_closed = closed(state);
  const Eigen::MatrixXd closed_stiffness = stiffness(all_closed);
  const Eigen::VectorXd stiffest = closed_stiffness.diagonal();
  // Where nothing resists, the stiffness is round-off of that of a single row.
  Eigen::VectorXd of_single_row(forces.size());
  for (Index p = 0; p < forces.size(); ++p) {
    Index row = 0;
    gaps.col(p).cwiseAbs().maxCoeff(&row);
    const Eigen::VectorXd gap = gaps(row, p) * Eigen::VectorXd::Unit(gaps.rows(), row);
    of_single_row[p] = std::abs(gap.dot(change(all_closed, gap)));
  }
  double growth = 1;
  Eigen::MatrixXd broyden;  // empty: not needed, or not known yet
  for (int iteration = 0;; ++iteration) {
    const Eigen::VectorXd missing = forces - present;
    Index worst = 0;
    if (missing.cwiseQuotient(forces).cwiseAbs().maxCoeff(&worst) <= tolerance) return interference;
    for (Index p = 0; p < forces.size(); ++p)
      if (!(stiffest[p] > not_held * of_single_row[p]) && std::abs(missing[p]) > tolerance * forces[p])
        failure.raise_constant(p, present[p]);
    const double far = largest_interference * forces[worst] / stiffest[worst];
    if (iteration == max_iterations || !(std::abs(interference[worst]) < far))
      failure.raise(worst, missing[worst], closed_stiffness);
    const Eigen::MatrixXd tangent = broyden.size() > 0 ? broyden : stiffness(state);
    const bool is_loose = (tangent.diagonal().array() < loosely_held * stiffest.array()).any();
    growth = is_loose ? 2 * growth : 1;
    const Eigen::VectorXd step =
        (is_loose ? growth : 1.0) * linalg::least_squares(is_loose ? closed_stiffness : tangent, missing);
    const double slope = missing.dot(step);
    for (double length = 1;; length /= 2) {
      if (length < min_step) failure.raise(worst, missing[worst], closed_stiffness);
      try {
        state = solve(interference + length * step);
      } catch (const Error& error) {  // too far: a body has lost its contact
        failure.saw(error);
        continue;
      }
      const Eigen::VectorXd reached = forces_of(state);
      if (slope > 0 && (forces - reached).dot(step) < -overshoot * slope) continue;
      if (is_yielding) {
        const Eigen::VectorXd done = length * step, change_of_force = reached - present;
        broyden = tangent + (change_of_force - tangent * done) * done.transpose() / done.squaredNorm();
      }
      interference += length * step;
      present = reached;
      failure.saw(present);
      break;
    }
  }
}

}  // namespace creepcontact::creep
