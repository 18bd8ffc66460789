#include "creepcontact/contact/tangent_interface.hpp"

namespace creepcontact::contact {

TangentInterface::TangentInterface(const CondensedInterface& interface,
                                   std::span<const linalg::StiffnessSolver* const> factors, double elastic_scale)
    : interface_(interface),
      condensed_(factors.size()),
      problem_(ContactProblem::with_nodes_of(interface.problem())),
      active_set_(problem_) {
  const ContactProblem& elastic = interface.problem();
  problem_.rigid = elastic.rigid;
  problem_.total.setZero(n_rows(), n_rows());
  for (std::size_t b = 0; b < factors.size(); ++b) {
    const std::vector<int>& rows = interface.rows()[b].rows;
    if (rows.empty()) continue;
    if (factors[b] != nullptr) {
      condensed_[b] =
          CondensedRows(interface.rows()[b].reduced, interface.rows()[b].trailing, *factors[b], elastic.has_friction());
      problem_.total(rows, rows) += condensed_[b].take_flexibility();
    } else {
      problem_.total(rows, rows) += elastic_scale * elastic.bodies[b].matrix;
    }
  }
}

void TangentInterface::add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const {
  const std::vector<int>& rows = interface_.rows()[body].rows;
  if (!rows.empty()) gap(rows) += condensed_[body].gaps(y);
}

ContactState TangentInterface::close(const ContactState& at, const Eigen::VectorXd& gap) {
  // Factors of elastic flexibilities are of no use here.
  return active_set_.solve_change({{}, {}, at.active, at.nodes, {}, {}, {}, at.compliance}, gap);
}

void TangentInterface::add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const {
  const std::vector<int>& rows = interface_.rows()[body].rows;
  if (!rows.empty()) condensed_[body].add_forces(multiplier(rows), y);
}

}  // namespace creepcontact::contact
