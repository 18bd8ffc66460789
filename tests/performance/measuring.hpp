#pragma once
/// What the benchmarks measure with, and the floor that memory sets.

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <vector>

#include "creepcontact/platform/library_settings.hpp"

namespace creepcontact::test {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <typename Work>
double min_seconds(int times, const Work& work) {
  double least = 1e300;
  for (int k = 0; k < times; ++k) {
    const auto start = Clock::now();
    work();
    least = std::min(least, seconds_since(start));
  }
  return least;
}

/// Bytes a second that one thread reads.
inline double bandwidth() {
  const std::vector<double> block(std::size_t{1} << 26, 1.0);  // 512 MB
  double sum = 0;
  const double seconds =
      min_seconds(3, [&] { sum += Eigen::Map<const Eigen::VectorXd>(block.data(), block.size()).sum(); });
  benchmark::DoNotOptimize(sum);
  return 8.0 * static_cast<double>(block.size()) / seconds;
}

/// The rest of main(): with the settings that the program makes for itself.
inline void run_benchmarks(int argc, char** argv) {
  platform::set_libraries(argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

}  // namespace creepcontact::test
