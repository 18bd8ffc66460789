#pragma once
/// The processes that share the work on one model (single program, multiple data): each runs the same program on its
/// own elements, and what all of them must agree on goes through their Team.

#include <cstddef>
#include <exception>
#include <span>
#include <vector>

namespace creepcontact {

/// Every operation is collective: all members call it, in the same order and with as many values. Afterwards they hold
/// the same bits, so that they take the same decisions.
class Team {
 public:
  virtual ~Team() = default;
  virtual int rank() const = 0;  ///< 0 .. size() - 1
  virtual int size() const = 0;

  /// Entry by entry over all members, in place. No value of max() and min() may be NaN.
  void sum(std::span<double> values) const { reduce(Operation::sum, values); }
  void max(std::span<double> values) const { reduce(Operation::max, values); }
  void min(std::span<double> values) const { reduce(Operation::min, values); }
  double sum(double value) const;
  double max(double value) const;
  double min(double value) const;
  /// True if it is so for some member.
  bool any(bool value) const { return max(value ? 1.0 : 0.0) > 0; }
  /// The member with the largest value, the first one of several. @param value  not NaN
  int rank_of_max(double value) const;

  /// All members get the values of `root`.
  virtual void broadcast(std::span<double> values, int root) const = 0;
  /// The values of all members one after the other, on rank 0; nothing on the others. Members may give different
  /// numbers of values.
  virtual std::vector<double> gather(std::span<const double> values) const = 0;

 protected:
  enum class Operation { sum, max, min };
  virtual void reduce(Operation operation, std::span<double> values) const = 0;
};

/// A single process: nothing to agree on.
class SerialTeam final : public Team {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  void broadcast(std::span<double> /*values*/, int /*root*/) const override {}
  std::vector<double> gather(std::span<const double> values) const override { return {values.begin(), values.end()}; }

 private:
  void reduce(Operation /*operation*/, std::span<double> /*values*/) const override {}
};

const Team& serial_team();

/// Collective. If the local work of any member has failed, all throw: fatal errors before a RecoverableError, and of
/// equals that of the lowest rank, with its type (those of base/error.hpp and std::bad_alloc; else std::runtime_error)
/// and message. @param own  the failure of this member, or null
void agree_on_failure(const Team& team, std::exception_ptr own);

/// local() is work between two collective operations, and calls none itself: no member waits for one that has failed.
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
