#pragma once
/// Newton systems (I - gamma J) z = r of the creep rate, solved directly: every point's own part is eliminated
/// (MaterialTangent), what is left is an elastic-like problem of all bodies with the tangent stiffness, in which the
/// rows in contact stay closed.

#include <memory>
#include <optional>
#include <vector>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/contact/tangent_interface.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/creep/material_tangent.hpp"
#include "creepcontact/creep/state_layout.hpp"

namespace creepcontact::creep {

class TangentSystem {
 public:
  /// @param solver (with dense contact), points (one per body), layout and watch must outlive the object
  /// Memory: of every body that creeps a second factor, second interface matrices, and stride (stride + 6) + 36 numbers
  /// per point.
  TangentSystem(const EquilibriumSolver& solver, const std::vector<MaterialPoints>& points, const StateLayout& layout,
                Stopwatch& watch);

  /// Factors the system.
  /// @param at  one per body @param stiffness_scale  that of the equilibrium
  /// @throws RecoverableError if a tangent stiffness is not positive definite
  /// Cost: an assembly, a factorisation and a condensation of every body that creeps.
  void prepare(double gamma, std::span<const PointsState> at, double stiffness_scale);
  /// z of the system last prepared, but with this contact set: where contact grows, an iteration with the set of some
  /// steps before would not converge. Cost: as an elastic solve.
  /// @throws RecoverableError if the contact rows contradict each other
  void solve(const std::vector<int>& active, std::span<const double> r, std::span<double> z);

  std::int64_t solves() const { return solves_; }
  std::int64_t factorizations() const { return factorizations_; }

 private:
  struct Side {
    std::optional<MaterialTangent> material;  // of a body that creeps; an elastic one has nothing here
    std::unique_ptr<linalg::StiffnessSolver> factor;
    std::vector<double> stress, strain;                 // n_points x 6: D e, B du
    std::vector<double> displacement, no_displacement;  // 3 n_nodes
    std::vector<double> free;                           // n_free
  };
  void factorize(std::size_t body);
  /// work(number, side, body) for every body that creeps.
  template <typename Work>
  void for_each_side(const Work& work);

  const EquilibriumSolver& solver_;
  const StateLayout& layout_;
  Stopwatch& watch_;
  std::vector<Side> sides_;
  std::unique_ptr<contact::TangentInterface> interface_;
  std::int64_t solves_ = 0, factorizations_ = 0;
};

}  // namespace creepcontact::creep
