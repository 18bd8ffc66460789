#pragma once
/// Direct solver of the Newton systems (I - gamma J) z = r of the creep rate. MaterialTangent eliminates the state
/// point by point; K_tan du = integral B^T D e with K_tan = integral B^T D B is left, with the active contacts closed.
/// Bodies that do not creep enter with the flexibility that the elasticity knows of them: where their stiffness changes
/// in time, that is wrong by Model::refactor_change at most, and the Newton iteration converges linearly.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/tangent_interface.hpp"
#include "creepcontact/simulation/contact_elasticity.hpp"
#include "creepcontact/simulation/material_tangent.hpp"
#include "creepcontact/simulation/state_layout.hpp"

namespace creepcontact::simulation {

class TangentSystem {
 public:
  /// @param elasticity, points (one a body), layout and watch must outlive the object
  /// Memory: of every body that creeps a second factor, second interface matrices, and stride (stride + 6) + 36 numbers
  /// a point.
  TangentSystem(const ContactElasticity& elasticity, const std::vector<MaterialPoints>& points,
                const StateLayout& layout, Stopwatch& watch);

  /// Factors the system at the last equilibrium of the elasticity.
  /// @throws ode::RecoverableError if a tangent stiffness is not positive definite
  /// Cost: an assembly, a factorisation and a condensation of every body that creeps.
  void prepare(double gamma, std::span<const double> y);
  /// z of the system last prepared, but with the contact set of the elasticity's last equilibrium: where contact grows,
  /// an iteration with the set of some steps before would not converge. Cost: as an elastic solve.
  /// @throws ode::RecoverableError if the contact rows contradict each other
  void solve(std::span<const double> r, std::span<double> z);

  std::int64_t solves() const { return solves_; }
  std::int64_t factorizations() const { return factorizations_; }

 private:
  struct Side {
    std::optional<MaterialTangent> material;  // of a body that creeps; an elastic one has nothing here
    std::optional<linalg::SupernodalCholesky> factor;
    std::vector<double> stress, strain;                 // n_points x 6: D e, B du
    std::vector<double> displacement, no_displacement;  // 3 n_nodes
    std::vector<double> free;                           // n_free
  };
  void factorize(std::size_t body);
  /// work(number, side, body) for every body that creeps.
  template <typename Work>
  void for_each_side(const Work& work);
  template <typename Pass>
  void pass_through_factors(const Pass& pass);
  /// @returns gaps without contact forces
  Eigen::VectorXd forward(std::span<const double> r);
  contact::ContactState close(const Eigen::VectorXd& gap);
  void backward(const contact::ContactState& change);

  const ContactElasticity& elasticity_;
  const StateLayout& layout_;
  Stopwatch& watch_;
  std::vector<Side> sides_;
  std::unique_ptr<contact::TangentInterface> interface_;
  std::int64_t solves_ = 0, factorizations_ = 0;
};

}  // namespace creepcontact::simulation
