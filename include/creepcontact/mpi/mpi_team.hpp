#pragma once
/// Processes of MPI as a team.

#include <chrono>
#include <optional>

#include "creepcontact/base/team.hpp"

namespace creepcontact::mpi {

/// MPI for the life of the program. Only one thread may call MPI.
class Library {
 public:
  /// @throws SolverError if MPI cannot be started
  Library(int& argc, char**& argv);
  /// Ends MPI, which waits for all processes.
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

/// All processes that mpirun has started. A process that ends without having taken part in all collective operations
/// ends the others (MPI_Abort of the launcher).
class MpiTeam final : public Team {
 public:
  /// Precondition: a Library exists, and outlives the object.
  MpiTeam();
  int rank() const override { return rank_; }
  int size() const override { return size_; }
  void broadcast(std::span<double> values, int root) const override;
  std::vector<double> gather(std::span<const double> values) const override;
  /// Number of members on this machine.
  int size_on_machine() const { return size_on_machine_; }

 private:
  void reduce(Operation operation, std::span<double> values) const override;

  int rank_ = 0, size_ = 1, size_on_machine_ = 1;
};

/// Waits until all processes have called it. Apart from all other collective operations: some may be in one.
/// @param at_most  nullopt: for ever @returns false if not all have within that time
bool all_arrive(std::optional<std::chrono::seconds> at_most);

/// Ends all processes at once, where some wait for others that have failed.
[[noreturn]] void abort_all(int status);

}  // namespace creepcontact::mpi
