#include "projected_cg.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>

#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

constexpr double clearly_softer = 2;
constexpr double negligible = 1e-6;

}  // namespace

ProjectedCg::ProjectedCg(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active)
    : options_(options), set_(problem, std::move(active)) {
  if (problem.large) large_ = problem.large->preconditioner(set_.active(), problem.compliance_on(set_.active()));
  if (!large_) add_blocks(problem);
  const Eigen::MatrixXd& motions = balance().basis();
  if (motions.cols() == 0) return;
  carried_.resize(motions.rows(), motions.cols());
  for (Index j = 0; j < motions.cols(); ++j) carried_.col(j) = softer_multipliers(motions.col(j));
  const Eigen::LLT<Eigen::MatrixXd> coarse(motions.transpose() * carried_);
  coarse.matrixU().solveInPlace<Eigen::OnTheRight>(carried_);
}

bool ProjectedCg::add_block(const ContactProblem& problem, std::size_t body, std::vector<int>& positions) {
  if (positions.empty()) return true;
  const std::vector<int>& rows = problem.of_bodies()[body].rows;
  std::vector<int> own, in_set;
  for (const int position : positions) {
    const int row = set_.active()[position];
    in_set.push_back(row);
    own.push_back(static_cast<int>(std::lower_bound(rows.begin(), rows.end(), row) - rows.begin()));
  }
  auto dirichlet = std::make_unique<DirichletProblem>(problem, body, own, problem.compliance_on(in_set),
                                                      DirichletProblem::IfSingular::nothing);
  if (!dirichlet->is_regular()) return false;
  blocks_.push_back({std::move(positions), std::move(dirichlet)});
  positions.clear();
  return true;
}

void ProjectedCg::add_blocks(const ContactProblem& problem) {
  std::map<std::pair<int, int>, std::vector<int>> pairs;  // slave and master body: places
  for (std::size_t k = 0; k < set_.active().size(); ++k) {
    const ContactNode& node = problem.node(set_.active()[k]);
    pairs[{node.slave_body, node.master_body}].push_back(static_cast<int>(k));
  }
  std::vector<std::vector<int>> of_slave(problem.of_bodies().size());
  for (auto& [pair, positions] : pairs) {
    const std::size_t slave = pair.first, master = pair.second;
    const bool master_is_softer =
        flexibility_on(problem, master, positions) > clearly_softer * flexibility_on(problem, slave, positions);
    if (master_is_softer && add_block(problem, master, positions)) continue;
    of_slave[slave].insert(of_slave[slave].end(), positions.begin(), positions.end());
  }
  for (std::size_t b = 0; b < problem.of_bodies().size(); ++b) {
    std::sort(of_slave[b].begin(), of_slave[b].end());
    // A slave held in part has no stiffness of its own to invert.
    if (!add_block(problem, b, of_slave[b])) loose_.insert(loose_.end(), of_slave[b].begin(), of_slave[b].end());
  }
}

double ProjectedCg::flexibility_on(const ContactProblem& problem, std::size_t body,
                                   const std::vector<int>& positions) const {
  const std::vector<int>& rows = problem.of_bodies()[body].rows;
  double sum = 0;
  for (const int position : positions) {
    const auto found = std::lower_bound(rows.begin(), rows.end(), set_.active()[position]);
    const auto own = found - rows.begin();
    sum += problem.of_bodies()[body].matrix(own, own);
  }
  return sum;
}

Eigen::VectorXd ProjectedCg::softer_multipliers(const Eigen::VectorXd& residual) const {
  if (large_) return large_->multipliers(residual);
  Eigen::VectorXd z(residual.size());
  z(loose_) = residual(loose_).cwiseQuotient(set_.diagonal()(loose_));
  for (const Block& block : blocks_) z(block.positions) = block.body->multipliers(residual(block.positions));
  return z;
}

/// The residual loses its rigid part, which belongs to the motions' amplitudes and would only bring cancellation.
Eigen::VectorXd ProjectedCg::precondition(Eigen::VectorXd& residual) const {
  if (balance().empty()) return softer_multipliers(residual);
  residual = balance().without_rigid_part(residual);
  Eigen::VectorXd z = softer_multipliers(residual);
  z.noalias() -= carried_ * (carried_.transpose() * residual);
  return z;
}

InnerResult ProjectedCg::solve(const ActiveSetLoad& load, const Eigen::VectorXd& start, const InnerLog& log) const {
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
