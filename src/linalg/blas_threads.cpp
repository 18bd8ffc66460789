#include "blas_threads.hpp"

#include <mutex>
#include <thread>

// Weak: absent with another BLAS or without an OpenMP runtime.
extern "C" {
[[gnu::weak]] void openblas_set_num_threads(int);
[[gnu::weak]] int omp_get_max_threads(void);
}

namespace creepcontact::linalg {

namespace {

std::mutex mutex;
int running = 0;

void set_threads(int n) {
  if (openblas_set_num_threads) openblas_set_num_threads(n);
}

int all_cores() {
  if (omp_get_max_threads) return omp_get_max_threads();  // follows the user's limit on threads
  const unsigned n = std::thread::hardware_concurrency();
  return n > 0 ? static_cast<int>(n) : 1;
}

}  // namespace

BlasThreads::BlasThreads() {
  const std::lock_guard lock(mutex);
  if (running++ == 0) set_threads(all_cores());
}

BlasThreads::~BlasThreads() {
  const std::lock_guard lock(mutex);
  if (--running == 0) set_threads(1);
}

void BlasThreads::initialize() {
  const std::lock_guard lock(mutex);
  if (running == 0) set_threads(1);
}

}  // namespace creepcontact::linalg
