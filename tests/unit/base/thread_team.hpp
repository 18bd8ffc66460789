#pragma once
/// A team whose members are threads of the test: what a distributed program does, without MPI.

#include <pthread.h>

#include <algorithm>
#include <span>
#include <thread>
#include <vector>

#include "creepcontact/base/team.hpp"

namespace creepcontact {

class ThreadTeam final : public Team {
 public:
  /// What the members share.
  struct Exchange {
    explicit Exchange(int n) : values(n) { pthread_barrier_init(&barrier, nullptr, n); }
    ~Exchange() { pthread_barrier_destroy(&barrier); }
    Exchange(const Exchange&) = delete;
    Exchange& operator=(const Exchange&) = delete;
    pthread_barrier_t barrier;  // std::barrier waits in a loop that takes the processor from the member it waits for
    std::vector<std::vector<double>> values;  // by rank
  };

  ThreadTeam(Exchange& exchange, int rank) : exchange_(exchange), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(exchange_.values.size()); }

  void broadcast(std::span<double> values, int root) const override {
    const auto all = exchanged(values);
    std::ranges::copy(all[root], values.begin());
  }
  std::vector<double> gather(std::span<const double> values) const override {
    std::vector<double> result;
    for (const std::vector<double>& part : exchanged(values)) result.insert(result.end(), part.begin(), part.end());
    if (rank_ != 0) result.clear();
    return result;
  }

 private:
  void reduce(Operation operation, std::span<double> values) const override {
    const auto all = exchanged(values);
    std::ranges::copy(all[0], values.begin());
    for (std::size_t r = 1; r < all.size(); ++r) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double other = all[r].at(i);
        switch (operation) {
          case Operation::sum:
            values[i] += other;
            break;
          case Operation::max:
            values[i] = std::max(values[i], other);
            break;
          case Operation::min:
            values[i] = std::min(values[i], other);
            break;
        }
      }
    }
  }
  std::vector<std::vector<double>> exchanged(std::span<const double> own) const {
    exchange_.values[rank_].assign(own.begin(), own.end());
    pthread_barrier_wait(&exchange_.barrier);
    std::vector<std::vector<double>> all = exchange_.values;
    pthread_barrier_wait(&exchange_.barrier);
    return all;
  }

  Exchange& exchange_;
  int rank_;
};

/// work(team) on n threads; work must not throw.
template <typename Work>
void on_team(int n, Work work) {
  ThreadTeam::Exchange exchange(n);
  std::vector<std::jthread> threads;
  threads.reserve(n);
  for (int rank = 0; rank < n; ++rank) threads.emplace_back([&, rank] { work(ThreadTeam(exchange, rank)); });
}

}  // namespace creepcontact
