#include "creepcontact/platform/useful_threads.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

namespace creepcontact::platform {
namespace {

constexpr int rounds = 30;
constexpr double share_seconds = 1e-4;  // of a thread in a round: as in the loops over integration points
constexpr double min_speedup = 1.2;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Arithmetic that no compiler can drop.
double work(std::int64_t n, double x) {
  for (std::int64_t i = 0; i < n; ++i) x = 0.5 * (x + 2 / x);
  return x;
}

}  // namespace

int useful_threads() {
  const int threads = omp_get_max_threads();
  if (threads < 2) return threads;
  std::array<double, 5> timed{};
  std::int64_t n = 1000;
  volatile double kept = 1;
  for (double& time : timed) {
    const double start = seconds();
    kept = work(n, kept);
    time = seconds() - start;
  }
  n = std::max<std::int64_t>(1, static_cast<std::int64_t>(static_cast<double>(n) * share_seconds /
                                                          *std::min_element(timed.begin(), timed.end())));
  double sum = 0;
#pragma omp parallel reduction(+ : sum)
  sum += work(1, 1);  // makes the threads
  const double start = seconds();
  for (int round = 0; round < rounds; ++round) {
#pragma omp parallel reduction(+ : sum)
    sum += work(n, 1 + sum);
  }
  kept = sum;
  const double speedup = threads * rounds * share_seconds / (seconds() - start);
  return speedup > min_speedup ? threads : 1;
}

}  // namespace creepcontact::platform
