#include "creepcontact/linalg/gathered_passes.hpp"

#include <omp.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <utility>

#include "creepcontact/base/thread_count.hpp"

namespace creepcontact::linalg {

void GatheredPasses::run(std::span<const std::function<void()>> jobs, std::size_t at_once) {
  std::unique_lock lock(mutex_);
  std::size_t next = 0;
  free_turns_ = static_cast<std::size_t>(omp_get_max_threads());
  while (true) {
    while (jobs_.size() < at_once && next < jobs.size()) {
      start(next, jobs[next]);
      ++next;
    }
    if (jobs_.empty()) break;
    changed_.wait(lock, [&] { return !ended_.empty() || waiting_.size() == jobs_.size(); });
    if (ended_.empty()) {
      make_passes();
      continue;
    }
    for (const std::thread::id id : std::exchange(ended_, {})) {
      jobs_.at(id).thread.join();  // it does not need the lock any more
      jobs_.erase(id);
    }
  }
  if (failures_.empty()) return;
  const std::exception_ptr first = failures_.begin()->second;
  failures_.clear();
  std::rethrow_exception(first);
}

void GatheredPasses::start(std::size_t number, const std::function<void()>& job) {
  std::thread thread([this, number, &job] {
    const ThreadCount one(1);
    std::exception_ptr failure;
    try {
      {
        std::unique_lock lock(mutex_);  // jobs_ has this thread from now on
        take_turn(lock);
      }
      job();
    } catch (...) {
      failure = std::current_exception();
    }
    const std::scoped_lock lock(mutex_);
    leave_turn();
    if (failure) failures_[number] = failure;
    ended_.push_back(std::this_thread::get_id());
    changed_.notify_one();
  });
  const std::thread::id id = thread.get_id();
  jobs_.emplace(id, Job{number, std::move(thread)});
}

bool GatheredPasses::join(PassDirection direction, std::span<const Substitution> of_bodies) {
  std::unique_lock lock(mutex_);
  const auto job = jobs_.find(std::this_thread::get_id());
  if (job == jobs_.end()) return false;
  Request request{.job = job->second.number, .direction = direction, .of_bodies = of_bodies};
  waiting_.push_back(&request);
  if (waiting_.size() == jobs_.size()) changed_.notify_one();
  leave_turn();
  request.made.wait(lock, [&] { return request.is_made; });
  take_turn(lock);
  return true;
}

void GatheredPasses::take_turn(std::unique_lock<std::mutex>& lock) {
  turn_.wait(lock, [&] { return free_turns_ > 0; });
  --free_turns_;
}

void GatheredPasses::leave_turn() {
  ++free_turns_;
  turn_.notify_one();
}

GatheredPasses::Counters GatheredPasses::counters() const {
  const std::scoped_lock lock(mutex_);
  return counters_;
}

/// Back substitutions go first: those who wait for forward ones are then joined by those who have had their back
/// substitution, and all are in step again.
void GatheredPasses::make_passes() {
  const auto is_backward = [](const Request* request) { return request->direction == PassDirection::backward; };
  const PassDirection direction =
      std::ranges::any_of(waiting_, is_backward) ? PassDirection::backward : PassDirection::forward;
  std::vector<Request*> now;
  std::ranges::copy_if(waiting_, std::back_inserter(now),
                       [&](const Request* request) { return request->direction == direction; });
  std::erase_if(waiting_, [&](const Request* request) { return request->direction == direction; });
  std::ranges::sort(now, {}, &Request::job);
  make(direction, now);
  for (Request* const request : now) {
    request->is_made = true;
    request->made.notify_one();
  }
}

void GatheredPasses::make(PassDirection direction, std::span<Request* const> requests) {
  struct Group {
    StiffnessSolver* solver;  // of the first request; the others have the same factor
    std::vector<PassVector> vectors;
  };
  std::vector<Group> groups;
  for (const Request* const request : requests)
    for (const Substitution& part : request->of_bodies) {
      const void* const factor = part.solver->shared_factor();
      const auto same = std::ranges::find_if(groups, [factor](const Group& group) {
        return factor != nullptr && group.solver->shared_factor() == factor;
      });
      Group& group = same != groups.end() ? *same : groups.emplace_back(Group{part.solver, {}});
      group.vectors.push_back({part.from, part.into});
    }
  const std::clock_t before = std::clock();  // nothing else is under way
  std::vector<TaskList*> lists;
  for (const Group& group : groups) {
    lists.push_back(&group.solver->tasks(direction, group.vectors));
    ++counters_.passes;
    counters_.vectors += std::ssize(group.vectors);
  }
  linalg::run(lists, pass_in_parallel_from);
  counters_.seconds += static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
}

}  // namespace creepcontact::linalg
