#pragma once
/// What this process has done and sent so far, for tables and models of the run time.

#include <cstdint>

namespace creepcontact::mpi {

struct WorkCounters {
  std::int64_t messages = 0;       ///< sent from point to point, by this program and by MUMPS
  double bytes = 0;                ///< in them
  std::int64_t collectives = 0;    ///< reductions, broadcasts, gathers
  double collective_bytes = 0;     ///< that this process contributes to them
  double factor_bytes = 0;         ///< of all factors at present: this process' part
  double factorization_flops = 0;  ///< of all factorisations
};

WorkCounters work_counters();

}  // namespace creepcontact::mpi
