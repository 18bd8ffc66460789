#include "creepcontact/contact/solver/friction_uniqueness.hpp"

#include "creepcontact/contact/solver/active_set_system.hpp"
#include "friction_system.hpp"

namespace creepcontact::contact {

std::optional<double> friction_kappa(const ContactProblem& problem, const Friction& friction, const ContactState& at) {
  if (problem.large != nullptr || at.nodes.empty()) return std::nullopt;
  const FrictionRows rows(problem);
  std::vector<int> normal, tangential;  // rows
  std::vector<int> cones, first;        // nodes in contact with friction; their place in `normal`
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const ContactNode& node = problem.nodes[i];
    if (at.nodes[i].status == ContactStatus::open) continue;
    if (node.set == AdmissibleSet::cone) {
      cones.push_back(static_cast<int>(i));
      first.push_back(static_cast<int>(normal.size()));
      for (int k = 0; k < rows.tangents(i).n; ++k) tangential.push_back(rows.tangents(i).rows[k]);
    }
    for (int k = 0; k < node.n_closed(); ++k)
      if (rows.is_movable(node.first_row + k)) normal.push_back(node.first_row + k);
  }
  if (tangential.empty()) return std::nullopt;
  Eigen::MatrixXd pressing = problem.flexibility()(normal, normal), change = problem.flexibility()(normal, tangential);
  pressing.diagonal() += problem.compliance_on(normal);
  if (rows.spring() > 0) {
    const Eigen::MatrixXd rigid = problem.rigid(normal, Eigen::all);
    pressing.noalias() += rigid * rigid.transpose() / rows.spring();
    change.noalias() += rigid * problem.rigid(tangential, Eigen::all).transpose() / rows.spring();
  }
  Eigen::LLT<Eigen::MatrixXd> factor;
  if (!factor_semidefinite(pressing, factor)) return std::nullopt;
  factor.solveInPlace(change);
  Eigen::MatrixXd influence(cones.size(), cones.size());
  Index column = 0;
  for (std::size_t j = 0; j < cones.size(); ++j) {
    const int n = rows.tangents(cones[j]).n;
    for (std::size_t i = 0; i < cones.size(); ++i)
      influence(static_cast<Index>(i), static_cast<Index>(j)) =
          friction.coefficient[cones[j]] * change.block(first[i], column, 1, n).norm();
    column += n;
  }
  constexpr int iterations = 100;
  Eigen::VectorXd vector = Eigen::VectorXd::Ones(influence.cols());
  double kappa = 0;
  for (int k = 0; k < iterations; ++k) {
    const Eigen::VectorXd image = influence * vector;
    kappa = image.norm() / vector.norm();
    if (!(kappa > 0)) return 0.0;
    vector = image / image.norm();
  }
  return kappa;
}

}  // namespace creepcontact::contact
