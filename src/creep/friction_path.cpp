#include "friction_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::creep {
namespace {

using contact::ContactStatus;

constexpr double min_change = 1e-9;         // of the largest multiplier: no change of the loads
constexpr double turning_share = 0.1;       // of the tolerance
constexpr double residual_share = 0.3;      // of the tolerance
constexpr double turning_error = 1.0 / 12;  // of the mean direction: slip times squared angle
constexpr double energy_tolerance = 1e-3;   // of the energy dissipated so far, or by the step
constexpr double min_pressure = 1e-9;       // of the largest: a status that rounding decides
constexpr double min_flexibility = 1e-14;   // of the largest flexibility
constexpr double safety = 0.9, max_cut = 1.0 / 16, min_cut = 0.5, max_growth = 2;

double total(const std::vector<double>& energies) {
  double sum = 0;
  for (const double energy : energies) sum += std::abs(energy);
  return sum;
}

}  // namespace

/// What the loads of the friction are measured by.
struct FrictionPath::Sizes {
  double limit = 0;  ///< largest limit of a shear traction
  double slip = 0;   ///< largest accumulated slip, or what the limits move elastically
};

struct FrictionPath::Change {
  double size = 0;     ///< of limits and shear tractions, relative to the largest limit
  double turning = 0;  ///< relative error of the slip whose direction turns
  bool of_statuses = false;
  bool is_event = false;  ///< what a substep may hide: its slip would not be missed at the end
};

/// Nodes that begin to slip, or turn back, within a substep.
struct FrictionPath::Onsets {
  std::vector<double> energy;  ///< per pair: what the limits at which they do add to that of the end's limit
  double doubt = 0;            ///< of these energies, in which the time of the onset is estimated
};

FrictionPath::FrictionPath(const contact::ContactProblem& problem, const SlipAdvance& slip, const Limits& limits,
                           Course course, Solve solve)
    : slip_(slip),
      limits_(limits),
      course_(std::move(course)),
      solve_(std::move(solve)),
      flexibility_(contact::row_flexibility(problem)) {
  const double most = flexibility_.size() > 0 ? flexibility_.maxCoeff() : 0.0;
  for (double& flexibility : flexibility_)
    if (!(flexibility > min_flexibility * most)) flexibility = most > 0 ? most : 1.0;
}

std::optional<PathPoint> FrictionPath::attempt(const PathPoint& from, double end) {
  unbalanced_.reset();
  contact::ContactLoad load = course_(end);
  const Eigen::VectorXd reference = slip_.reference(from, time(end));
  load.gap -= reference;
  load.friction.direction = from.friction.direction;
  try {
    contact::ContactResult found = solve_(load, from.contact, end);
    PathPoint to{std::move(found.state), {}};
    to.friction = slip_.advanced(from, time(end), reference, to.contact, found.gap);
    add_onsets(from, to);
    return to;
  } catch (const SolverError&) {
  } catch (const contact::UnbalancedLoad& unbalanced) {
    unbalanced_ = {unbalanced, time(end)};
  }
  return std::nullopt;
}

bool FrictionPath::nothing_moves(const PathPoint& begin, const PathPoint& end) const {
  if (!limits_.ends.empty()) return false;
  const double largest =
      std::max(begin.contact.multiplier.cwiseAbs().maxCoeff(), end.contact.multiplier.cwiseAbs().maxCoeff());
  const contact::ContactLoad first = course_(0);
  for (const double part : {0.25, 0.5, 0.75, 1.0}) {
    const contact::ContactLoad load = course_(part);
    if (!((load.gap - first.gap).cwiseQuotient(flexibility_).cwiseAbs().maxCoeff() <= min_change * largest))
      return false;
    const Eigen::VectorXd friction = load.friction.coefficient - first.friction.coefficient;
    if (!(friction.cwiseAbs().maxCoeff() <= min_change)) return false;
    if (load.resultant.size() > 0 && !((load.resultant - first.resultant).cwiseAbs().maxCoeff() <=
                                       min_change * first.resultant.cwiseAbs().maxCoeff()))
      return false;
  }
  return true;
}

