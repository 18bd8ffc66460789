#pragma once
/// How many threads a run should use.

namespace creepcontact::run {

/// Number of threads that a limited address space has room for, `wanted` at most: each may take some hundred MB of it
/// in the BLAS. 1 may still be too many.
int affordable_threads(int wanted);

}  // namespace creepcontact::run
