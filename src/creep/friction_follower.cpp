#include "friction_follower.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "contact_broadcast.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "friction_path.hpp"
#include "stiffness_change.hpp"
#include "vector_views.hpp"

namespace creepcontact::creep {
namespace {

constexpr double max_deviation = 1e-9;  // of the loads
constexpr double max_tolerance = 1e-3,
                 min_tolerance = 1e-5;  // tolerances: below, substeps become many for what events leave
// Where the flexibility is an operator, a substep costs tens of elastic solves.
constexpr double max_substep_with_operator = 1.0 / 2, event_substep_with_operator = 1.0 / 8;

/// Loads at one time, without creep. Forces are those on the stiffness of the factors that move it as far.
struct LoadsAt {
  std::vector<std::vector<double>> forces;  // of this process
  Eigen::VectorXd gap, work;
  double force = 0;  // sum of the absolute external forces, the scale of the work
};

/// a - (1 - part) b - part c
Eigen::VectorXd off_the_line(double part, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                             const Eigen::VectorXd& c) {
  return a - (1 - part) * b - part * c;
}

/// Where a coefficient of friction changes abruptly: parts of an interval, just before and just after.
std::vector<double> abrupt_changes(const std::function<Eigen::VectorXd(double part)>& coefficient) {
  constexpr int samples = 64, halvings = 24;
  constexpr double min_jump = 0.1;  // of the larger one
  std::vector<double> ends;
  const auto differ = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a - b).cwiseAbs().maxCoeff() > min_jump * std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  };
  Eigen::VectorXd last = coefficient(0);
  for (int k = 1; k <= samples; ++k) {
    double before = double(k - 1) / samples, after = double(k) / samples;
    Eigen::VectorXd low = last, high = coefficient(after);
    last = high;
    if (!differ(low, high)) continue;
    for (int halving = 0; halving < halvings; ++halving) {
      const double middle = (before + after) / 2;
      const Eigen::VectorXd value = coefficient(middle);
      const bool is_first = differ(low, value);
      (is_first ? after : before) = middle;
      (is_first ? high : low) = value;
      if (!differ(low, high)) break;  // steep, and no jump
    }
    ends.insert(ends.end(), {before, after});
  }
  std::erase_if(ends, [](double part) { return !(part > 0 && part < 1); });
  return ends;
}

}  // namespace

FrictionFollower::FrictionFollower(const Assembly& assembly, const contact::CondensedInterface& interface,
                                   const SlipAdvance& slip, AddTraces add_traces, SolveContact solve_contact,
                                   Stopwatch& watch)
    : assembly_(assembly),
      interface_(interface),
      slip_(slip),
      add_traces_(std::move(add_traces)),
      solve_contact_(std::move(solve_contact)),
      watch_(watch),
      stiffness_changes_(stiffness_changes(assembly)) {}