FrictionPath::Sizes FrictionPath::sizes(const PathPoint& a, const PathPoint& b) const {
  Sizes result;
  std::vector<double> elastic;
  for (const SlipNode& node : slip_.nodes()) {
    double limit = 0;
    for (const PathPoint* point : {&a, &b})
      if (const contact::NodeLinearization& at = node.at(point->contact); at.status != ContactStatus::open)
        limit = std::max(limit, at.friction * point->contact.multiplier[node.normal_row]);
    result.limit = std::max(result.limit, limit);
    if (limit > 0) elastic.push_back(node.tangential(flexibility_).maxCoeff() * limit / node.area);
  }
  if (!elastic.empty()) {
    const auto middle = elastic.begin() + std::ssize(elastic) / 2;
    std::ranges::nth_element(elastic, middle);
    result.slip = *middle;
  }
  for (const PathPoint* point : {&a, &b})
    if (point->friction.path.size() > 0) result.slip = std::max(result.slip, point->friction.path.maxCoeff());
  return result;
}

FrictionPath::Change FrictionPath::change(const PathPoint& from, const PathPoint& to) const {
  Change result;
  const Sizes size = sizes(from, to);
  if (!(size.limit > 0)) return result;
  for (const SlipNode& node : slip_.nodes()) {
    const contact::NodeLinearization &before = node.at(from.contact), &now = node.at(to.contact);
    const bool was_open = before.status == ContactStatus::open, is_open = now.status == ContactStatus::open;
    if (was_open && is_open) continue;
    const double old_limit = was_open ? 0.0 : before.friction * from.contact.multiplier[node.normal_row];
    const double limit = is_open ? 0.0 : now.friction * to.contact.multiplier[node.normal_row];
    const Eigen::VectorXd traction = node.tangential(to.contact.multiplier);
    const double sheared = (traction - node.tangential(from.contact.multiplier)).norm();
    result.size = std::max({result.size, std::abs(limit - old_limit) / size.limit, sheared / size.limit});
    if (std::max(limit, old_limit) <= min_pressure * size.limit) continue;
    result.of_statuses = result.of_statuses || before.status != now.status;
    const bool comes_to_rest = before.status == ContactStatus::slip && now.status == ContactStatus::stick;
    const bool sets_off = node.n > 1 && before.status == ContactStatus::stick && now.status == ContactStatus::slip;
    if (was_open != is_open || comes_to_rest || sets_off) result.is_event = true;
    if (now.status != ContactStatus::slip || before.status != ContactStatus::slip) continue;
    const Eigen::VectorXd old = node.tangential(from.friction.direction);
    const double along = old.dot(node.tangential(to.friction.direction));
    if (along < 0) result.is_event = true;
    if (old.isZero(0) || !(size.slip > 0)) continue;
    const double angle = std::acos(std::clamp(along, -1.0, 1.0));
    const double slid =
        (node.tangential(to.friction.slip) - node.tangential(from.friction.slip)).norm() / node.area / size.slip;
    result.turning = std::max(result.turning, turning_error * slid * angle * angle);
  }
  return result;
}

/// Difference of the end from the solution that a substep from the middle would have.
double FrictionPath::residual(const PathPoint& middle, const PathPoint& end) const {
  const Sizes size = sizes(middle, end);
  if (!(size.limit > 0)) return 0;
  const Eigen::VectorXd reference = slip_.reference(middle, end.friction.time);
  double largest = 0;
  for (const SlipNode& node : slip_.nodes()) {
    const contact::NodeLinearization& at = node.at(end.contact);
    if (at.status == ContactStatus::open) continue;
    const Eigen::VectorXd slip = node.tangential(end.friction.slip) - node.tangential(reference);
    Eigen::VectorXd wrong = slip;
    const double traction = node.tangential(end.contact.multiplier).norm();
    if (at.status == ContactStatus::slip && traction > 0) {
      const Eigen::VectorXd own = node.tangential(end.contact.multiplier) / traction;
      const Eigen::VectorXd before = node.tangential(middle.friction.direction);
      const Eigen::VectorXd mean = (own + std::max(0.0, own.dot(before)) * before).normalized();
      wrong += std::max(0.0, -slip.dot(mean)) * mean;
    }
    // Along what supports hold there is no traction, whatever the slip.
    for (Index k = 0; k < node.n; ++k)
      if (end.contact.multiplier[node.first + k] == 0) wrong[k] = 0;
    const double length = wrong.norm();
    const double limit = at.friction * end.contact.multiplier[node.normal_row];
    const double sheared = std::min(length / node.tangential(flexibility_).maxCoeff(), 2 * limit) / size.limit;
    largest = std::max({largest, size.slip > 0 ? length / node.area / size.slip : 0.0, sheared});
  }
  return largest;
}

