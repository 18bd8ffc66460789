#pragma once
/// Settings of the Newton-Krylov iteration, the same for every implicit integrator. Counted in rate evaluations and
/// Jacobian products on parallel bars with creep rates graded over 10 to 1e4, tolerances 1e-3 to 1e-5 (68 runs).

namespace creepcontact::ode {

inline constexpr int krylov_dimension = 10;

/// Fraction of the tolerance left to the Newton iteration. With SUNDIALS' 0.1, growing contact zones gave convergence
/// failures in a fifth of the steps; with 0.03 none.
inline constexpr double newton_coefficient = 0.03;

/// Fraction of that left to the Krylov iteration. The preconditioned residual hides errors of the creep that changes
/// no stress; with SUNDIALS' 0.05 they spoil the error estimate of the long steps near a steady state.
inline constexpr double krylov_coefficient = 0.01;

/// The preconditioner is renewed with every setup: it is cheap against the elastic solves that it saves (a fifth).
inline constexpr long linearisation_interval = 1;

}  // namespace creepcontact::ode