LoadCourse FrictionFollower::load_course(double begin, double end, const Equilibrium& at, double tolerance,
                                         double multiplier) {
  std::vector<mechanics::BodyConditions> conditions = at.conditions;
  const auto loads_at = [&](double t) {
    const auto lap = watch_.lap(Part::material);
    assembly_.update(t, conditions);
    LoadsAt loads;
    const double stiffness_scale = stiffness_changes_ ? stiffness_change(assembly_, interface_, conditions).scale : 1.0;
    contact::InterfaceLoad interface_load = interface_.rows().initial_load(t, conditions);
    for (std::size_t b = 0; b < assembly_.bodies().size(); ++b) {
      loads.forces.emplace_back(assembly_.bodies()[b].constraints().n_free());
      assembly_.bodies()[b].right_hand_side(conditions[b], {}, loads.forces[b]);
      assembly_.bodies()[b].clear_fixing_dofs(loads.forces[b]);
      vector(loads.forces[b]) /= stiffness_scale;
      interface_.rows().add_resultant(b, conditions[b], interface_load);
    }
    loads.gap = interface_load.gap;
    loads.work = interface_load.work;
    assembly_.team().sum({loads.work.data(), static_cast<std::size_t>(loads.work.size())});
    loads.force = assembly_.team().sum(interface_load.force.size() > 0 ? interface_load.force.maxCoeff() : 0.0);
    return loads;
  };
  const LoadsAt first = loads_at(begin), last = loads_at(end);
  const auto time = [&](double part) { return begin + part * (end - begin); };
  const auto forces_off = [&](double part, const LoadsAt& loads, std::size_t b) {
    return Eigen::VectorXd(vector(loads.forces[b]) - (1 - part) * vector(first.forces[b]) -
                           part * vector(last.forces[b]));
  };
  const auto is_off = [&](double part) {
    const LoadsAt loads = loads_at(time(part));
    double off = 0, size = 0;
    for (std::size_t b = 0; b < assembly_.bodies().size(); ++b) {
      off += forces_off(part, loads, b).squaredNorm();
      size += vector(loads.forces[b]).squaredNorm() + vector(first.forces[b]).squaredNorm() +
              vector(last.forces[b]).squaredNorm();
    }
    off = assembly_.team().sum(off);
    size = assembly_.team().sum(size);
    const auto is_small = [](double deviation, double of) { return deviation <= max_deviation * of; };
    return !is_small(std::sqrt(off), std::sqrt(size)) ||
           !is_small(off_the_line(part, loads.gap, first.gap, last.gap).norm(),
                     loads.gap.norm() + first.gap.norm() + last.gap.norm()) ||
           !is_small(off_the_line(part, loads.work, first.work, last.work).norm(),
                     loads.force + first.force + last.force);
  };
  if (!is_off(0.25) && !is_off(0.5) && !is_off(0.75)) return {};

  const contact::ContactProblem& problem = interface_.problem();
  const Eigen::MatrixXd& held = interface_.rows().rigid_body_modes().held();
  const LoadCourse::Deviation none{Eigen::VectorXd::Zero(problem.n_rows()), Eigen::VectorXd::Zero(problem.n_motions())};
  double largest = multiplier, force = std::max(first.force, last.force);
  Eigen::VectorXd flexibility;
  if (interface_.flexibility().is_here()) flexibility = contact::row_flexibility(problem);
  const auto deviation = [&](double part) {
    LoadsAt loads = loads_at(time(part));
    LoadCourse::Deviation result = none;
    result.gap = off_the_line(part, loads.gap, first.gap, last.gap);
    for (std::size_t b = 0; b < assembly_.bodies().size(); ++b) vector(loads.forces[b]) = forces_off(part, loads, b);
    add_traces_(loads.forces, result.gap);
    ++counters_.elastic_solves;
    force = std::max(force, loads.force);
    if (problem.n_motions() > 0)
      result.resultant = held.transpose() * off_the_line(part, loads.work, first.work, last.work);
    for (Index row = 0; row < flexibility.size(); ++row)
      if (flexibility[row] > 0) largest = std::max(largest, std::abs(result.gap[row]) / flexibility[row]);
    return result;
  };
  const double friction = std::min(1.0, interface_.rows().friction(end).coefficient.maxCoeff());
  const auto is_near = [&](const LoadCourse::Deviation& a, const LoadCourse::Deviation& b) {
    bool far = false;
    for (Index row = 0; row < flexibility.size(); ++row)
      far = far || (flexibility[row] > 0 &&
                    std::abs(a.gap[row] - b.gap[row]) > tolerance * flexibility[row] * friction * largest);
    far = far || (problem.n_motions() > 0 &&
                  (a.resultant - b.resultant).norm() > tolerance * held.cwiseAbs().maxCoeff() * force);
    return !assembly_.team().any(far);
  };
  return {none, deviation, is_near};
}

