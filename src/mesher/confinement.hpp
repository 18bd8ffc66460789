#pragma once
/// What the process may do while it reads a file that may say anything.

namespace creepcontact::mesher {

/// What happens to an attempt to reach the network: the process ends, or the attempt fails. OpenCASCADE asks for the
/// name of the machine when it reads IGES.
enum class Network { ends, fails };

/// From here on: no programs, no network, no file opened for writing, made, renamed or removed. Whoever tries ends the
/// process with the status `reached_out`, or by SIGSYS.
/// @returns false if the system offers no seccomp; then nothing is forbidden
bool confine(Network network);

/// Bounds the memory that the process takes beyond what it has now; whoever asks for more ends it with the status
/// `out_of_memory`. No effect under the address sanitizer, which reserves far more than it uses.
/// @param limit_mb  0: no bound
void limit_memory(int limit_mb);

/// Leaves no core file, and is the first to go if the machine runs out of memory.
void be_expendable();

}  // namespace creepcontact::mesher
