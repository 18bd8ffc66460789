#include "unbalanced_load.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::contact {
namespace {

constexpr double balance_round_off = 1e-9;
constexpr int max_changes = 1000;

/// Pressures on the rows of the set that come nearest to balancing the resultants.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& rigid, const std::vector<int>& set,
                              const Eigen::VectorXd& resultant) {
  const Eigen::MatrixXd columns = rigid(set, Eigen::all).transpose();
  return linalg::least_squares(columns, -resultant);
}

}  // namespace

void throw_if_unbalanced(const ContactProblem& problem, const ContactLoad& load) {
  const Eigen::VectorXd& resultant = load.resultant;
  const double size = resultant.norm(), rounding = resultant_rounding(load);
  if (size <= rounding) return;
  const Index n = problem.n_rows();
  Eigen::VectorXd multiplier = Eigen::VectorXd::Zero(n);
  std::vector<int> set;
  for (int i = 0; i < n; ++i)
    if (problem.node(i).set == AdmissibleSet::space && !load.is_idle(i)) set.push_back(i);
  const auto is_tied = [&](int i) { return problem.node(i).set == AdmissibleSet::space; };

  for (int change = 0; change < max_changes; ++change) {
    // Within the set, up to the first pressure that would turn into tension.
    while (!set.empty()) {
      const Eigen::VectorXd wanted = least_squares(problem.rigid, set, resultant);
      double step = 1;
      int blocking = -1;
      for (std::size_t k = 0; k < set.size(); ++k) {
        const double now = multiplier[set[k]], then = wanted[k];
        if (is_tied(set[k]) || then >= 0 || now - then <= 0 || now / (now - then) >= step) continue;
        step = now / (now - then);
        blocking = static_cast<int>(k);
      }
      for (std::size_t k = 0; k < set.size(); ++k) multiplier[set[k]] += step * (wanted[k] - multiplier[set[k]]);
      if (blocking < 0) break;
      multiplier[set[blocking]] = 0;
      set.erase(set.begin() + blocking);
    }
    const Eigen::VectorXd left = problem.rigid.transpose() * multiplier + resultant;
    if (left.norm() <= std::max(balance_round_off * size, rounding)) return;
    // A row that the remaining motion would close takes the load.
    const Eigen::VectorXd opening = problem.rigid * left;
    int entering = -1;
    double most = -balance_round_off * problem.rigid.rowwise().norm().maxCoeff() * left.norm();
    for (int i = 0; i < n; ++i)
      if (!is_tied(i) && opening[i] < most && std::find(set.begin(), set.end(), i) == set.end()) {
        most = opening[i];
        entering = i;
      }
    if (entering < 0) throw UnbalancedLoad{left / left.cwiseAbs().maxCoeff(), 0};
    set.push_back(entering);
  }
}

}  // namespace creepcontact::contact
