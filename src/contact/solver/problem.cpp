#include "creepcontact/contact/solver/problem.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "creepcontact/linalg/dense_products.hpp"

namespace creepcontact::contact {
namespace {

constexpr double min_change = 1e-12;
constexpr double rounding_of_gaps = 1e-13;
constexpr double rounding_of_forces = 1e-12;
constexpr double immovable_flexibility =
    1e-14;                             // rows that neither body can move along (held on both sides) carry no multiplier
constexpr double fixing_floor = 1e-2;  // of the flexibility of fixing dofs

/// Rows need more than this to be movable.
double min_flexibility(const Eigen::VectorXd& flexibility) {
  return flexibility.size() > 0 ? immovable_flexibility * flexibility.maxCoeff() : 0.0;
}

}  // namespace

bool ContactProblem::has_friction() const {
  return std::ranges::any_of(nodes, [](const ContactNode& node) { return node.set == AdmissibleSet::cone; });
}

bool ContactProblem::has_gaskets() const {
  return std::ranges::any_of(nodes, [](const ContactNode& node) { return node.has_gasket(); });
}

Eigen::VectorXd ContactProblem::compliance_on(const std::vector<int>& rows) const {
  if (compliance.size() == 0) return Eigen::VectorXd::Zero(std::ssize(rows));
  return compliance(rows);
}

void ContactProblem::add_node(AdmissibleSet set, int n_rows, int slave_body, int master_body) {
  nodes.push_back({set, static_cast<int>(node_of_row.size()), n_rows, slave_body, master_body});
  node_of_row.insert(node_of_row.end(), n_rows, static_cast<int>(nodes.size()) - 1);
}

ContactProblem ContactProblem::with_nodes_of(const ContactProblem& other) {
  ContactProblem result;
  result.nodes = other.nodes;
  result.node_of_row = other.node_of_row;
  return result;
}

ContactProblem ContactProblem::with_compliance(const ContactProblem& owner, Eigen::VectorXd compliance) {
  ContactProblem result = with_nodes_of(owner);
  result.large = owner.large;
  result.rigid = owner.rigid;
  result.rigid_of_body = owner.rigid_of_body;
  result.compliance = std::move(compliance);
  result.owner = &owner;
  return result;
}

Eigen::VectorXd flexibility_product(const ContactProblem& problem, const Eigen::VectorXd& multiplier) {
  Eigen::VectorXd gaps =
      problem.large ? problem.large->gaps(multiplier) : linalg::symmetric_product(problem.flexibility(), multiplier);
  if (problem.compliance.size() > 0) gaps += problem.compliance.cwiseProduct(multiplier);
  return gaps;
}

Eigen::VectorXd flexibility_diagonal(const ContactProblem& problem) {
  Eigen::VectorXd diagonal =
      problem.large ? problem.large->diagonal() : Eigen::VectorXd(problem.flexibility().diagonal());
  if (problem.compliance.size() > 0) diagonal += problem.compliance;
  return diagonal;
}

Eigen::VectorXd contact_gaps(const ContactProblem& problem, const ContactLoad& load, const ContactState& state) {
  Eigen::VectorXd gap = load.gap + flexibility_product(problem, state.multiplier);
  if (problem.n_motions() > 0) gap += problem.rigid * state.rigid;
  return gap;
}

double fixing_flexibility(const ContactProblem& problem) {
  const double square = problem.rigid.squaredNorm();
  return square > 0 ? flexibility_diagonal(problem).sum() / square : 0.0;
}

Eigen::VectorXd row_flexibility(const ContactProblem& problem) {
  Eigen::VectorXd flexibility = flexibility_diagonal(problem);
  if (problem.n_motions() > 0)
    flexibility =
        flexibility.cwiseMax(fixing_floor * fixing_flexibility(problem) * problem.rigid.rowwise().squaredNorm());
  return flexibility;
}

std::vector<int> immovable_rows(const ContactProblem& problem) {
  const Eigen::VectorXd flexibility = row_flexibility(problem);
  const double least = min_flexibility(flexibility);
  std::vector<int> rows;
  for (int i = 0; i < problem.n_rows(); ++i) {
    const bool gives_way = problem.node(i).has_gasket() && i == problem.node(i).first_row;
    if (!(flexibility[i] > least) && !gives_way) rows.push_back(i);
  }
  return rows;
}

double multiplier_rounding(const ContactProblem& problem, const ContactLoad& load) {
  const Eigen::VectorXd flexibility = row_flexibility(problem);
  const double least = min_flexibility(flexibility);
  double largest = 0;
  for (int i = 0; i < problem.n_rows(); ++i)
    if (flexibility[i] > least) largest = std::max(largest, std::abs(load.gap[i]) / flexibility[i]);
  double rounding = rounding_of_gaps * largest;
  for (Index j = 0; j < load.force.size(); ++j)
    if (const double carried = problem.rigid.col(j).cwiseAbs().sum(); carried > 0)
      rounding = std::max(rounding, rounding_of_forces * load.force[j] / carried);
  return rounding;
}

double resultant_rounding(const ContactLoad& load) {
  return load.force.size() > 0 ? rounding_of_forces * load.force.maxCoeff() : 0.0;
}

std::vector<int> updated_set(const ContactProblem& problem, const ContactLoad& load, const std::vector<int>& current,
                             const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap, double rounding) {
  const double largest = problem.n_rows() > 0 ? multiplier.cwiseAbs().maxCoeff() : 0.0;
  const double no_matter = std::max(min_change * largest, rounding);
  const Eigen::VectorXd flexibility = row_flexibility(problem);
  const double least = min_flexibility(flexibility);
  std::vector<int> next;
  auto it = current.begin();
  for (int i = 0; i < problem.n_rows(); ++i) {
    const bool was_active = it != current.end() && *it == i;
    if (was_active) ++it;
    const ContactNode& node = problem.node(i);
    const bool is_tangential = node.set == AdmissibleSet::cone && i > node.first_row;
    if (!(flexibility[i] > least) || is_tangential || load.is_idle(i)) continue;
    const double indicator = multiplier[i] - gap[i] / flexibility[i];
    const double threshold = was_active ? -no_matter : no_matter;
    if (node.set == AdmissibleSet::space || indicator > threshold) next.push_back(i);
  }
  return next;
}

std::vector<int> first_set(const ContactProblem& problem, const ContactLoad& load, const ContactState& warm) {
  if (warm.multiplier.size() != problem.n_rows() || problem.n_rows() == 0)
    return updated_set(problem, load, {}, Eigen::VectorXd::Zero(problem.n_rows()), load.gap, 0.0);
  if (load.idle.empty()) return warm.active;
  // The tied rows that act may have changed since.
  const std::vector<int> tied =
      updated_set(problem, load, {}, Eigen::VectorXd::Zero(problem.n_rows()),
                  Eigen::VectorXd::Constant(problem.n_rows(), std::numeric_limits<double>::infinity()), 0.0);
  std::vector<int> unilateral = warm.active, result;
  std::erase_if(unilateral, [&](int row) { return problem.node(row).set == AdmissibleSet::space; });
  std::ranges::set_union(unilateral, tied, std::back_inserter(result));
  return result;
}

}  // namespace creepcontact::contact
