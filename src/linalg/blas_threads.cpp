#include "blas_threads.hpp"

#include <algorithm>

#include "creepcontact/base/cores.hpp"
#include "creepcontact/linalg/blas_address_space.hpp"

// Weak: absent with another BLAS or without an OpenMP runtime.
extern "C" {
[[gnu::weak]] void openblas_set_num_threads(int);
[[gnu::weak]] int omp_get_max_threads(void);
}

namespace creepcontact::linalg {

namespace {

std::mutex mutex;

void set_threads(int n) {
  if (openblas_set_num_threads) openblas_set_num_threads(n);
}

int all_cores() {
  if (omp_get_max_threads) return omp_get_max_threads();  // follows the user's limit on threads
  return cores();
}

}  // namespace

BlasFactorization::BlasFactorization() : lock_(mutex) {
  set_threads(all_cores());
}

BlasFactorization::~BlasFactorization() {
  set_threads(1);
}

double blas_address_space(int threads) {
  constexpr double buffer = 128.0 * (1 << 20), stack = 8.0 * (1 << 20);  // of OpenBLAS on x86-64, elsewhere less
  if (!openblas_set_num_threads) return 0;
  return buffer + std::max(0, threads - 1) * (2 * buffer + 2 * stack);
}

}  // namespace creepcontact::linalg
