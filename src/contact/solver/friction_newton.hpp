#pragma once
/// Semismooth Newton method for contact with friction.

#include <functional>

#include "creepcontact/contact/solver/iteration_recorder.hpp"
#include "friction_system.hpp"
#include "rigid_balance.hpp"

namespace creepcontact::contact {

/// A trial state, and what the iterations towards it took.
struct FrictionState {
  Eigen::VectorXd multiplier;
  Eigen::VectorXd rigid;      // amplitudes of the rigid-body modes
  Eigen::VectorXd image;      // F multiplier; empty: not known
  Linearization nodes;        // empty: not known
  int iterations = 0;         // Newton
  int linear_iterations = 0;  // GMRES, of the last Newton iteration
};

/// Newton's method on the residual of Alart and Curnier (1991),
///   lambda_n - max(0, x_n),   lambda_t - P(x_t),   x = lambda - r gap,   P: projection onto |.| <= mu max(0, x_n),
/// with the rotation of the traction's direction in the derivative. Nodes for which Friction::direction is given may
/// instead fulfil, where they slip, |lambda_t| = mu lambda_n with a slip parallel to the mean direction.
class FrictionNewton {
 public:
  struct Options {
    double tolerance = 1e-10;       // of the multipliers, relative to the largest
    double rounding = 0;            // multipliers below it count as zero
    double normal_scale = 1;        // r_n = scale / F_nn
    double tangential_scale = 0.3;  // r_t
    int min_iterations = 0, max_iterations = 50;
    /// polish() ends after so many iterations that do not reduce the least residual so far.
    int patience = 8;
    /// Whether polish() halves a step while the residual does not fall (Armijo).
    bool damped = false;
    /// Per node: the limit of the shear traction instead of mu times the pressure (Tresca's law, which makes the
    /// problem convex); empty: Coulomb's law. In search() only.
    Eigen::VectorXd bound = {};
  };
  using Record = std::function<void(int iteration, double residual, const Linearization&)>;

  FrictionNewton(FrictionSystem& system, Record record) : system_(system), record_(std::move(record)) {}

  /// Solves from any state.multiplier, by Armijo's line search, for bodies that springs hold too: the motions are
  /// state.rigid plus (N^T multiplier + resultant) / spring. Slip is in the direction of the traction, without the
  /// mean.
  /// @param factored  see FrictionSystem @returns false if the iteration does not converge
  bool search(const ContactLoad& load, const Linearization& factored, const Options& options,
              FrictionState& state) const;

  /// Solves from a state nearby, by full steps (or damped ones) without springs, the first one with state.nodes if they
  /// are known: statuses of an earlier load are a better guess than those that its multipliers and the new gaps
  /// suggest.
  /// @param mean  whether slip follows the mean direction @returns false if the iteration does not converge quickly
  bool polish(const ContactLoad& load, const Linearization& factored, const Options& options, bool mean,
              FrictionState& state) const;

  /// The linear equations at a solution with these multipliers and gaps, with the mean direction.
  Linearization linearization(const ContactLoad& load, const Eigen::VectorXd& multiplier,
                              const Eigen::VectorXd& gap) const;

 private:
  struct Trial;
  Trial trial(const ContactLoad& load, bool mean, const Options& options, const Eigen::VectorXd& multiplier,
              const Eigen::VectorXd& gap) const;
  /// Right-hand sides of a Newton step, without round-off.
  Eigen::VectorXd right(const Linearization& at, const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap,
                        const Eigen::VectorXd& bound = {}) const;

  FrictionSystem& system_;
  Record record_;
};

/// Direction of the shear traction of a node at the last accepted step; zero if it did not slip.
Eigen::Vector2d direction_before(const ContactLoad& load, const FrictionRows::Tangents& tangential);
/// Gaps of all rows without springs. @param state  with its image
Eigen::VectorXd gaps_of(const ContactProblem& problem, const ContactLoad& load, const FrictionState& state);

}  // namespace creepcontact::contact