double FrictionFollower::longest_step(double t, double end) const {
  constexpr double never = std::numeric_limits<double>::infinity(), max_change = 0.01;
  if (!stiffness_changes_ || !interface_.problem().has_friction() || !(end > t)) return never;
  std::vector<mechanics::BodyConditions> conditions;
  const auto stiffness_at = [&](double time) {
    assembly_.update(time, conditions);
    std::vector<double> low, high;
    for (std::size_t b = 0; b < assembly_.bodies().size(); ++b) {
      const auto [least, largest] = interface_.factored(b).stiffness_ratio(conditions[b]);
      low.push_back(least);
      high.push_back(largest);
    }
    assembly_.team().min(low);
    assembly_.team().max(high);
    low.insert(low.end(), high.begin(), high.end());
    return low;
  };
  const std::vector<double> now = stiffness_at(t);
  const auto changes_little = [&](double step) {
    const std::vector<double> then = stiffness_at(t + step);
    for (std::size_t i = 0; i < now.size(); ++i)
      if (std::abs(then[i] - now[i]) > max_change * std::abs(now[i])) return false;
    return true;
  };
  double step = end - t;
  const double shortest = step / 1024;  // where it jumps, or nearly so
  while (step > shortest && !(changes_little(step) && changes_little(step / 2))) step /= 2;
  return step < end - t ? step : never;
}

