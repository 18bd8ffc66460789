#include "first_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace creepcontact::ode {

namespace {
constexpr int max_attempts = 20;
}

double first_step(System& system, const ErrorNorm& norm, const Start& start, std::vector<double>& state,
                  std::vector<double>& rate, std::int64_t& failures) {
  const double longest = start.latest - start.time;
  double h = std::min(longest, 0.5 * start.stable);
  for (int attempt = 1;; ++attempt) {
    try {
      for_each_index(state.size(), [&](std::size_t i) { state[i] = start.state[i] + h * start.rate[i]; });
      system.rate(std::min(start.time + h, start.latest), state, rate);
      break;
    } catch (const RecoverableError& error) {
      if (attempt == max_attempts)
        throw SolverError(
            fmt::format("{}: no step is possible from t = {:.6g}: {}", start.of.name(), start.time, error.what()));
      ++failures;
      h *= 0.25;
    }
  }
  const double change = norm([&](std::size_t begin, std::size_t n) {
    return h * (piece(std::as_const(rate).data(), begin, n) - piece(start.rate.data(), begin, n));
  });
  return 0.1 * h < longest * std::sqrt(change) ? 0.1 * h / std::sqrt(change) : longest;
}

double latest_first_end(double time, double t_limit, double end_time) {
  const double horizon = end_time > time ? std::min(end_time, t_limit) : t_limit;
  return std::isinf(horizon) ? time + std::max(1.0, std::abs(time)) : horizon;
}

}  // namespace creepcontact::ode
