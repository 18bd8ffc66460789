#pragma once
/// A team: the processes that share the work on one model (single program, multiple data). Each runs the same program
/// on its own elements; decisions common to all are made through the team.

#include <cstddef>
#include <exception>
#include <span>
#include <string>
#include <vector>

namespace creepcontact {

/// Every operation is collective: all members call it, in the same order and with the same number of values. Afterwards
/// all hold the same bits, and so make the same decisions.
class Team {
 public:
  virtual ~Team() = default;
  virtual int rank() const = 0;  ///< 0 .. size() - 1
  virtual int size() const = 0;

  /// Reductions over all members, entry by entry, in place. For max() and min() no value may be NaN.
  void sum(std::span<double> values) const { reduce(Operation::sum, values); }
  void max(std::span<double> values) const { reduce(Operation::max, values); }
  void min(std::span<double> values) const { reduce(Operation::min, values); }
  double sum(double value) const;
  double max(double value) const;
  double min(double value) const;
  /// True if `value` is true on some member.
  bool any(bool value) const { return max(value ? 1.0 : 0.0) > 0; }
  /// The lowest rank among the members with the largest value. @param value  not NaN
  int rank_of_max(double value) const;

  /// Sets `values` to those of `root` on all members.
  virtual void broadcast(std::span<double> values, int root) const = 0;
  /// On rank 0: the values of all members, concatenated by rank; empty on the others. The numbers of values may differ.
  virtual std::vector<double> gather(std::span<const double> values) const = 0;

 protected:
  enum class Operation { sum, max, min };
  virtual void reduce(Operation operation, std::span<double> values) const = 0;
};

/// A team of one process; all operations are trivial.
class SerialTeam final : public Team {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  void broadcast(std::span<double> /*values*/, int /*root*/) const override {}
  std::vector<double> gather(std::span<const double> values) const override { return {values.begin(), values.end()}; }

 private:
  void reduce(Operation /*operation*/, std::span<double> /*values*/) const override {}
};

/// A SerialTeam that lives as long as the program.
const Team& serial_team();

/// What `root` has, to all; how much it is matters there alone. Collective.
void broadcast(const Team& team, std::vector<double>& values, int root);
void broadcast(const Team& team, std::string& text, int root);

/// Collective. If local work has failed on any member, all members throw the same error. Fatal errors precede a
/// RecoverableError; among equals, that of the lowest rank is thrown, with its message and type (those of
/// base/error.hpp, Cancelled and std::bad_alloc; else std::runtime_error). @param own  the failure of this member, or
/// null
void agree_on_failure(const Team& team, const std::exception_ptr& own);

/// Runs local(), the work between two collective operations, such that a failure on one member makes all throw instead
/// of waiting for it. local() must not call collective operations itself.
/// Cost: one reduction; none in a single process.
template <typename Local>
void together(const Team& team, const Local& local) {
  if (team.size() == 1) {
    local();
    return;
  }
  std::exception_ptr failure;
  try {
    local();
  } catch (...) {
    failure = std::current_exception();
  }
  agree_on_failure(team, failure);
}

}  // namespace creepcontact
