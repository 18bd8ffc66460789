#include "creepcontact/contact/geometry/equation_rows.hpp"

#include <algorithm>

namespace creepcontact::contact {
namespace {

double largest_coefficient(const LinearEquation& equation) {
  double largest = 0;
  for (const auto* terms : {&equation.slave, &equation.master})
    for (const EquationTerm& term : *terms) largest = std::max(largest, term.coefficient.cwiseAbs().maxCoeff());
  return largest;
}

RowMatrix rows(const std::vector<Eigen::Triplet<double>>& entries, std::size_t n_rows, std::size_t n_nodes) {
  RowMatrix matrix(static_cast<Eigen::Index>(n_rows), static_cast<Eigen::Index>(3 * n_nodes));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

MortarCoupling equation_rows(const TiedBody& slave, const TiedBody& master, std::span<const LinearEquation> equations,
                             double area) {
  MortarCoupling result;
  result.type = ContactType::tied;
  std::vector<Eigen::Triplet<double>> of_slave, of_master;
  for (std::size_t row = 0; row < equations.size(); ++row) {
    const LinearEquation& equation = equations[row];
    const double factor = area / largest_coefficient(equation);
    const auto add = [&](const std::vector<EquationTerm>& terms, std::vector<Eigen::Triplet<double>>& to) {
      for (const EquationTerm& term : terms)
        for (int k = 0; k < 3; ++k)
          if (term.coefficient[k] != 0)
            to.emplace_back(static_cast<int>(row), 3 * static_cast<int>(term.node) + k, factor * term.coefficient[k]);
    };
    add(equation.slave, of_slave);
    add(equation.master, of_master);
    result.nodes.push_back({equation.slave.front().node, equation.slave.front().coefficient.normalized()});
    result.area.push_back(area);
  }
  result.slave_rows = rows(of_slave, equations.size(), slave.mesh->nodes.size());
  result.master_rows = rows(of_master, equations.size(), master.mesh->nodes.size());
  result.geometric_gap = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(equations.size()));
  return result;
}

Eigen::VectorXd gap_per_value(std::span<const LinearEquation> equations, double area) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(equations.size()));
  for (std::size_t row = 0; row < equations.size(); ++row)
    result[static_cast<Eigen::Index>(row)] = -area / largest_coefficient(equations[row]);
  return result;
}

}  // namespace creepcontact::contact
