#pragma once
/// Settings of the Newton-Krylov iteration, the same for every implicit integrator. Chosen by the elastic solves for a
/// given error of the stress: thick cylinder, plate with hole, shrink fit, ball on block, tolerances 1e-2 to 1e-6.

namespace creepcontact::ode {

inline constexpr int krylov_dimension = 10;

/// Fraction of the tolerance left to the Newton iteration. With SUNDIALS' 0.1, growing contact zones gave convergence
/// failures in a fifth of the steps; with 0.03 none.
inline constexpr double newton_coefficient = 0.03;

/// Fraction of that left to the Krylov iteration. Its residual hides errors of the creep that changes no stress: with
/// 0.05 they may spoil the error estimate of the long steps near a steady state (graded bars: six times the solves at
/// 2.5e-5); 0.01 costs a tenth more and gains nothing.
inline constexpr double krylov_coefficient = 0.02;

/// The preconditioner is renewed with every setup: it is cheap against the elastic solves that it saves (a fifth).
inline constexpr long linearisation_interval = 1;

}  // namespace creepcontact::ode
