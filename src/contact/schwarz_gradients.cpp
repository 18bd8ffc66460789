#include "schwarz_gradients.hpp"

#include <algorithm>

namespace creepcontact::contact {
namespace {

constexpr double negligible = 1e-6;

}  // namespace

SchwarzGradients::SchwarzGradients(const ContactProblem& problem, const SchwarzOptions& options,
                                   std::vector<int> active)
    : options_(options), set_(problem, std::move(active)) {
  if (problem.large) large_ = problem.large->preconditioner(set_.active());
  for (std::size_t b = 0; b < problem.bodies.size() && !large_; ++b) {
    OwnRows rows = own_rows(problem, b, set_.active(), true);
    if (rows.own.empty()) continue;
    Block block{std::move(rows.places), std::make_unique<DirichletProblem>(problem, b, rows.own)};
    // A slave held in part has no stiffness of its own to invert: the total's diagonal serves.
    if (!block.body->is_regular()) block.body.reset();
    blocks_.push_back(std::move(block));
  }
  const Eigen::MatrixXd& motions = balance().basis();
  if (motions.cols() == 0) return;
  carried_.resize(motions.rows(), motions.cols());
  for (Eigen::Index j = 0; j < motions.cols(); ++j) carried_.col(j) = slave_multipliers(motions.col(j));
  const Eigen::LLT<Eigen::MatrixXd> coarse(motions.transpose() * carried_);
  coarse.matrixU().solveInPlace<Eigen::OnTheRight>(carried_);
}

Eigen::VectorXd SchwarzGradients::slave_multipliers(const Eigen::VectorXd& residual) const {
  if (large_) return large_->multipliers(residual);
  Eigen::VectorXd z(residual.size());
  for (const Block& block : blocks_) {
    const Eigen::VectorXd part = residual(block.places);
    z(block.places) =
        block.body ? block.body->multipliers(part) : Eigen::VectorXd(part.cwiseQuotient(set_.diagonal()(block.places)));
  }
  return z;
}

/// The residual loses its rigid part, which belongs to the motions' amplitudes and would only bring cancellation.
Eigen::VectorXd SchwarzGradients::precondition(Eigen::VectorXd& residual) const {
  if (balance().empty()) return slave_multipliers(residual);
  residual = balance().without_rigid_part(residual);
  Eigen::VectorXd z = slave_multipliers(residual);
  z.noalias() -= carried_ * (carried_.transpose() * residual);
  return z;
}

InnerResult SchwarzGradients::solve(const FrozenLoad& load, const Eigen::VectorXd& start, const InnerLog& log) const {
  InnerResult result{start, 0, set_.active().empty()};
  if (result.converged) return result;
  const bool floating = !balance().empty();
  const auto rebalance = [&] {
    if (floating) result.multiplier -= balance().carrying(balance().unbalanced(result.multiplier, load.resultant));
  };
  rebalance();
  Eigen::VectorXd residual = -load.gap - set_.gaps(result.multiplier);
  Eigen::VectorXd z = precondition(residual);  // about the error of the multipliers
  Eigen::VectorXd direction = z;
  double rz = residual.dot(z);
  // From a start of zero the first step shows the size of the solution; multipliers far below it are none.
  double least = result.multiplier.cwiseAbs().maxCoeff() > 0 ? 0.0 : z.cwiseAbs().maxCoeff();
  while (true) {
    if (result.iterations == 1) least *= negligible;
    const double scale = std::max(least, result.multiplier.cwiseAbs().maxCoeff());
    const double error = z.cwiseAbs().maxCoeff();
    if (result.iterations > 0) log("cg", result.iterations, scale > 0 ? error / scale : 0.0, set_.active().size());
    result.converged = error <= std::max(options_.tolerance * scale, load.rounding);
    if (result.converged || result.iterations >= options_.max_iterations || !(rz > 0)) break;
    const Eigen::VectorXd image = set_.gaps(direction);
    const double step = rz / direction.dot(image);
    result.multiplier += step * direction;
    residual -= step * image;
    z = precondition(residual);
    const double next = residual.dot(z);
    direction = z + (next / rz) * direction;
    rz = next;
    ++result.iterations;
  }
  rebalance();
  return result;
}

}  // namespace creepcontact::contact