double FrictionPath::error(const PathPoint& once, const PathPoint& twice) const {
  const Sizes size = sizes(once, twice);
  if (!(size.limit > 0)) return 0;
  double largest = 0;
  for (const SlipNode& node : slip_.nodes()) {
    const double sheared =
        (node.tangential(once.contact.multiplier) - node.tangential(twice.contact.multiplier)).norm();
    largest = std::max(largest, sheared / size.limit);
    // Slip that is lost before a node opens changes no forces.
    if (node.at(once.contact).status == ContactStatus::open || node.at(twice.contact).status == ContactStatus::open)
      continue;
    const double slip = (node.tangential(once.friction.slip) - node.tangential(twice.friction.slip)).norm() / node.area;
    if (size.slip > 0) largest = std::max(largest, slip / size.slip);
  }
  return largest;
}

PathPoint FrictionPath::again(const PathPoint& from, const PathPoint& to) const {
  const Eigen::VectorXd reference = slip_.reference(from, to.friction.time);
  const Eigen::VectorXd gaps = to.friction.gap - reference;
  PathPoint result{to.contact, slip_.advanced(from, to.friction.time, reference, to.contact, gaps)};
  add_onsets(from, result);
  return result;
}

FrictionPath::Onsets FrictionPath::onsets(const PathPoint& from, const PathPoint& to) const {
  Onsets result;
  result.energy.resize(to.friction.dissipated.size());
  if (from.contact.nodes.empty()) return result;
  for (const SlipNode& node : slip_.nodes()) {
    const contact::NodeLinearization &before = node.at(from.contact), &now = node.at(to.contact);
    if (now.status != ContactStatus::slip || before.status == ContactStatus::open) continue;
    const Eigen::VectorXd traction = node.tangential(to.contact.multiplier);
    const double limit = traction.norm();
    if (!(limit > 0) || node.tangential(from.friction.direction).dot(traction) > 0) continue;
    const double slip = (node.tangential(to.friction.slip) - node.tangential(from.friction.slip)).norm();
    const double old_limit = before.friction * from.contact.multiplier[node.normal_row];
    // The traction passes its limit where the distance from it, linear in time, is zero; where the node stuck until
    // the end, it would exceed the limit by what its slip takes away.
    const double below = std::max(0.0, old_limit - node.tangential(from.contact.multiplier).dot(traction) / limit);
    const double above = slip / node.tangential(flexibility_).maxCoeff();
    if (!(below + above > 0)) continue;
    const double onset = below / (below + above);
    const double change = (limit - old_limit) / 2 * slip;
    result.energy[node.pair] -= (1 - onset) * change;
    result.doubt += onset * (1 - onset) * std::abs(change);
  }
  return result;
}

void FrictionPath::add_onsets(const PathPoint& from, PathPoint& to) const {
  const Onsets found = onsets(from, to);
  for (std::size_t p = 0; p < found.energy.size(); ++p) to.friction.dissipated[p] += found.energy[p];
}

double FrictionPath::energy_error(const PathPoint& from, const PathPoint& middle, const PathPoint& once,
                                  const PathPoint& twice) const {
  double sum = onsets(from, middle).doubt + onsets(middle, twice).doubt;
  for (std::size_t p = 0; p < once.friction.dissipated.size(); ++p)
    sum += std::abs(once.friction.dissipated[p] - twice.friction.dissipated[p]);
  return sum;
}

double FrictionPath::end_of(double at, double size) const {
  const auto next = std::ranges::upper_bound(limits_.ends, at);
  const double last = next != limits_.ends.end() ? *next : 1, rest = last - at;
  if (size >= rest * (1 - min_change)) return last;
  return at + (2 * size > rest ? rest / 2 : size);
}

