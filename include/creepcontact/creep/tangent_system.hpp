#pragma once
/// Direct solution of the Newton systems (I - gamma J) z = r of the creep rate. The point-wise parts are eliminated
/// (MaterialTangent). An elastic problem of all bodies remains, with the tangent stiffness, in which closed contacts
/// stay closed.

#include <memory>
#include <optional>
#include <vector>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/tangent_interface.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/creep/material_tangent.hpp"
#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

class GasketCreep;

/// One object per CreepSystem; holds the last factorisation. Use from one thread at a time.
class TangentSystem {
 public:
  /// @param solver (with dense contact), points (one per body), gaskets, layout, watch  must outlive the object
  /// Memory per body that creeps: a second factor, second interface matrices, and stride (stride + 6) + 36 numbers per
  /// point.
  TangentSystem(const EquilibriumSolver& solver, const std::vector<MaterialPoints>& points, const GasketCreep& gaskets,
                const StateLayout& layout, Stopwatch& watch);

  /// Assembles and factors the system.
  /// @param at  one per body @param of_gaskets  GasketCreep::jacobians()
  /// @param stiffness_scale  Equilibrium::stiffness_scale
  /// @throws RecoverableError if a tangent stiffness is not positive definite
  /// Cost: per body that creeps an assembly, a factorisation and a condensation of the contact rows.
  void prepare(double gamma, std::span<const PointsState> at, std::vector<Eigen::MatrixXd> of_gaskets,
               double stiffness_scale);
  /// Solves for z with the system last prepared, but with the closed rows and the friction of this state: with those of
  /// earlier steps, a Newton iteration would not converge where the contact grows. Cost: as an elastic solve.
  /// @param r, z  of size StateLayout::size() @throws RecoverableError if the contact rows contradict each other
  void solve(const contact::ContactState& contact, std::span<const double> r, std::span<double> z);

  /// Work since construction: calls of solve(), and factorisations of single bodies.
  std::int64_t solves() const { return solves_; }
  std::int64_t factorizations() const { return factorizations_; }

 private:
  struct Side {
    std::optional<MaterialTangent> material;  // empty for an elastic body
    std::unique_ptr<linalg::StiffnessSolver> factor;
    std::vector<double> stress, strain;                 // n_points x 6: D e, B du
    std::vector<double> displacement, no_displacement;  // 3 n_nodes
    std::vector<double> free;                           // n_free
  };
  void factorize(std::size_t body);
  /// Calls work(number, side, body) for every body that creeps.
  template <typename Work>
  void for_each_side(const Work& work);

  const EquilibriumSolver& solver_;
  const GasketCreep& gaskets_;
  const StateLayout& layout_;
  Stopwatch& watch_;
  double gamma_ = 0, stiffness_scale_ = 1;
  std::vector<Eigen::MatrixXd> of_gaskets_;
  std::vector<Side> sides_;
  std::unique_ptr<contact::TangentInterface> interface_;
  std::int64_t solves_ = 0, factorizations_ = 0;
};

}  // namespace creepcontact::creep
