#include "chebyshev_stages.hpp"

#include <algorithm>
#include <cmath>

namespace creepcontact::ode {

namespace {
/// The stability polynomial stays a little below 1 inside its interval, which narrows by 2 %.
constexpr double damping = 2.0 / 13.0;
constexpr double stability_factor = 0.653;  // of s^2 - 1; the bound itself is (2/3) (1 - 2/15 damping)

/// Chebyshev polynomial T_j and its derivatives at one point.
struct Chebyshev {
  double value, first, second;
};

std::vector<Chebyshev> chebyshev(int s, double x) {
  std::vector<Chebyshev> t = {{1, 0, 0}, {x, 1, 0}};
  for (std::size_t j = 2; j <= static_cast<std::size_t>(s); ++j)
    t.push_back({2 * x * t[j - 1].value - t[j - 2].value, 2 * t[j - 1].value + 2 * x * t[j - 1].first - t[j - 2].first,
                 4 * t[j - 1].first + 2 * x * t[j - 1].second - t[j - 2].second});
  return t;
}
}  // namespace

std::vector<ChebyshevStage> chebyshev_stages(int s) {
  const std::size_t last = s;
  const double w0 = 1 + damping / (static_cast<double>(s) * s);
  const std::vector<Chebyshev> t = chebyshev(s, w0);
  const double w1 = t[last].first / t[last].second;
  const auto b = [&](std::size_t j) {
    const Chebyshev& of = t[std::max<std::size_t>(j, 2)];
    return of.second / (of.first * of.first);
  };
  const auto c = [&](std::size_t j) { return w1 * t[j].second / t[j].first; };

  std::vector<ChebyshevStage> stages(last);
  stages[0].mu_rate = b(1) * w1;
  stages[0].c = c(2) / t[2].first;
  for (std::size_t j = 2; j <= last; ++j) {
    ChebyshevStage& stage = stages[j - 1];
    stage.mu = 2 * w0 * b(j) / b(j - 1);
    stage.nu = -b(j) / b(j - 2);
    stage.mu_rate = 2 * w1 * b(j) / b(j - 1);
    stage.gamma_rate = -(1 - b(j - 1) * t[j - 1].value) * stage.mu_rate;
    stage.c = c(j);
  }
  return stages;
}

double chebyshev_stability_bound(int s) {
  return stability_factor * (static_cast<double>(s) * s - 1);
}

int chebyshev_stage_count(double step_times_radius) {
  return std::max(2, static_cast<int>(std::ceil(std::sqrt(step_times_radius / stability_factor + 1))));
}

}  // namespace creepcontact::ode
