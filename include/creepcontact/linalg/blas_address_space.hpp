#pragma once
/// What the BLAS takes of a limited address space.

namespace creepcontact::linalg {

/// Bytes of the buffers that OpenBLAS reserves in its own threads and in those that call it, with their stacks; hardly
/// any of it is ever touched. Where it cannot have a buffer, OpenBLAS tries for ever: compare this with what there is
/// before the first factorisation. 0 with another BLAS.
/// @param threads  of a factorisation, and of the solves side by side
double blas_address_space(int threads);

}  // namespace creepcontact::linalg
