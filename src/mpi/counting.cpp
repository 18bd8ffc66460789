/// Counts what passes through MPI, by its profiling interface: functions of these names come before those of the
/// library, which has them as PMPI_... too. MUMPS calls those of Fortran.

#include "counting.hpp"

#include <mpi.h>

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

}  // namespace
}  // namespace creepcontact::mpi

using creepcontact::mpi::count_collective;
using creepcontact::mpi::count_message;

// NOLINTBEGIN(readability-identifier-naming,readability-inconsistent-declaration-parameter-name): MPI's names
extern "C" {

int MPI_Send(const void* buffer, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  count_message(count, type);
  return PMPI_Send(buffer, count, type, to, tag, comm);
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
