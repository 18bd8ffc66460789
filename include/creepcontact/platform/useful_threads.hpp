#pragma once
/// How many threads help at the moment.

namespace creepcontact::platform {

/// OpenMP's number of threads, or 1 where they would wait for each other: on a machine that others keep busy a loop
/// shared by all cores takes as long as its slowest share, which may stand in a queue. Measured by such loops, in a
/// hundredth of a second. Results do not depend on the number.
int useful_threads();

}  // namespace creepcontact::platform
