#include "cholmod_context.hpp"

#include <stdexcept>
#include <string>

#include "creepcontact/base/error.hpp"

namespace creepcontact::linalg {

CholmodContext::CholmodContext() {
  cholmod_l_start(&common_);
  common_.print = 0;  // errors are thrown, not printed
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_GIVEN;
  common_.postorder = 1;
  common_.quick_return_if_not_posdef = 1;
}

void CholmodContext::check(const char* task) const {
  if (common_.status >= CHOLMOD_OK) return;  // positive: a warning
  if (common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE) {
    throw SolverError(std::string("not enough memory to ") + task + " the stiffness matrix; a coarser mesh needs less");
  }
  throw std::logic_error(std::string("CHOLMOD could not ") + task + " the matrix: status " +
                         std::to_string(common_.status));
}

cholmod_sparse view(const SparseMatrix& lower) {
  cholmod_sparse matrix{};
  matrix.nrow = lower.rows();
  matrix.ncol = lower.cols();
  matrix.nzmax = lower.nonZeros();
  matrix.p = const_cast<std::int64_t*>(lower.outerIndexPtr());
  matrix.i = const_cast<std::int64_t*>(lower.innerIndexPtr());
  matrix.x = const_cast<double*>(lower.valuePtr());
  matrix.stype = -1;
  matrix.itype = CHOLMOD_LONG;
  matrix.xtype = CHOLMOD_REAL;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = 1;
  matrix.packed = 1;
  return matrix;
}

cholmod_dense view(std::span<double> vector) {
  cholmod_dense dense{};
  dense.nrow = dense.d = dense.nzmax = vector.size();
  dense.ncol = 1;
  dense.x = vector.data();
  dense.xtype = CHOLMOD_REAL;
  dense.dtype = CHOLMOD_DOUBLE;
  return dense;
}

}  // namespace creepcontact::linalg
