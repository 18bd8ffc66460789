#pragma once
/// Which libraries the dense kernels of the factorisations come from.

#include <string>

namespace creepcontact::linalg {

struct BlasLibrary {
  std::string blas;          ///< file that dgemm_ is taken from, without symbolic links; empty: not known
  std::string lapack;        ///< the same of dpotrf_
  std::string warning = {};  ///< if factorisations take several times as long as with OpenBLAS: why, and the remedy
};

/// The libraries that this process uses. Cost: some look-ups of symbols.
BlasLibrary blas_library();

/// Why this file is slow: the reference BLAS, or ATLAS; empty for other libraries.
std::string why_slow_blas(const std::string& file);

}  // namespace creepcontact::linalg
