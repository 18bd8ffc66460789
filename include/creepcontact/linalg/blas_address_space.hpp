#pragma once
/// Address space reserved by the BLAS.

namespace creepcontact::linalg {

/// Bytes of address space that OpenBLAS reserves for the buffers of its own threads and of those that call it, with
/// their stacks; hardly any of it is ever used. If it cannot get a buffer, OpenBLAS retries forever, so compare this
/// with the limit before the first factorisation. 0 with another BLAS.
/// @param threads  of a factorisation, and of concurrent solves
double blas_address_space(int threads);

}  // namespace creepcontact::linalg
