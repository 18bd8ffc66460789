#pragma once
/// Address space reserved by the BLAS.

namespace creepcontact::linalg {

/// Bytes of address space that OpenBLAS reserves for the buffers and stacks of its own threads and of those that call
/// it; it uses hardly any of them. If it cannot get a buffer, OpenBLAS retries forever. So compare this with the limit
/// before the first factorisation. 0 with another BLAS.
/// @param threads  of a factorisation, and of concurrent solves
double blas_address_space(int threads);

}  // namespace creepcontact::linalg
