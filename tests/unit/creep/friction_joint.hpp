#pragma once
/// Condensed contact with friction, without a mesh, and loads that change from one state to another.

#include <Eigen/Dense>
#include <memory>
#include <random>
#include <vector>

#include "../../../src/creep/slip_advance.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"

namespace creepcontact::creep::friction_joints {

/// Nodes with friction on two bodies that are held.
struct Joint {
  contact::ContactProblem problem;
  std::vector<contact::Pair> pairs;
  std::unique_ptr<contact::ContactSolver> solver;
  double mu = 0.4;

  Joint(int n_nodes, int n_tangents, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> number;
    const int rows = n_nodes * (1 + n_tangents);
    for (int i = 0; i < n_nodes; ++i) problem.add_node(contact::AdmissibleSet::cone, 1 + n_tangents, 0, 1);
    Eigen::MatrixXd root(rows, rows);
    for (double& value : root.reshaped()) value = number(generator) / std::sqrt(rows);
    const Eigen::MatrixXd coupled = root * root.transpose();
    problem.total = Eigen::MatrixXd::Identity(rows, rows) + 0.5 * coupled;
    problem.bodies.resize(1);
    for (int row = 0; row < rows; ++row) problem.bodies[0].rows.push_back(row);
    problem.bodies[0].matrix = problem.total;
    problem.rigid.resize(rows, 0);
    contact::Pair pair;
    pair.coupling.nodes.resize(static_cast<std::size_t>(n_nodes));
    pair.coupling.tangents.resize(static_cast<std::size_t>(n_nodes));
    pair.coupling.area.assign(static_cast<std::size_t>(n_nodes), 1.0);
    pairs.push_back(pair);
    solver = contact::friction_solver(problem, {});
  }

  contact::ContactLoad load(Eigen::VectorXd gap) const {
    contact::ContactLoad result{std::move(gap), {}};
    result.friction.coefficient.setConstant(std::ssize(problem.nodes), mu);
    return result;
  }

  PathPoint at_rest(const Eigen::VectorXd& gap) const {
    const SlipAdvance slip(problem, pairs);
    PathPoint nothing;
    SlipHistory& friction = nothing.friction;
    friction.slip.setZero(gap.size());
    friction.direction.setZero(gap.size());
    friction.rate.setZero(gap.size());
    friction.path.setZero(std::ssize(problem.nodes));
    friction.dissipated = {0};
    return next(slip, nothing, gap, 0);
  }

  PathPoint next(const SlipAdvance& slip, const PathPoint& from, const Eigen::VectorXd& gap, double t) const {
    contact::ContactLoad now = load(gap);
    const Eigen::VectorXd reference = slip.reference(from, t);
    now.gap -= reference;
    now.friction.direction = from.friction.direction;
    const contact::ContactResult found = solver->solve(now, from.contact);
    return {found.state, slip.advanced(from, t, reference, found.state, found.gap)};
  }
};

/// Loads that press and shear at random, changed from one state to another.
struct Loads {
  Eigen::VectorXd first, last;

  Loads(const Joint& joint, unsigned seed) {
    std::mt19937 generator(seed + 100);
    std::uniform_real_distribution<double> number(-1, 1);
    for (Eigen::VectorXd* gap : {&first, &last}) {
      gap->resize(joint.problem.n_rows());
      for (double& value : *gap) value = number(generator);
      for (const contact::ContactNode& node : joint.problem.nodes)
        (*gap)[node.first_row] = -0.6 + 0.8 * (*gap)[node.first_row];
    }
  }
  Eigen::VectorXd at(double part) const { return (1 - part) * first + part * last; }
};

}  // namespace creepcontact::creep::friction_joints
