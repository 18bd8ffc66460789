#include "creepcontact/platform/useful_threads.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <utility>

namespace creepcontact::platform {
namespace {

constexpr int rounds = 30, attempts = 3;  // something short may disturb one attempt
constexpr double share_seconds = 1e-4;    // of a thread in a round: as in the loops over integration points
constexpr double min_speedup = 0.6;       // of the number of threads

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Arithmetic that no compiler can drop.
double work(std::int64_t n, double x) {
  for (std::int64_t i = 0; i < n; ++i) x = 0.5 * (x + 2 / x);
  return x;
}

/// Rounds of work(), so many that they take as long as the loops of a computation.
std::int64_t calibrated() {
  std::array<double, 5> timed{};
  std::int64_t n = 1000;
  volatile double kept = 1;
  for (double& time : timed) {
    const double start = seconds();
    kept = work(n, kept);
    time = seconds() - start;
  }
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(static_cast<double>(n) * share_seconds /
                                                             *std::min_element(timed.begin(), timed.end())));
}

double speedup(int threads, std::int64_t n) {
  double sum = 0;
#pragma omp parallel reduction(+ : sum) num_threads(threads)
  sum += work(1, 1);  // makes the threads
  const double start = seconds();
  for (int round = 0; round < rounds; ++round) {
#pragma omp parallel reduction(+ : sum) num_threads(threads)
    sum += work(n, 1 + sum);
  }
  [[maybe_unused]] volatile double kept = sum;
  return threads * rounds * share_seconds / (seconds() - start);
}

}  // namespace

int useful_threads(int most) {
  if (most < 2) return 1;
  const std::int64_t n = calibrated();
  for (int threads = most; threads > 1; threads /= 2)
    for (int attempt = 0; attempt < attempts; ++attempt)
      if (speedup(threads, n) > min_speedup * threads) return threads;
  return 1;
}

ThreadWatch::ThreadWatch(int most, std::chrono::seconds interval, std::function<int(int)> measure)
    : most_(most), threads_(measure(most)), interval_(interval), measure_(std::move(measure)) {}

std::optional<int> ThreadWatch::update(Clock::time_point now) {
  if (most_ == 1 || now - last_ < interval_) return std::nullopt;
  last_ = now;
  const int before = std::exchange(threads_, measure_(most_));
  return threads_ == before ? std::nullopt : std::optional(threads_);
}

}  // namespace creepcontact::platform
