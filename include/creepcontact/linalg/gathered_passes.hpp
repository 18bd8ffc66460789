#pragma once
/// Passes of several threads through the same factors, made together: a factor is read once for all of them, which
/// takes most of the time of a pass.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "creepcontact/linalg/stiffness_solver.hpp"

namespace creepcontact::linalg {

/// Runs jobs in threads of their own and makes their passes when all of them wait for one. Solvers take part whose
/// gathering() this is. Which passes come together depends on the jobs alone, not on the speed of their threads: the
/// results are the same in every run.
class GatheredPasses {
 public:
  /// Calls all jobs, `at_once` at a time and in their order, and returns when they have ended. Each has one thread; as
  /// many as OpenMP gives the caller work at a time, and make the passes. A job must not wait for another one, except
  /// for what that does before its next pass. One call at a time.
  /// @throws what the first of the jobs that failed has thrown, after the end of all
  void run(std::span<const std::function<void()>> jobs, std::size_t at_once);

  /// Makes these substitutions together with those of the other jobs. @returns false if the thread is not that of a job
  bool join(PassDirection direction, std::span<const Substitution> of_bodies);

  struct Counters {
    std::int64_t passes = 0;   ///< through the factors
    std::int64_t vectors = 0;  ///< for which they were made
    double seconds = 0;        ///< of processor time that they took
  };
  Counters counters() const;

 private:
  struct Request {
    std::size_t job;
    PassDirection direction;
    std::span<const Substitution> of_bodies;
    bool is_made = false;
    std::condition_variable made = {};
  };
  struct Job {
    std::size_t number;
    std::thread thread;
  };
  void start(std::size_t number, const std::function<void()>& job);
  void make_passes();
  void make(PassDirection direction, std::span<Request* const> requests);

  /// Waits until one of the cores is free for the calling job, and leaves it to another one.
  void take_turn(std::unique_lock<std::mutex>& lock);
  void leave_turn();

  mutable std::mutex mutex_;
  std::condition_variable turn_;
  std::size_t free_turns_ = 0;
  std::condition_variable changed_;
  std::map<std::thread::id, Job> jobs_;  // under way
  std::vector<std::thread::id> ended_;   // of them
  std::vector<Request*> waiting_;
  std::map<std::size_t, std::exception_ptr> failures_;
  Counters counters_;
};

}  // namespace creepcontact::linalg
