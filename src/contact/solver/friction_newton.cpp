#include "friction_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

constexpr double sufficient_decrease = 1e-4;  // Armijo: part of the predicted decrease
constexpr double min_step = 1.0 / 1024;       // part of a Newton step
constexpr double linear_tolerance = 1e-9;
constexpr double residual_share = 0.01;      // of the tolerance: errors of multipliers are larger than those of gaps
constexpr double round_off = 1e-14;          // of the largest multiplier
constexpr double balance_of_polish = 1e-11;  // of the forces that make up a resultant
constexpr double min_bound = 1e-14;          // of x_t: a projection onto a point
constexpr double newton_progress = 0.95;     // of the least residual so far

}  // namespace

/// The residual and the linear equations at some multipliers.
struct FrictionNewton::Trial {
  Eigen::VectorXd residual;
  Linearization at;
};

FrictionNewton::Trial FrictionNewton::trial(const ContactLoad& load, bool mean, const Options& options,
                                            const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap) const {
  const FrictionRows& rows = system_.rows();
  const ContactProblem& problem = rows.problem();
  Trial result{multiplier, Linearization(problem.nodes.size())};
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const ContactNode& own = problem.nodes[i];
    NodeLinearization& at = result.at[i];
    if (load.is_idle(own.first_row)) continue;  // open
    if (own.set == AdmissibleSet::space) {
      at.status = ContactStatus::stick;
      for (int row = own.first_row; row < own.first_row + own.n_rows; ++row)
        if (rows.is_movable(row)) result.residual[row] = gap[row] / rows.flexibility(row);
      continue;
    }
    const int normal = own.first_row;
    const double x_n = multiplier[normal] - options.normal_scale * gap[normal] / rows.flexibility(normal);
    if (!rows.is_movable(normal) || !(x_n > 0)) continue;  // open
    at.status = ContactStatus::stick;
    result.residual[normal] = multiplier[normal] - x_n;
    const bool is_frozen = options.bound.size() > 0;
    const double mu =
        is_frozen || own.set != AdmissibleSet::cone ? 0.0 : load.friction.coefficient[static_cast<Index>(i)];
    at.friction = mu;
    const FrictionRows::Tangents& tangential = rows.tangents(i);
    if (tangential.n == 0) continue;  // on two planes of symmetry: it sticks
    const double r = options.tangential_scale / tangential.flexibility;
    const Eigen::Vector2d tau = tangential.of(multiplier), v = tangential.of(gap),
                          before = direction_before(load, tangential);
    const double bound = is_frozen ? options.bound[static_cast<Index>(i)] : mu * x_n;
    const Eigen::Vector2d x = tau - r * v;
    const double size = x.norm();
    Eigen::Vector2d residual = r * v;
    if (size > bound) {
      at.status = ContactStatus::slip;
      if (mean && tangential.n == 2 && !before.isZero(0) && tau.norm() > min_bound * size) {
        const double traction = tau.norm();
        const Eigen::Vector2d e = tau / traction, m = turned(e);
        const double along = std::max(0.0, e.dot(before));
        const Eigen::Vector2d c = e + along * before;
        const Eigen::Vector2d change = along > 0 ? Eigen::Vector2d(m + before.dot(m) * before) : m;  // of c, as e turns
        at.direction = e;
        at.equation = turned(c) / c.norm();
        at.flexibility = std::max(0.0, turned(change).dot(v) / (traction * c.norm()));
        residual = (traction - bound) * e + r * at.equation.dot(v) * m;
      } else {
        const double part = std::max(bound / size, min_bound);
        at.direction = x / size;
        at.equation = turned(at.direction);
        at.flexibility = (1 - part) / (part * r);
        residual = tau - bound * at.direction;
      }
    }
    for (int k = 0; k < tangential.n; ++k) result.residual[tangential.rows[k]] = residual[tangential.components[k]];
  }
  return result;
}

Linearization FrictionNewton::linearization(const ContactLoad& load, const Eigen::VectorXd& multiplier,
                                            const Eigen::VectorXd& gap) const {
  return trial(load, true, {}, multiplier, gap).at;
}

Eigen::VectorXd FrictionNewton::right(const Linearization& at, const Eigen::VectorXd& multiplier,
                                      const Eigen::VectorXd& gap, const Eigen::VectorXd& bound) const {
  const FrictionRows& rows = system_.rows();
  Eigen::VectorXd right = -rows.equations(at, multiplier, gap, bound);
  // Round-off in equations without F would cost a product with F.
  const double least = multiplier.size() > 0 ? round_off * multiplier.cwiseAbs().maxCoeff() : 0.0;
  for (int row = 0; row < std::ssize(right); ++row)
    if (std::abs(right[row]) <= least * rows.flexibility(row)) right[row] = 0;
  return right;
}

