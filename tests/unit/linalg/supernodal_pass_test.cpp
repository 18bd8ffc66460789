#include "../../../src/linalg/supernodal_pass.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "creepcontact/base/thread_count.hpp"
#include "matrices.hpp"

namespace creepcontact::linalg {
namespace {

using testing::Problem;

/// Large enough to be cut into subtrees and panels.
Problem cut_problem() {
  return testing::grid(14);
}
std::vector<std::int64_t> trailing_of(const Problem& problem) {
  std::vector<std::int64_t> result;
  for (std::int64_t i = 0; i < problem.lower.rows(); i += 40) result.push_back(i);
  return result;
}

TEST(SupernodalPass, IsCutIntoTasksThatSeveralThreadsCanShare) {
  const Problem problem = cut_problem();
  SupernodalCholesky solver(problem.lower, problem.node_of, trailing_of(problem));
  solver.factorize(problem.lower);
  std::vector<double> x(solver.size());
  const std::span<const double> work = solver.forward_tasks(x, x).work();
  double all = 0;
  for (const double of_task : work) all += of_task;
  EXPECT_GT(work.size(), 30U);
  EXPECT_LT(std::ranges::max(work), 0.12 * all);
}

TEST(SupernodalPass, HasTheSameBitsForAnyNumberOfThreads) {
  const Problem problem = cut_problem();
  SupernodalCholesky solver(problem.lower, problem.node_of, trailing_of(problem));
  solver.factorize(problem.lower);
  const Eigen::VectorXd b = testing::random_vector(solver.size(), 3);
  Eigen::VectorXd y, x;
  {
    const ThreadCount one(1);
    y = testing::forward(solver, b);
    x = testing::backward(solver, y);
  }
  const Eigen::VectorXd residual = problem.lower.selfadjointView<Eigen::Lower>() * x - b;
  EXPECT_LT(residual.norm(), 1e-12 * b.norm());
  for (const int n : {2, 3, 8}) {
    const ThreadCount several(n);
    for (int repeat = 0; repeat < 20; ++repeat) {
      ASSERT_EQ(testing::forward(solver, b), y) << n << " threads";
      ASSERT_EQ(testing::backward(solver, y), x) << n << " threads";
    }
  }
}

TEST(SupernodalPass, OfSeveralBodiesAtOnceIsThatOfEach) {
  const std::vector<Problem> problems{cut_problem(), testing::grid(3), testing::grid(12, 2), Problem{}};
  std::vector<std::unique_ptr<SupernodalCholesky>> solvers;
  std::vector<Eigen::VectorXd> given, alone, together;
  for (const Problem& problem : problems) {
    solvers.push_back(
        std::make_unique<SupernodalCholesky>(problem.lower, problem.node_of, std::span<const std::int64_t>{}));
    solvers.back()->factorize(problem.lower);
    given.push_back(testing::random_vector(problem.lower.rows(), 9));
    alone.push_back(testing::solve(*solvers.back(), given.back()));
    together.emplace_back(given.back().size());
  }
  const ThreadCount several(4);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::vector<Substitution> there, back;
    for (std::size_t i = 0; i < solvers.size(); ++i) {
      const std::span<double> result(together[i].data(), together[i].size());
      there.push_back({solvers[i].get(), {given[i].data(), static_cast<std::size_t>(given[i].size())}, result});
      back.push_back({solvers[i].get(), result, result});
    }
    forward(there);
    backward(back);
    for (std::size_t i = 0; i < solvers.size(); ++i) ASSERT_EQ(together[i], alone[i]) << "body " << i;
  }
}

/// Tasks that note in which order they were started.
class NotedTasks final : public TaskList {
 public:
  NotedTasks(std::vector<double> work, std::vector<std::pair<int, std::size_t>>& notes, int name)
      : work_(std::move(work)), notes_(notes), name_(name) {}
  std::span<const double> work() const override { return work_; }
  void begin() override { ++begun; }
  void run(std::size_t task) noexcept override { notes_.emplace_back(name_, task); }
  int begun = 0;

 private:
  std::vector<double> work_;
  std::vector<std::pair<int, std::size_t>>& notes_;
  int name_;
};

TEST(TaskList, TheListWithMostWorkLeftGoesFirst) {
  std::vector<std::pair<int, std::size_t>> notes;
  NotedTasks small({1, 2, 1}, notes, 0), large({5, 3, 1}, notes, 1), none({}, notes, 2);
  std::vector<TaskList*> lists{&small, &large, &none};
  for (const ListedTask& next : merged(lists)) next.list->run(next.task);
  const std::vector<std::pair<int, std::size_t>> expected{{1, 0}, {0, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}};
  EXPECT_EQ(notes, expected);
  notes.clear();
  run(lists, 0);
  EXPECT_EQ(notes.size(), 6U);
  EXPECT_EQ(small.begun + large.begun + none.begun, 3);
}

TEST(Progress, WakesThoseThatWait) {
  Progress progress;
  std::atomic<int> woken{0};
  std::vector<std::thread> threads;
  for (int stage = 1; stage <= 3; ++stage)
    threads.emplace_back([&, stage] {
      progress.wait_for(stage);
      ++woken;
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // they sleep now
  EXPECT_EQ(woken, 0);
  for (int stage = 1; stage <= 3; ++stage) progress.reach(stage);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(woken, 3);
}

}  // namespace
}  // namespace creepcontact::linalg