std::optional<std::vector<PathPoint>> FrictionPath::follow(const PathPoint& begin, const PathPoint& end) {
  begin_ = begin.friction.time;
  end_ = end.friction.time;
  unresolved_ = 0;
  std::vector<PathPoint> points{begin};
  if (nothing_moves(begin, end)) {
    points.push_back(end);
    return points;
  }
  std::optional<PathPoint> trial = end;
  const bool leads_across = !(end_ - begin_ > min_relative_step * std::abs(end_));
  if (leads_across) {  // counted in parts of the step, as no time passes
    begin_ = points.front().friction.time = 0;
    end_ = trial->friction.time = 1;
    points.front().friction.is_fresh = true;
  }
  const double part = leads_across ? 1.0 : limits_.part_of_interval;
  bool is_first = points.front().friction.is_fresh;
  double at = 0, to = 1, size = 1;
  if (!limits_.ends.empty()) trial.reset();
  const auto accept = [&](PathPoint point, double where) {
    points.push_back(std::move(point));
    at = where;
    is_first = false;
  };
  const auto retry = [&](double shorter) {
    size = std::max(shorter, limits_.shortest);
    trial.reset();
  };
  while (at < 1) {
    const PathPoint from = points.back();
    if (!trial) {
      size = std::min(size, limits_.largest / part);
      to = end_of(at, size);
      trial = attempt(from, to);
      if (!trial) {
        if (!(to - at > limits_.shortest)) return std::nullopt;
        retry((to - at) / 2);
        continue;
      }
    }
    const double length = to - at;
    const double energy =
        std::max({total(from.friction.dissipated), total(trial->friction.dissipated), total(end.friction.dissipated)});
    const bool is_shortest = !(length > limits_.shortest);
    const Change changed = change(from, *trial);
    const double extent = std::max(length * part, changed.size);
    const double limit = changed.is_event ? limits_.with_event : limits_.largest;
    if (extent > limit * (1 + min_change) && !is_shortest) {
      retry(length * std::clamp(limit / extent, max_cut, min_cut));
      continue;
    }
    if (!changed.of_statuses && !is_first && changed.turning <= turning_share * limits_.tolerance) {
      accept(*std::exchange(trial, {}), to);
      size = max_growth * length;
      continue;
    }
    const double middle_at = at + length / 2;
    std::optional<PathPoint> middle = attempt(from, middle_at);
    if (!middle) {
      if (is_shortest) return std::nullopt;
      retry(length / 2);
      continue;
    }
    if (residual(*middle, *trial) <= residual_share * limits_.tolerance) {
      // The same state, with what the way through the middle has dissipated.
      PathPoint through = again(*middle, *trial);
      if (energy_error(from, *middle, *trial, through) > energy_tolerance * energy && !is_shortest) {
        trial = std::move(middle);
        to = middle_at;
        continue;
      }
      trial.reset();
      accept(*middle, middle_at);
      accept(std::move(through), to);
      size = max_growth * length;
      continue;
    }
    const std::optional<PathPoint> twice = attempt(*middle, to);
    if (!twice && is_shortest) return std::nullopt;
    const double found = twice ? error(*trial, *twice) : HUGE_VAL;
    const bool loses_energy = twice && energy_error(from, *middle, *trial, *twice) > energy_tolerance * energy;
    if ((found <= limits_.tolerance && !loses_energy) || is_shortest) {
      if (found > limits_.tolerance) unresolved_ = std::max(unresolved_, found);
      accept(*middle, middle_at);
      accept(*twice, to);
      trial.reset();
      size = length * std::clamp(safety * std::sqrt(limits_.tolerance / std::max(found, 1e-300)), min_cut, max_growth);
      continue;
    }
    trial = std::move(middle);
    to = middle_at;
  }
  if (leads_across) {
    points.front() = begin;
    for (std::size_t i = 1; i < points.size(); ++i) points[i].friction.time = end.friction.time;
    points.back().friction.rate.setZero();
    points.back().friction.is_fresh = true;
  }
  return points;
}

}  // namespace creepcontact::creep
