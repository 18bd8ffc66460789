#pragma once

#include "creepcontact/mpi/work_counters.hpp"

namespace creepcontact::mpi {

/// Those of this process. MPI is called from one thread.
WorkCounters& counting();

/// Bytes that one solver adds to WorkCounters::factor_bytes while it lives.
class CountedBytes {
 public:
  CountedBytes() = default;
  CountedBytes(const CountedBytes&) = delete;
  CountedBytes& operator=(const CountedBytes&) = delete;
  ~CountedBytes() { set(0); }
  void set(double bytes) {
    counting().factor_bytes += bytes - bytes_;
    bytes_ = bytes;
  }

 private:
  double bytes_ = 0;
};

}  // namespace creepcontact::mpi
