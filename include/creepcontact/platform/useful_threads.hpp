#pragma once
/// How many threads are useful at the moment.

namespace creepcontact::platform {

/// The number of threads of OpenMP, or 1 if they would wait for each other. On a busy machine, a loop shared among all
/// cores takes as long as its slowest part, which may be waiting for a core. Measured by short test loops. Results of
/// computations do not depend on the number.
/// Cost: about a hundredth of a second.
int useful_threads();

}  // namespace creepcontact::platform
