/// A forward and a backward pass through the factors of a ball on a block, against CHOLMOD's passes on one thread
/// through the same factors (`of_cholmod`) and against the time in which one thread reads the factors twice
/// (`of_the_floor`). `busiest` is the work of the busiest of so many threads, as part of the work of CHOLMOD's pass:
/// the tasks are dealt out as the threads would take them, so it needs no such machine.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <map>
#include <memory>

#include "../../src/linalg/cholmod_context.hpp"
#include "../../src/linalg/ordering.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/mechanics/factored_body.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"

namespace creepcontact::test {
namespace {

/// CHOLMOD's own factor and pass.
class CholmodFactor {
 public:
  CholmodFactor(const linalg::SparseMatrix& lower, std::span<const std::int64_t> block_of) {
    const std::vector<std::int64_t> order = linalg::elimination_order(lower, block_of, {}, context_);
    cholmod_sparse matrix = linalg::view(lower);
    factor_ = cholmod_l_analyze_p(&matrix, linalg::cholmod_integers(order.data()), nullptr, 0, context_.get());
    cholmod_l_factorize(&matrix, factor_, context_.get());
    context_.check("factorise");
    vector_.resize(factor_->n);
    update_.resize(factor_->maxesize + 1);
  }
  ~CholmodFactor() { cholmod_l_free_factor(&factor_, context_.get()); }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  void pass() {
    std::ranges::fill(vector_, 1.0);
    cholmod_dense vector = linalg::view(vector_), update = linalg::view(update_);
    cholmod_l_super_lsolve(factor_, &vector, &update, context_.get());
    cholmod_l_super_ltsolve(factor_, &vector, &update, context_.get());
  }

 private:
  linalg::CholmodContext context_;
  cholmod_factor* factor_ = nullptr;
  std::vector<double> vector_, update_;
};

class Factors {
 public:
  /// @param size  of the small elements, in hundredths
  explicit Factors(std::int64_t size)
      : model_(
            model::build_model(config::read(CREEPCONTACT_CONFIGS "/ball_on_block.toml", run::vocabulary(),
                                            {fmt::format("mesh.parameters.h={}", static_cast<double>(size) / 1000)}))) {
    for (const mechanics::Body& body : model_.bodies()) {
      const mechanics::BodyConditions at = body.at(0);
      factors_.push_back(std::make_unique<mechanics::FactoredBody>(body, at, std::vector<std::int64_t>{}));
      factors_.back()->factorize(at);
      cholmod_.push_back(
          std::make_unique<CholmodFactor>(factors_.back()->stiffness(at), body.constraints().node_of_free()));
      bytes_ += static_cast<double>(factors_.back()->solver().factor_bytes());
      right_.emplace_back(body.constraints().n_free(), 1.0);
      left_.emplace_back(right_.back().size());
    }
  }

  void pass() {
    std::vector<linalg::Substitution> forward, backward;
    for (std::size_t b = 0; b < factors_.size(); ++b) {
      forward.push_back({&factors_[b]->solver(), right_[b], left_[b]});
      backward.push_back({&factors_[b]->solver(), left_[b], right_[b]});
    }
    linalg::forward(forward);
    linalg::backward(backward);
  }
  /// The same for several vectors.
  void pass_of_several(std::size_t vectors) {
    others_.resize(vectors, right_);
    for (const linalg::PassDirection direction : {linalg::PassDirection::forward, linalg::PassDirection::backward}) {
      std::vector<linalg::TaskList*> lists;
      for (std::size_t b = 0; b < factors_.size(); ++b) {
        std::vector<linalg::PassVector> in_place;
        for (auto& vector : others_) in_place.push_back({vector[b], vector[b]});
        lists.push_back(&factors_[b]->solver().tasks_of_several(direction, in_place));
      }
      linalg::run(lists, linalg::pass_in_parallel_from);
    }
  }
  void cholmod_pass() {
    for (const auto& factor : cholmod_) factor->pass();
  }

  /// Work of the busiest of so many threads, as part of all.
  double busiest(std::size_t threads) {
    std::vector<linalg::TaskList*> lists;
    for (std::size_t b = 0; b < factors_.size(); ++b)
      lists.push_back(&factors_[b]->solver().forward_tasks(right_[b], left_[b]));
    std::vector<double> work(threads);
    double all = 0;
    for (const linalg::ListedTask& next : linalg::merged(lists)) {
      const double of_task = next.list->work()[next.task];
      *std::ranges::min_element(work) += of_task;
      all += of_task;
    }
    return std::ranges::max(work) / all;
  }
  double bytes() const { return bytes_; }
  double unknowns() const {
    double sum = 0;
    for (const auto& vector : right_) sum += static_cast<double>(vector.size());
    return sum;
  }

 private:
  model::Model model_;
  std::vector<std::unique_ptr<mechanics::FactoredBody>> factors_;
  std::vector<std::unique_ptr<CholmodFactor>> cholmod_;
  std::vector<std::vector<double>> right_, left_;
  std::vector<std::vector<std::vector<double>>> others_;
  double bytes_ = 0;
};

Factors& factors(std::int64_t size) {
  static std::map<std::int64_t, Factors> all;
  return all.try_emplace(size, size).first->second;
}

void pass(benchmark::State& state) {
  const double read_twice = 2 * factors(state.range(0)).bytes() / bandwidth();
  Factors& all = factors(state.range(0));
  double own = 1e300, alone = 1e300, of_cholmod = 1e300;
  // In turn, so that all see the same machine.
  for ([[maybe_unused]] auto _ : state) {
    omp_set_num_threads(static_cast<int>(state.range(1)));
    own = std::min(own, min_seconds(1, [&] { all.pass(); }));
    omp_set_num_threads(1);
    alone = std::min(alone, min_seconds(1, [&] { all.pass(); }));
    of_cholmod = std::min(of_cholmod, min_seconds(1, [&] { all.cholmod_pass(); }));
  }
  state.counters["unknowns"] = all.unknowns();
  state.counters["factor_MB"] = all.bytes() / 1e6;
  state.counters["of_cholmod"] = own / of_cholmod;
  state.counters["of_the_floor"] = own / read_twice;
  for (const std::size_t threads : {2, 4, 8})
    state.counters[fmt::format("busiest_of_{}", threads)] = all.busiest(threads) * alone / of_cholmod;
}
BENCHMARK(pass)
    ->ArgsProduct({{300, 160, 120, 95}, {1, 2}})  // 13, 44, 79 and 140 thousand unknowns; threads
    ->Unit(benchmark::kMillisecond)
    ->Iterations(12);

/// `of_single` is the time for one of the vectors against that of a pass for it alone.
void pass_of_several(benchmark::State& state) {
  Factors& all = factors(state.range(0));
  const auto vectors = static_cast<std::size_t>(state.range(1));
  omp_set_num_threads(1);
  double together = 1e300, alone = 1e300;
  for ([[maybe_unused]] auto _ : state) {
    together = std::min(together, min_seconds(1, [&] { all.pass_of_several(vectors); }));
    alone = std::min(alone, min_seconds(1, [&] { all.pass(); }));
  }
  state.counters["of_single"] = together / (alone * static_cast<double>(vectors));
}
BENCHMARK(pass_of_several)
    ->ArgsProduct({{300, 160, 120}, {4, 8, 16, 32}})  // unknowns as above; vectors
    ->Unit(benchmark::kMillisecond)
    ->Iterations(8);

}  // namespace
}  // namespace creepcontact::test

BENCHMARK_MAIN();