std::vector<PathPoint> FrictionFollower::follow(const Equilibrium& at, const History& history,
                                                const PathOptions& options) {
  if (history.friction.slip.size() == 0) return {};
  const PathPoint begin{history.contact, history.friction}, end{at.contact, at.friction};
  std::vector<PathPoint> points{begin, end};
  const double from = begin.friction.time, to = end.friction.time;
  if (begin.friction.gap.size() == 0 || begin.contact.multiplier.size() == 0 || begin.contact.nodes.empty() ||
      to < from)
    return points;
  const double tolerance = std::clamp(options.tolerance, min_tolerance, max_tolerance);
  const double largest =
      std::max(begin.contact.multiplier.cwiseAbs().maxCoeff(), end.contact.multiplier.cwiseAbs().maxCoeff());
  LoadCourse course;
  const bool passes = to - from > min_relative_step * std::abs(to);
  // The interference of a preload was found for this very step.
  if (!passes && history.preloaded_until > from) return points;
  FrictionPath::Limits limits;
  if (passes) {
    course = load_course(from, to, at, tolerance, largest);
    if (interface_.flexibility().is_here())
      limits.ends = abrupt_changes(
          [&](double part) { return interface_.rows().friction(from + part * (to - from)).coefficient; });
  }
  limits.tolerance = tolerance;
  if (options.interval > 0) limits.part_of_interval = std::min(1.0, (to - from) / options.interval);
  const contact::ContactProblem& problem = interface_.problem();
  if (problem.large != nullptr) {
    limits.largest = max_substep_with_operator;
    limits.with_event = event_substep_with_operator;
  }
  // Of the stiffness, at equal parts of the step.
  std::vector<double> scales(stiffness_changes_ ? 5 : 1, at.stiffness_scale);
  if (stiffness_changes_) {
    std::vector<mechanics::BodyConditions> conditions = at.conditions;
    for (std::size_t k = 0; k + 1 < scales.size(); ++k) {
      assembly_.update(from + static_cast<double>(k) / static_cast<double>(scales.size() - 1) * (to - from),
                       conditions);
      scales[k] = stiffness_change(assembly_, interface_, conditions).scale;
    }
  }
  const auto scale = [&scales](double part) {
    const double place = part * static_cast<double>(scales.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(place), scales.size() - 1),
                      next = std::min(k + 1, scales.size() - 1);
    return scales[k] + (place - static_cast<double>(k)) * (scales[next] - scales[k]);
  };
  std::vector<double> work{0, 0};  // contact solves, iterations
  double unresolved = 0;
  bool has_end = true;
  std::optional<contact::SlidingOff> sliding;  // which no team can agree on
  const auto lap = watch_.lap(Part::contact);
  together(assembly_.team(), [&] {
    if (!interface_.flexibility().is_here()) return;
    // Gaps and resultants of the loads are those that the states at both ends are in equilibrium with.
    const auto without_multipliers = [&](const PathPoint& point, const Eigen::VectorXd& image) {
      Eigen::VectorXd gap = point.friction.gap - image;
      if (problem.n_motions() > 0) gap -= problem.rigid * point.contact.rigid;
      return gap;
    };
    const auto image_of = [&](const contact::ContactState& state, bool is_of_these_factors) {
      if (is_of_these_factors && state.image.size() > 0) return state.image;
      return contact::flexibility_product(problem, state.multiplier / scales.front());
    };
    const Eigen::VectorXd first_gap = without_multipliers(begin, image_of(begin.contact, !stiffness_changes_));
    const Eigen::VectorXd last_gap = without_multipliers(end, image_of(end.contact, true));
    const auto loads = [&](double part) {
      const double t = from + part * (to - from);
      contact::ContactLoad load;
      load.gap = (1 - part) * first_gap + part * last_gap;
      if (problem.n_motions() > 0)
        load.resultant = -problem.rigid.transpose() *
                         ((1 - part) * begin.contact.multiplier + part * end.contact.multiplier) / scale(part);
      load.friction = interface_.rows().friction(t);
      load.idle = contact::idle_rows(interface_.pairs(), t);
      load.curves = interface_.rows().gasket_curves(t, history.gaskets.largest);
      for (contact::ClosureCurve& curve : load.curves) curve.scale(1 / scale(part));
      if (!course.is_straight()) {
        const LoadCourse::Deviation off = course.at(part);
        load.gap += off.gap;
        if (problem.n_motions() > 0) load.resultant += off.resultant / scale(part);
      }
      return load;
    };
    const auto solve = [&](const contact::ContactLoad& load, const contact::ContactState& last, double part) {
      contact::ContactState start = last;
      start.multiplier /= scale(part);
      if (stiffness_changes_) start.image.resize(0);
      contact::ContactResult result = solve_contact_(load, start, to);
      result.state.multiplier *= scale(part);
      work[0] += 1;
      work[1] += result.iterations;
      return result;
    };
    FrictionPath path(problem, slip_, limits, loads, solve);
    std::optional<std::vector<PathPoint>> found = path.follow(begin, end);
    has_end = found.has_value();
    unresolved = path.unresolved();
    if (found) {
      points = std::move(*found);
    } else if (path.unbalanced()) {
      try {
        interface_.balance().report(path.unbalanced()->load, path.unbalanced()->time);
      } catch (const contact::SlidingOff& error) {
        sliding = error;
      }
    }
  });
  if (assembly_.team().any(sliding.has_value()))
    throw sliding.value_or(contact::SlidingOff("the loads move the assembly"));
  broadcast(assembly_.team(), points);
  creepcontact::broadcast(assembly_.team(), work, 0);
  counters_.contact_solves += std::llround(work[0]);
  counters_.schwarz_iterations += std::llround(work[1]);
  warn_of_path(from, to, has_end, course.is_resolved(), unresolved / tolerance);
  return points;
}

void FrictionFollower::warn_of_path(double from, double to, bool has_end, bool is_resolved, double error) {
  constexpr double max_error = 10;
  if (assembly_.team().rank() != 0 || warned_ || (has_end && is_resolved && !(error > max_error))) return;
  warned_ = true;
  const char* what = !has_end ? "a state between the ends of the step was not found, and the slip is that of one step"
                     : is_resolved ? "tractions or slip jump there"
                                   : "the loads change too fast there to be followed";
  log::warning(
      "friction: the path of the slip from t = {:.6g} to {:.6g} is less accurate than time.tolerance: {}. List the "
      "times at which loads or friction change abruptly in time.breakpoints; kappa above 1 (docs/friction.md) also "
      "does this",
      from, to, what);
}

}  // namespace creepcontact::creep
