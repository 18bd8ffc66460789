#pragma once
/// Threads of the BLAS: one, except while a matrix is factorised. Many threads on the small blocks of a solve make it
/// several times slower. The number belongs to the process and changes the bits of a result: so solves wait while any
/// thread factorises, and whatever other threads do changes no bit.

#include <mutex>
#include <shared_mutex>

namespace creepcontact::linalg {

/// While one lives, the BLAS uses all cores OpenMP may use, and no other thread is in the BLAS. Without OpenBLAS only
/// the latter.
class BlasFactorization {
 public:
  BlasFactorization();
  ~BlasFactorization();
  BlasFactorization(const BlasFactorization&) = delete;
  BlasFactorization& operator=(const BlasFactorization&) = delete;

 private:
  std::unique_lock<std::shared_mutex> lock_;
};

/// While one lives, the BLAS uses one thread per caller; any number of threads may hold one. Some 40 ns.
class BlasSolve {
 public:
  BlasSolve();

 private:
  std::shared_lock<std::shared_mutex> lock_;
};

}  // namespace creepcontact::linalg
