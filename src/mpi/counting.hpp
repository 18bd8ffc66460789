#pragma once

#include "creepcontact/mpi/work_counters.hpp"

namespace creepcontact::mpi {

/// Those of this process. MPI is called from one thread.
WorkCounters& counting();

}  // namespace creepcontact::mpi
