#include "friction_splitting.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/linalg/dense_products.hpp"

namespace creepcontact::contact {
namespace {

constexpr double weakest_motion_of_splitting = 1e-12;  // of the best held motion: below it a motion is free

}  // namespace

FrictionSplitting::FrictionSplitting(const FrictionRows& rows, double scale)
    : rows_(rows), weight_(rows.problem().n_rows()), fixing_flexibility_(fixing_flexibility(rows.problem())) {
  const ContactProblem& problem = rows.problem();
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const ContactNode& node = problem.nodes[i];
    for (int row = node.first_row; row < node.first_row + node.n_rows; ++row) {
      const bool is_tangential = node.set == AdmissibleSet::cone && row > node.first_row && rows.tangents(i).n > 0;
      weight_[row] = scale * (is_tangential ? rows.tangents(i).flexibility : rows.flexibility(row));
    }
  }
  Eigen::MatrixXd matrix = problem.flexibility();
  if (problem.compliance.size() > 0) matrix.diagonal() += problem.compliance;
  matrix.diagonal() += weight_;
  if (problem.n_motions() > 0) matrix.noalias() += fixing_flexibility_ * problem.rigid * problem.rigid.transpose();
  factor_.compute(matrix);
  if (problem.n_motions() == 0) return;
  motions_ = factor_.solve(problem.rigid);
  coarse_inverse_ = linalg::symmetric_pseudo_inverse(Eigen::MatrixXd(problem.rigid.transpose() * motions_),
                                                     weakest_motion_of_splitting);
}

Eigen::VectorXd FrictionSplitting::projected(const ContactLoad& load, Eigen::VectorXd multiplier) const {
  const ContactProblem& problem = rows_.problem();
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const ContactNode& node = problem.nodes[i];
    const bool is_idle = load.is_idle(node.first_row);
    for (int row = node.first_row; row < node.first_row + node.n_rows; ++row)
      if (is_idle || !rows_.is_movable(row)) multiplier[row] = 0;
    if (is_idle || node.set == AdmissibleSet::space) continue;
    double& pressure = multiplier[node.first_row];
    pressure = std::max(0.0, pressure);
    const FrictionRows::Tangents& tangential = rows_.tangents(i);
    if (tangential.n == 0) continue;
    const double bound = load.friction.coefficient[static_cast<Index>(i)] * pressure;
    const double size = tangential.of(multiplier).norm();
    for (int k = 0; k < tangential.n && size > bound; ++k) multiplier[tangential.rows[k]] *= bound / size;
  }
  return multiplier;
}

void FrictionSplitting::iterate(const ContactLoad& load, double tolerance, int max_iterations,
                                const std::function<void(int, double)>& record, FrictionState& state) const {
  const ContactProblem& problem = rows_.problem();
  const Index n_motions = problem.n_motions();
  Eigen::VectorXd& z = state.multiplier;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(z.size()), x = z;
  const Eigen::VectorXd resultant =
      load.resultant.size() > 0 ? load.resultant : Eigen::VectorXd(Eigen::VectorXd::Zero(n_motions));
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    Eigen::VectorXd right = weight_.cwiseProduct(z - u) - load.gap;
    // With N^T x = -resultant, c N N^T x is known.
    if (n_motions > 0) right.noalias() -= fixing_flexibility_ * problem.rigid * resultant;
    x = linalg::solution(factor_.matrixLLT(), right);
    if (n_motions > 0) {
      state.rigid = coarse_inverse_ * (problem.rigid.transpose() * x + resultant);
      x.noalias() -= motions_ * state.rigid;
    }
    Eigen::VectorXd next = projected(load, x + u);
    u += x - next;
    const double change = std::max((next - z).cwiseAbs().maxCoeff(), (x - next).cwiseAbs().maxCoeff());
    z = std::move(next);
    const double largest = z.cwiseAbs().maxCoeff();
    record(iteration, largest > 0 ? change / largest : 0.0);
    if (change <= tolerance * largest) break;
  }
  state.image.resize(0);
  state.nodes.clear();
}

}  // namespace creepcontact::contact
