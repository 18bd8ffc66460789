#pragma once
/// Work in pieces that several threads share.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace creepcontact::linalg {

/// Pieces of work in an order in which each needs only earlier ones. Each is run once, by any thread; a piece waits for
/// those that it needs and that other threads still run.
class TaskList {
 public:
  virtual ~TaskList() = default;
  /// How much work each piece is, in any unit that all lists of one call of run() share.
  virtual std::span<const double> work() const = 0;
  /// Called by one thread before the first piece is run.
  virtual void begin() = 0;
  /// Must not throw: other threads may be waiting for this piece.
  virtual void run(std::size_t task) noexcept = 0;
};

/// A list of one task, or of none.
class SingleTask final : public TaskList {
 public:
  SingleTask() = default;
  SingleTask(double work, std::function<void()> task) : work_{work}, task_(std::move(task)) {}
  std::span<const double> work() const override { return work_; }
  void begin() override {}
  void run(std::size_t /*task*/) noexcept override { task_(); }

 private:
  std::vector<double> work_;
  std::function<void()> task_;
};

/// Runs all tasks of all lists, on the threads of OpenMP if there is enough work. The list with most work left goes
/// first, so independent lists end together.
/// @param parallel_from  work from which other threads are woken
void run(std::span<TaskList* const> lists, double parallel_from);

/// Entries of the factors from which threads are woken for a pass: it takes some tenths of a millisecond then.
constexpr double pass_in_parallel_from = 1 << 19;

/// The order in which run() starts the tasks.
struct ListedTask {
  TaskList* list;
  std::size_t task;
};
std::vector<ListedTask> merged(std::span<TaskList* const> lists);

/// How far one piece of work has come, for others that wait for it. Waiting threads sleep.
class Progress {
 public:
  void reset() { reached_.store(0, std::memory_order_relaxed); }
  void reach(std::int32_t stage) noexcept;
  void wait_for(std::int32_t stage) const noexcept;

 private:
  alignas(64) std::atomic<std::int32_t> reached_{0};
};

}  // namespace creepcontact::linalg
