#pragma once
/// Threads of the BLAS: one, except while a matrix is factorised. Many threads on the small blocks of a solve make it
/// several times slower, so this is a rule for the process and not a switch around every call.

namespace creepcontact::linalg {

/// While one lives, the BLAS uses all cores OpenMP may use; when the last is gone, one. Without OpenBLAS: no effect.
class BlasThreads {
 public:
  BlasThreads();
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

  /// One thread from the start of the program's first solver.
  static void initialize();
};

}  // namespace creepcontact::linalg
