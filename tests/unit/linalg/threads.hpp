#pragma once
/// The number of threads of OpenMP in a test.

#include <omp.h>

namespace creepcontact::linalg::testing {

/// Sets the number of threads while it lives.
class Threads {
 public:
  explicit Threads(int n) : before_(omp_get_max_threads()) { omp_set_num_threads(n); }
  ~Threads() { omp_set_num_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_;
};

}  // namespace creepcontact::linalg::testing
