#include "unit/contact/problems.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/index.hpp"

namespace creepcontact::test {

Eigen::MatrixXd random_flexibility(int n, std::mt19937& generator, double scale) {
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd half = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(generator); });
  // Like a surface's flexibility: diagonally strong, all entries of one family.
  return scale * (half * half.transpose() / n + Eigen::MatrixXd::Identity(n, n));
}

ContactProblem chain(int n_pairs, int rows_per_pair, double stiffness_ratio, std::mt19937& generator, int n_floating) {
  ContactProblem problem;
  const int n = n_pairs * rows_per_pair;
  problem.total.setZero(n, n);
  problem.rigid.setZero(n, Index{2} * n_floating);
  for (int b = 0; b <= n_pairs; ++b) {
    contact::Flexibility body;
    for (int r = std::max(b - 1, 0) * rows_per_pair; r < std::min(b + 1, n_pairs) * rows_per_pair; ++r)
      body.rows.push_back(r);
    const int n_rows = static_cast<int>(body.rows.size());
    body.matrix = random_flexibility(n_rows, generator, b % 2 == 0 ? 1.0 : 1 / stiffness_ratio);
    problem.total(body.rows, body.rows) += body.matrix;
    // Translation across the joints and rotation: moving towards the first body closes its one side, opens the other.
    Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(n_rows, problem.rigid.cols());
    if (const Index floating = b - (n_pairs + 1 - n_floating); floating >= 0)
      for (Index k = 0; k < n_rows; ++k) {
        const double side = body.rows[k] / rows_per_pair < b ? 1.0 : -1.0;
        rigid(k, 2 * floating) = side;
        rigid(k, 2 * floating + 1) = side * (2.0 * static_cast<double>(k % rows_per_pair) / (rows_per_pair - 1) - 1.0);
      }
    problem.rigid(body.rows, Eigen::all) += rigid;
    problem.rigid_of_body.push_back(std::move(rigid));
    problem.bodies.push_back(std::move(body));
  }
  for (int r = 0; r < n; ++r)
    problem.add_node(contact::AdmissibleSet::half_line, 1, r / rows_per_pair, r / rows_per_pair + 1);
  return problem;
}

void expect_on_curve(const contact::ContactNode& node, const contact::ClosureCurve& curve, double gap, double pressure,
                     double error) {
  const double closure = -gap / node.gasket_area;
  // Where the curve is steep a small error of the closure is a large one of the pressure.
  const contact::ClosureCurve::Line line = curve.line(closure);
  EXPECT_NEAR(curve.pressure(closure), pressure, error * std::max(1.0, line.slope));
}

ContactLoad add_gaskets(ContactProblem& problem, std::mt19937& generator, double stiffness, double share) {
  std::uniform_real_distribution<double> uniform;
  ContactLoad load;
  for (contact::ContactNode& node : problem.nodes) {
    load.curves.emplace_back();
    if (node.set == contact::AdmissibleSet::space || uniform(generator) >= share) continue;
    node.gasket_area = 0.5 + uniform(generator);
    std::vector<Eigen::Vector2d> points{{uniform(generator) - 0.5, 0}};
    for (int k = 0; k < 6; ++k)
      points.emplace_back(points.back().x() + 0.05 + 0.3 * uniform(generator),
                          points.back().y() + stiffness * std::pow(10, 2 * uniform(generator) - 1));
    load.curves.back() = contact::ClosureCurve(std::move(points));
  }
  return load;
}

void expect_solved(const ContactProblem& problem, const ContactLoad& load, const ContactState& state,
                   double tolerance) {
  const Eigen::VectorXd& multiplier = state.multiplier;
  const Eigen::VectorXd gap = contact_gaps(problem, load, state);
  const double rounding = contact::multiplier_rounding(problem, load);
  const double error = tolerance * multiplier.cwiseAbs().maxCoeff() + rounding;
  const Eigen::VectorXd flexibility = contact::row_flexibility(problem);
  for (int i = 0; i < problem.n_rows(); ++i) {
    const double opening = gap[i] / flexibility[i];
    if (problem.node(i).has_gasket())
      expect_on_curve(problem.node(i), load.curves[static_cast<std::size_t>(problem.node_of_row[i])], gap[i],
                      multiplier[i], error);
    else if (problem.node(i).set == contact::AdmissibleSet::space)
      EXPECT_NEAR(opening, 0, error);
    else
      EXPECT_NEAR(std::min(multiplier[i], opening), 0, error);
  }
  if (problem.n_motions() > 0) {
    const Eigen::VectorXd left = problem.rigid.transpose() * multiplier + load.resultant;
    EXPECT_LE(left.cwiseAbs().maxCoeff(),
              tolerance * multiplier.cwiseAbs().sum() + rounding * static_cast<double>(problem.n_rows()));
  }
}

