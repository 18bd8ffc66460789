#include "creepcontact/mpi/mpi_team.hpp"

#include <mpi.h>

#include <cstdlib>
#include <thread>

#include "creepcontact/base/error.hpp"
#include "long_messages.hpp"
#include "petsc.hpp"

namespace creepcontact::mpi {

namespace {

MPI_Comm for_the_end = MPI_COMM_NULL;  // of all processes

}  // namespace

Library::Library(int& argc, char**& argv) {
  int provided = 0;
  // MPI's errors end the run by themselves.
  if (MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS || provided < MPI_THREAD_FUNNELED)
    throw SolverError("MPI cannot be started");
  MPI_Comm_dup(MPI_COMM_WORLD, &for_the_end);
}

Library::~Library() {
  end_petsc();
  MPI_Comm_free(&for_the_end);
  MPI_Finalize();
}

bool all_arrive(std::optional<std::chrono::seconds> at_most) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(for_the_end, &request);
  for (int done = 0;;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0) return true;
    if (at_most && Clock::now() - start > *at_most) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void abort_all(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
  std::abort();
}

MpiTeam::MpiTeam() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &size_on_machine_);
  MPI_Comm_free(&machine);
}

void MpiTeam::broadcast(std::span<double> values, int root) const {
  for_each_message(values, [&](std::span<double> part) {
    MPI_Bcast(part.data(), static_cast<int>(part.size()), MPI_DOUBLE, root, MPI_COMM_WORLD);
  });
}

std::vector<double> MpiTeam::gather(std::span<const double> values) const {
  return gather_to_root(values);
}

void MpiTeam::reduce(Operation operation, std::span<double> values) const {
  const MPI_Op op = operation == Operation::sum ? MPI_SUM : operation == Operation::max ? MPI_MAX : MPI_MIN;
  // To one and back: MPI_Allreduce may give different bits to different processes.
  for_each_message(values, [&](std::span<double> part) {
    const int n = static_cast<int>(part.size());
    if (rank_ == 0)
      MPI_Reduce(MPI_IN_PLACE, part.data(), n, MPI_DOUBLE, op, 0, MPI_COMM_WORLD);
    else
      MPI_Reduce(part.data(), nullptr, n, MPI_DOUBLE, op, 0, MPI_COMM_WORLD);
    MPI_Bcast(part.data(), n, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  });
}

}  // namespace creepcontact::mpi
