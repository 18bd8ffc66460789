#pragma once
/// Number of threads that a run should use.

namespace creepcontact::run {

/// Largest number of threads, at most `wanted`, with which the BLAS reserves at most half of a limited address space
/// (it may take several hundred MB per thread). At least 1, which may still be too many.
int affordable_threads(int wanted);

}  // namespace creepcontact::run
