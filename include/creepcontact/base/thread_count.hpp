#pragma once
/// The number of threads that OpenMP uses for the work of one thread.

#include <omp.h>

namespace creepcontact {

/// Sets the number for what the calling thread does while it lives.
class ThreadCount {
 public:
  explicit ThreadCount(int n) : before_(omp_get_max_threads()) { omp_set_num_threads(n); }
  ~ThreadCount() { omp_set_num_threads(before_); }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;

 private:
  int before_;
};

}  // namespace creepcontact
