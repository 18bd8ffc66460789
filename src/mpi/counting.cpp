/// Counts what passes through MPI, by its profiling interface: functions of these names come before those of the
/// library, which has them as PMPI_... too. MUMPS calls those of Fortran.

#include "counting.hpp"

#include <mpi.h>

#include <unordered_map>

namespace creepcontact::mpi {

WorkCounters& counting() {
  static WorkCounters counters;
  return counters;
}

WorkCounters work_counters() {
  return counting();
}

namespace {

double bytes_of(int count, MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  return static_cast<double>(count) * size;
}

void count_message(int count, MPI_Datatype type) {
  ++counting().messages;
  counting().bytes += bytes_of(count, type);
}

void count_collective(int count, MPI_Datatype type) {
  ++counting().collectives;
  counting().collective_bytes += bytes_of(count, type);
}

/// Bytes of messages that PETSc prepares once and starts many times.
std::unordered_map<MPI_Request, double>& prepared() {
  static std::unordered_map<MPI_Request, double> messages;
  return messages;
}

void count_started(MPI_Request request) {
  const auto message = prepared().find(request);
  if (message == prepared().end()) return;  // that receives
  ++counting().messages;
  counting().bytes += message->second;
}

}  // namespace
}  // namespace creepcontact::mpi

using creepcontact::mpi::bytes_of;
using creepcontact::mpi::count_collective;
using creepcontact::mpi::count_message;
using creepcontact::mpi::count_started;
using creepcontact::mpi::prepared;

// NOLINTBEGIN(readability-identifier-naming,readability-inconsistent-declaration-parameter-name): MPI's names
extern "C" {

int MPI_Send(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  count_message(count, type);
  return PMPI_Send(buffer, count, type, to, tag, comm);
}
int MPI_Isend(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) {
  count_message(count, type);
  return PMPI_Isend(buffer, count, type, to, tag, comm, request);
}
int MPI_Send_init(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
                  MPI_Request* request) {
  const int status = PMPI_Send_init(buffer, count, type, to, tag, comm, request);
  prepared()[*request] = bytes_of(count, type);
  return status;
}
int MPI_Start(MPI_Request* request) {
  count_started(*request);
  return PMPI_Start(request);
}
int MPI_Startall(int n, MPI_Request* requests) {
  for (int i = 0; i < n; ++i) count_started(requests[i]);
  return PMPI_Startall(n, requests);
}
int MPI_Request_free(MPI_Request* request) {
  prepared().erase(*request);
  return PMPI_Request_free(request);
}
int MPI_Allreduce(const void* from, void* into, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  count_collective(count, type);
  return PMPI_Allreduce(from, into, count, type, op, comm);
}
int MPI_Reduce(const void* from, void* into, int count, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm) {
  count_collective(count, type);
  return PMPI_Reduce(from, into, count, type, op, root, comm);
}
int MPI_Bcast(void* buffer, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  count_collective(count, type);
  return PMPI_Bcast(buffer, count, type, root, comm);
}
int MPI_Allgatherv(const void* from, int count, MPI_Datatype type, void* into, const int* counts, const int* starts,
                   MPI_Datatype into_type, MPI_Comm comm) {
  count_collective(count, type);
  return PMPI_Allgatherv(from, count, type, into, counts, starts, into_type, comm);
}

void pmpi_send_(void* buffer, MPI_Fint* count, MPI_Fint* type, MPI_Fint* to, MPI_Fint* tag, MPI_Fint* comm,
                MPI_Fint* error);
void mpi_send_(void* buffer, MPI_Fint* count, MPI_Fint* type, MPI_Fint* to, MPI_Fint* tag, MPI_Fint* comm,
               MPI_Fint* error) {
  count_message(*count, PMPI_Type_f2c(*type));
  pmpi_send_(buffer, count, type, to, tag, comm, error);
}
void pmpi_isend_(void* buffer, MPI_Fint* count, MPI_Fint* type, MPI_Fint* to, MPI_Fint* tag, MPI_Fint* comm,
                 MPI_Fint* request, MPI_Fint* error);
void mpi_isend_(void* buffer, MPI_Fint* count, MPI_Fint* type, MPI_Fint* to, MPI_Fint* tag, MPI_Fint* comm,
                MPI_Fint* request, MPI_Fint* error) {
  count_message(*count, PMPI_Type_f2c(*type));
  pmpi_isend_(buffer, count, type, to, tag, comm, request, error);
}

void pmpi_bcast_(void* buffer, MPI_Fint* count, MPI_Fint* type, MPI_Fint* root, MPI_Fint* comm, MPI_Fint* error);
void mpi_bcast_(void* buffer, MPI_Fint* count, MPI_Fint* type, MPI_Fint* root, MPI_Fint* comm, MPI_Fint* error) {
  count_collective(*count, PMPI_Type_f2c(*type));
  pmpi_bcast_(buffer, count, type, root, comm, error);
}
void pmpi_reduce_(void* from, void* into, MPI_Fint* count, MPI_Fint* type, MPI_Fint* op, MPI_Fint* root, MPI_Fint* comm,
                  MPI_Fint* error);
void mpi_reduce_(void* from, void* into, MPI_Fint* count, MPI_Fint* type, MPI_Fint* op, MPI_Fint* root, MPI_Fint* comm,
                 MPI_Fint* error) {
  count_collective(*count, PMPI_Type_f2c(*type));
  pmpi_reduce_(from, into, count, type, op, root, comm, error);
}
void pmpi_allreduce_(void* from, void* into, MPI_Fint* count, MPI_Fint* type, MPI_Fint* op, MPI_Fint* comm,
                     MPI_Fint* error);
void mpi_allreduce_(void* from, void* into, MPI_Fint* count, MPI_Fint* type, MPI_Fint* op, MPI_Fint* comm,
                    MPI_Fint* error) {
  count_collective(*count, PMPI_Type_f2c(*type));
  pmpi_allreduce_(from, into, count, type, op, comm, error);
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming,readability-inconsistent-declaration-parameter-name)