bool FrictionNewton::search(const ContactLoad& load, const Linearization& factored, const Options& options,
                            FrictionState& state) const {
  const FrictionRows& rows = system_.rows();
  const ContactProblem& problem = rows.problem();
  Eigen::VectorXd& multiplier = state.multiplier;
  Eigen::VectorXd& image = state.image;
  if (image.size() == 0) image = flexibility_product(problem, multiplier);
  // What is unbalanced first: its parts cancel.
  const auto gaps = [&](const Eigen::VectorXd& of, const Eigen::VectorXd& its_image) {
    Eigen::VectorXd gap = load.gap + its_image;
    if (rows.spring() > 0)
      gap += problem.rigid * (state.rigid + unbalanced(problem.rigid, of, load.resultant) / rows.spring());
    return gap;
  };
  Eigen::VectorXd gap = gaps(multiplier, image);
  Trial current = trial(load, false, options, multiplier, gap);
  for (int iteration = 0;; ++iteration) {
    const double largest = multiplier.size() > 0 ? multiplier.cwiseAbs().maxCoeff() : 0.0;
    const double error = multiplier.size() > 0 ? current.residual.cwiseAbs().maxCoeff() : 0.0;
    state.nodes = current.at;
    record_(iteration, largest > 0 ? error / largest : 0.0, current.at);
    const bool is_small = error <= std::max(options.tolerance * largest, options.rounding);
    if (is_small && iteration >= options.min_iterations) return true;
    if (iteration >= options.max_iterations || !std::isfinite(error)) return false;
    const Eigen::VectorXd step =
        system_.solve_held(current.at, factored, right(current.at, multiplier, gap, options.bound), linear_tolerance)
            .multiplier;
    const Eigen::VectorXd image_change = flexibility_product(problem, step);
    ++state.iterations;
    const double size = current.residual.norm();
    for (double length = 1;; length /= 2) {
      const Eigen::VectorXd to = multiplier + length * step, to_image = image + length * image_change;
      const Eigen::VectorXd to_gap = gaps(to, to_image);
      Trial next = trial(load, false, options, to, to_gap);
      const double to_size = next.residual.norm();
      const bool good = is_small || to_size <= (1 - sufficient_decrease * length) * size;
      if (!good && length > min_step) continue;
      if (!good && !(to_size < size)) return false;
      multiplier = to;
      image = to_image;
      gap = to_gap;
      current = std::move(next);
      break;
    }
  }
}

bool FrictionNewton::polish(const ContactLoad& load, const Linearization& factored, const Options& options, bool mean,
                            FrictionState& state) const {
  const ContactProblem& problem = system_.rows().problem();
  Eigen::VectorXd& multiplier = state.multiplier;
  if (multiplier.size() == 0) return true;
  if (state.image.size() == 0) state.image = flexibility_product(problem, multiplier);
  Eigen::VectorXd gap = gaps_of(problem, load, state);
  if (state.nodes.empty()) state.nodes = trial(load, mean, options, multiplier, gap).at;
  // Of a state: the residual, with the multipliers that would carry what is unbalanced.
  const auto size_of = [&](const Trial& at, const Eigen::VectorXd& its) {
    double square = at.residual.squaredNorm();
    const Eigen::VectorXd left = unbalanced(problem.rigid, its, load.resultant);
    for (Index j = 0; j < left.size(); ++j)
      if (const double motion = problem.rigid.col(j).squaredNorm(); motion > 0) square += left[j] * left[j] / motion;
    return std::sqrt(square);
  };
  double least = std::numeric_limits<double>::infinity(), size = least;
  int idle = 0;
  for (int iteration = 0; iteration < options.max_iterations && idle < options.patience; ++iteration) {
    const FrictionSystem::Solution step =
        system_.solve(state.nodes, factored, right(state.nodes, multiplier, gap),
                      Eigen::VectorXd(-unbalanced(problem.rigid, multiplier, load.resultant)), linear_tolerance);
    const Eigen::VectorXd image_change = flexibility_product(problem, step.multiplier);
    state.linear_iterations = step.iterations;
    ++state.iterations;
    Trial now;
    const FrictionState from = state;
    for (double length = 1;; length /= 2) {
      multiplier = from.multiplier + length * step.multiplier;
      if (problem.n_motions() > 0) state.rigid = from.rigid + length * step.rigid;
      state.image = from.image + length * image_change;
      gap = gaps_of(problem, load, state);
      now = trial(load, mean, options, multiplier, gap);
      if (!options.damped) break;
      const double reached = size_of(now, multiplier);
      if (iteration == 0 || reached <= (1 - sufficient_decrease * length) * size) {
        size = reached;
        break;
      }
      if (length <= min_step) return false;
    }
    state.nodes = std::move(now.at);
    const double largest = multiplier.cwiseAbs().maxCoeff(), error = now.residual.cwiseAbs().maxCoeff();
    record_(iteration, largest > 0 ? error / largest : 0.0, state.nodes);
    if (!std::isfinite(error)) return false;
    idle = largest > 0 && error < newton_progress * least * largest ? 0 : idle + 1;
    if (largest > 0) least = std::min(least, error / largest);
    if (error <= std::max(residual_share * options.tolerance * largest, options.rounding) &&
        is_balanced(problem.rigid, multiplier, load.resultant, balance_of_polish, options.rounding))
      return true;
  }
  return false;
}

Eigen::Vector2d direction_before(const ContactLoad& load, const FrictionRows::Tangents& tangential) {
  const Eigen::VectorXd& all = load.friction.direction;
  return all.size() > 0 ? tangential.of(all) : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

Eigen::VectorXd gaps_of(const ContactProblem& problem, const ContactLoad& load, const FrictionState& state) {
  Eigen::VectorXd gap = load.gap + state.image;
  if (problem.n_motions() > 0) gap += problem.rigid * state.rigid;
  return gap;
}

}  // namespace creepcontact::contact
