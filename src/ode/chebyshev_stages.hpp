#pragma once
/// Coefficients of the Runge-Kutta-Chebyshev method of order 2 with s stages.
/// Source: Sommeijer, Shampine, Verwer (1997), RKC: an explicit solver for parabolic PDEs, eq. (2.1) to (2.6).

#include <vector>

namespace creepcontact::ode {

/// Y_j = (1 - mu - nu) y_n + mu Y_{j-1} + nu Y_{j-2} + h (mu_rate F_{j-1} + gamma_rate f_n),  F_j = f(t_n + c h, Y_j),
/// with Y_0 = y_n; in the first stage mu = 1, the others 0 but mu_rate.
struct ChebyshevStage {
  double mu = 1, nu = 0;
  double mu_rate = 0, gamma_rate = 0;
  double c = 0;
};

/// @param s  at least 2. @returns the stages 1 to s; Y_s is the new state
std::vector<ChebyshevStage> chebyshev_stages(int s);

/// h times the spectral radius up to which s stages are stable on the negative real axis: 0.653 (s^2 - 1).
double chebyshev_stability_bound(int s);
/// The least number of stages, at least 2, that is stable for this h times the spectral radius.
int chebyshev_stage_count(double step_times_radius);

}  // namespace creepcontact::ode
