#include <algorithm>

#include "creepcontact/contact/frozen_system.hpp"
#include "schwarz_sweeps.hpp"

namespace creepcontact::contact {

SchwarzGradients::SchwarzGradients(const ContactProblem& problem, const SchwarzOptions& options,
                                   std::vector<int> active)
    : options_(options), active_(std::move(active)), total_(problem.total(active_, active_)) {
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const Flexibility& body = problem.bodies[b];
    Block block;
    std::vector<int> own;  // rows within the body's flexibility
    for (std::size_t k = 0; k < active_.size(); ++k) {
      if (problem.slave_body[static_cast<std::size_t>(active_[k])] != static_cast<int>(b)) continue;
      block.places.push_back(static_cast<int>(k));
      own.push_back(
          static_cast<int>(std::lower_bound(body.rows.begin(), body.rows.end(), active_[k]) - body.rows.begin()));
    }
    if (own.empty()) continue;
    block.factor.compute(body.matrix(own, own));
    // A slave held in part has no stiffness of its own to invert: the total's diagonal serves.
    if (block.factor.info() != Eigen::Success || block.factor.rcond() < 1e-10)
      block.inverse_diagonal = total_.diagonal()(block.places).cwiseInverse();
    blocks_.push_back(std::move(block));
  }
}

Eigen::VectorXd SchwarzGradients::precondition(const Eigen::VectorXd& residual) const {
  Eigen::VectorXd z(residual.size());
  for (const Block& block : blocks_) {
    const Eigen::VectorXd part = residual(block.places);
    const Eigen::VectorXd image = block.inverse_diagonal.size() > 0
                                      ? Eigen::VectorXd(part.cwiseProduct(block.inverse_diagonal))
                                      : Eigen::VectorXd(block.factor.solve(part));
    z(block.places) = image;
  }
  return z;
}

SweepResult SchwarzGradients::solve(const Eigen::VectorXd& gap, const Eigen::VectorXd& start) const {
  SweepResult result{start, 0, active_.empty()};
  if (result.converged) return result;
  Eigen::VectorXd residual = -gap - total_ * result.multiplier;
  Eigen::VectorXd z = precondition(residual);  // about the error of the multipliers
  Eigen::VectorXd direction = z;
  double rz = residual.dot(z);
  const double first = result.multiplier.cwiseAbs().maxCoeff() > 0 ? 0.0 : z.cwiseAbs().maxCoeff();
  while (true) {
    const double scale = std::max(first, result.multiplier.cwiseAbs().maxCoeff());
    if (z.cwiseAbs().maxCoeff() <= options_.tolerance * scale) {
      result.converged = true;
      return result;
    }
    if (result.iterations >= options_.max_iterations || !(rz > 0)) return result;
    const Eigen::VectorXd image = total_ * direction;
    const double step = rz / direction.dot(image);
    result.multiplier += step * direction;
    residual -= step * image;
    z = precondition(residual);
    const double next = residual.dot(z);
    direction = z + (next / rz) * direction;
    rz = next;
    ++result.iterations;
  }
}

}  // namespace creepcontact::contact