ContactProblem frictional(int n_nodes, int n_tangents, double coupling, std::mt19937& generator, bool floating) {
  ContactProblem problem;
  const int width = 1 + n_tangents, n = width * n_nodes;
  for (int i = 0; i < n_nodes; ++i) problem.add_node(contact::AdmissibleSet::cone, width, 0, 1);
  problem.total.setZero(n, n);
  for (int b = 0; b < 2; ++b) {
    Eigen::MatrixXd matrix = random_flexibility(n, generator, 1.0);
    for (int r = 0; r < n; ++r)
      for (int c = 0; c < n; ++c)
        if (r % width != c % width && (r % width == 0 || c % width == 0)) matrix(r, c) *= coupling;
    contact::Flexibility body;
    for (int r = 0; r < n; ++r) body.rows.push_back(r);
    body.matrix = matrix;
    problem.total += matrix;
    problem.bodies.push_back(std::move(body));
  }
  problem.rigid.setZero(n, floating ? width : 0);
  for (int r = 0; r < n && floating; ++r) problem.rigid(r, r % width) = 1;
  problem.rigid_of_body = {Eigen::MatrixXd::Zero(n, problem.rigid.cols()), problem.rigid};
  return problem;
}

void expect_friction_solved(const ContactProblem& problem, const ContactLoad& load, const ContactState& state,
                            double tolerance) {
  const Eigen::VectorXd gap = contact_gaps(problem, load, state);
  const double error = tolerance * state.multiplier.cwiseAbs().maxCoeff() + contact::multiplier_rounding(problem, load);
  const Eigen::VectorXd flexibility = contact::row_flexibility(problem);
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const contact::ContactNode& node = problem.nodes[i];
    if (node.set == contact::AdmissibleSet::space) {
      for (int row = node.first_row; row < node.first_row + node.n_rows; ++row)
        EXPECT_NEAR(gap[row] / flexibility[row], 0, error);
      continue;
    }
    const int normal = node.first_row;
    if (node.has_gasket()) expect_on_curve(node, load.curves[i], gap[normal], state.multiplier[normal], error);
    std::vector<int> tangential;  // along which the node can move
    for (int row = normal + 1; row < normal + node.n_rows; ++row)
      if (flexibility[row] > 1e-13 * flexibility.maxCoeff()) tangential.push_back(row);
    if (!(flexibility[normal] > 1e-13 * flexibility.maxCoeff())) continue;  // held on both sides
    if (!node.has_gasket()) {
      EXPECT_NEAR(std::min(state.multiplier[normal], gap[normal] / flexibility[normal]), 0, error);
    }
    if (tangential.empty()) continue;
    const Eigen::VectorXd tau = state.multiplier(tangential);
    const Eigen::VectorXd slip = gap(tangential) / flexibility(tangential).mean();
    const double bound = load.friction.coefficient[static_cast<Index>(i)] * state.multiplier[normal];
    EXPECT_LE(tau.norm(), bound + error);
    if (node.has_gasket() ? state.multiplier[normal] <= error : gap[normal] / flexibility[normal] > error)
      continue;  // open: free to slide
    if (tau.norm() < bound - error) {
      EXPECT_LE(slip.norm(), error);
    }
    if (slip.norm() <= 10 * error || tau.norm() <= 10 * error) continue;
    EXPECT_NEAR(tau.norm(), bound, error);
    Eigen::VectorXd along = tau.normalized();
    if (load.friction.direction.size() > 0 && tau.size() == 2) {
      const Eigen::VectorXd before = load.friction.direction.segment(normal + 1, 2);
      along += std::max(0.0, along.dot(before)) * before;
      along.normalize();
    }
    EXPECT_LT(along.dot(slip), 0);
    EXPECT_LE((slip - along.dot(slip) * along).norm(), error);
  }
  if (problem.n_motions() > 0) {
    const Eigen::VectorXd left = problem.rigid.transpose() * state.multiplier + load.resultant;
    EXPECT_LE(left.cwiseAbs().maxCoeff(),
              tolerance * state.multiplier.cwiseAbs().sum() +
                  contact::multiplier_rounding(problem, load) * static_cast<double>(problem.n_rows()));
  }
}

}  // namespace creepcontact::test
