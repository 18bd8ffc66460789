#pragma once
/// Threads of the BLAS: one, except while a matrix is factorised. The number belongs to the process and changes the
/// bits of a result: so one factorisation waits for the other, and whatever other threads do changes no bit.

#include <mutex>

namespace creepcontact::linalg {

/// While one lives, the BLAS uses all cores OpenMP may use, and no other thread factorises. Without OpenBLAS only the
/// latter. Where OpenMP may use one core CHOLMOD uses no more: its loops would wake four threads otherwise, thousands
/// of times. Within for_each_factorization() it does nothing: that has decided.
class BlasFactorization {
 public:
  BlasFactorization();
  ~BlasFactorization();
  BlasFactorization(const BlasFactorization&) = delete;
  BlasFactorization& operator=(const BlasFactorization&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  int levels_ = 0;  // of parallel regions within each other, before
};

}  // namespace creepcontact::linalg
