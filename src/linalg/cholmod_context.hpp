#pragma once
/// CHOLMOD's common object and views of Eigen matrices for it.

#include <cholmod.h>

#include <type_traits>

#include "supernodal_cholesky.hpp"

namespace creepcontact::linalg {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));

/// Settings and workspace of one solver. Must outlive everything allocated with it.
class CholmodContext {
 public:
  CholmodContext();
  ~CholmodContext() { cholmod_l_finish(&common_); }
  CholmodContext(const CholmodContext&) = delete;
  CholmodContext& operator=(const CholmodContext&) = delete;

  cholmod_common* get() { return &common_; }
  /// @throws SolverError if the last call ran out of memory, std::logic_error if CHOLMOD refused its arguments
  void check(const char* task) const;

 private:
  cholmod_common common_;
};

struct FreeSparse {
  cholmod_common* common;
  void operator()(cholmod_sparse* matrix) const { cholmod_l_free_sparse(&matrix, common); }
};
using SparsePointer = std::unique_ptr<cholmod_sparse, FreeSparse>;

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_l_free_factor(&factor, common); }
};
using FactorPointer = std::unique_ptr<cholmod_factor, FreeFactor>;

/// View of a symmetric matrix given by its lower triangle; valid as long as the matrix. CHOLMOD only reads it.
cholmod_sparse view(const SparseMatrix& lower);
/// View of a vector; CHOLMOD may write to it.
cholmod_dense view(std::span<double> vector);

/// CHOLMOD takes what it only reads (permutations) without const.
inline SuiteSparse_long* cholmod_integers(const std::int64_t* p) {
  return reinterpret_cast<SuiteSparse_long*>(const_cast<std::int64_t*>(p));
}
inline std::int64_t* integers(void* p) {
  return static_cast<std::int64_t*>(p);
}

}  // namespace creepcontact::linalg
