#include "blas_threads.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#include "creepcontact/linalg/blas_address_space.hpp"
#include "creepcontact/linalg/factorizations.hpp"

// Weak: absent with another BLAS.
extern "C" [[gnu::weak]] void openblas_set_num_threads(int);

namespace creepcontact::linalg {

namespace {

std::mutex mutex;
thread_local bool decided = false;

void set_threads(int n) {
  if (openblas_set_num_threads) openblas_set_num_threads(n);
}

int all_cores() {
  return omp_get_max_threads();  // follows the user's limit on threads
}

}  // namespace

BlasFactorization::BlasFactorization() {
  if (decided) return;
  lock_ = std::unique_lock(mutex);
  set_threads(all_cores());
  levels_ = omp_get_max_active_levels();
  if (all_cores() == 1) omp_set_max_active_levels(0);
}

BlasFactorization::~BlasFactorization() {
  if (!lock_.owns_lock()) return;
  set_threads(1);
  omp_set_max_active_levels(levels_);
}

bool side_by_side(std::span<const double> entries, int threads) {
  // Operations grow with this power of the entries where those grow with n^1.4, as in compact bodies.
  constexpr double exponent = 1.5;
  constexpr double gain = 0.7;  // of every thread of the BLAS: half of the work is in small matrices or on one thread
  double all = 0, largest = 0;
  for (const double of_one : entries) {
    const double work = std::pow(of_one, exponent);
    all += work;
    largest = std::max(largest, work);
  }
  return threads > 1 && largest < all / (gain * threads);
}

void for_each_factorization(std::span<const double> entries, const std::function<void(std::size_t i)>& factorize) {
  if (!side_by_side(entries, all_cores())) {
    for (std::size_t i = 0; i < entries.size(); ++i) factorize(i);
    return;
  }
  std::vector<std::exception_ptr> errors(entries.size());
  {
    const std::unique_lock lock(mutex);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t i = 0; i < entries.size(); ++i) {
      decided = true;
      try {
        factorize(i);
      } catch (...) {
        errors[i] = std::current_exception();
      }
      decided = false;
    }
  }
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

double blas_address_space(int threads) {
  constexpr double buffer = 128.0 * (1 << 20), stack = 8.0 * (1 << 20);  // of OpenBLAS on x86-64, elsewhere less
  if (!openblas_set_num_threads) return 0;
  return buffer + std::max(0, threads - 1) * (2 * buffer + 2 * stack);
}

}  // namespace creepcontact::linalg
