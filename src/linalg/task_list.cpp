#include "creepcontact/linalg/task_list.hpp"

#include <omp.h>

#include <algorithm>
#include <numeric>
#include <queue>

namespace creepcontact::linalg {

namespace {

/// Looks at the value before a thread is put to sleep: less than it takes to wake it.
constexpr int looks = 40;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

void Progress::reach(std::int32_t stage) noexcept {
  reached_.store(stage, std::memory_order_release);
  reached_.notify_all();
}

void Progress::wait_for(std::int32_t stage) const noexcept {
  std::int32_t now = reached_.load(std::memory_order_acquire);
  for (int look = 0; now < stage && look < looks; ++look) {
    pause();
    now = reached_.load(std::memory_order_acquire);
  }
  while (now < stage) {
    reached_.wait(now, std::memory_order_acquire);
    now = reached_.load(std::memory_order_acquire);
  }
}

std::vector<ListedTask> merged(std::span<TaskList* const> lists) {
  struct Rest {
    double work;
    std::size_t list, next;
    bool operator<(const Rest& other) const { return work < other.work || (work == other.work && list > other.list); }
  };
  std::priority_queue<Rest> rests;
  std::size_t n = 0;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::span<const double> work = lists[i]->work();
    n += work.size();
    if (!work.empty()) rests.push({std::accumulate(work.begin(), work.end(), 0.0), i, 0});
  }
  std::vector<ListedTask> order;
  order.reserve(n);
  while (!rests.empty()) {
    Rest rest = rests.top();
    rests.pop();
    const std::span<const double> work = lists[rest.list]->work();
    order.push_back({lists[rest.list], rest.next});
    rest.work -= work[rest.next];
    if (++rest.next < work.size()) rests.push(rest);
  }
  return order;
}

void run(std::span<TaskList* const> lists, double parallel_from) {
  double work = 0;
  for (TaskList* const list : lists) {
    list->begin();
    work += std::accumulate(list->work().begin(), list->work().end(), 0.0);
  }
  if (work < parallel_from || omp_get_max_threads() == 1) {
    for (TaskList* const list : lists)
      for (std::size_t task = 0; task < list->work().size(); ++task) list->run(task);
    return;
  }
  const std::vector<ListedTask> order = merged(lists);
  std::atomic<std::size_t> next{0};
#pragma omp parallel
  for (std::size_t i = next.fetch_add(1); i < order.size(); i = next.fetch_add(1)) order[i].list->run(order[i].task);
}

}  // namespace creepcontact::linalg
