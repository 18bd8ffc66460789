#include "creepcontact/linalg/factor_store.hpp"

#include <algorithm>
#include <atomic>
#include <list>
#include <mutex>
#include <optional>
#include <utility>

#include "creepcontact/base/checksum.hpp"

namespace creepcontact::linalg {
namespace {

std::uint64_t pattern_of(const StiffnessToAnalyze& matrix) {
  Checksum sum;
  const SparseMatrix& lower = matrix.lower;
  sum.add(lower.outerIndexPtr(), static_cast<std::size_t>(lower.cols() + 1));
  sum.add(lower.innerIndexPtr(), static_cast<std::size_t>(lower.nonZeros()));
  sum.add(matrix.block_of.data(), matrix.block_of.size());
  sum.add(matrix.trailing.data(), matrix.trailing.size());
  return sum.value();
}

std::uint64_t values_of(const SparseMatrix& lower) {
  Checksum sum;
  sum.add(lower.valuePtr(), static_cast<std::size_t>(lower.nonZeros()));
  return sum.value();
}

/// A solver with what it was made of.
struct Kept {
  std::uint64_t pattern = 0;
  std::optional<std::uint64_t> values;  // of the matrix that is factored; nullopt: none is
  std::unique_ptr<StiffnessSolver> solver;
};

}  // namespace

class FactorStore::Content {
 public:
  /// One of this pattern, best with these values. @returns none if there is none
  std::optional<Kept> take(std::uint64_t pattern, std::uint64_t values) {
    const std::scoped_lock lock(mutex_);
    max_lent_ = std::max(max_lent_, ++n_lent_);
    auto best = idle_.end();
    for (auto at = idle_.begin(); at != idle_.end(); ++at)
      if (at->pattern == pattern && (best == idle_.end() || at->values == values)) best = at;
    if (best == idle_.end()) return std::nullopt;
    Kept taken = std::move(*best);
    idle_.erase(best);
    return taken;
  }
  void give_back(Kept kept) {
    std::list<Kept> dropped;  // destroyed without the lock
    const std::scoped_lock lock(mutex_);
    --n_lent_;
    if (kept.values) idle_.push_back(std::move(kept));
    while (idle_.size() > max_lent_) dropped.splice(dropped.end(), idle_, idle_.begin());
  }

  std::atomic<std::int64_t> computed = 0, found = 0;

 private:
  std::mutex mutex_;
  std::list<Kept> idle_;  // the one that came back last at the end
  std::size_t n_lent_ = 0, max_lent_ = 0;
};

/// A solver that goes back to the store.
class FactorStore::Lent final : public StiffnessSolver {
 public:
  Lent(std::shared_ptr<Content> content, Kept kept) : content_(std::move(content)), kept_(std::move(kept)) {}
  ~Lent() override { content_->give_back(std::move(kept_)); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

  std::unique_ptr<StiffnessSolver> same_pattern() const override { return kept_.solver->same_pattern(); }
  void factorize(const SparseMatrix& lower) override {
    const std::uint64_t values = values_of(lower);
    found_ = kept_.values == values;
    if (found_) {
      ++content_->found;
      return;
    }
    kept_.values.reset();
    kept_.solver->factorize(lower);
    kept_.values = values;
    ++content_->computed;
  }
  bool found_factor() const override { return found_; }
  std::int64_t size() const override { return kept_.solver->size(); }
  std::int64_t trailing_size() const override { return kept_.solver->trailing_size(); }
  TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override {
    return kept_.solver->forward_tasks(b, y);
  }
  TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override {
    return kept_.solver->backward_tasks(y, x);
  }
  Eigen::MatrixXd trailing_factor() const override { return kept_.solver->trailing_factor(); }
  std::int64_t factor_bytes() const override { return kept_.solver->factor_bytes(); }
  std::int64_t work_bytes() const override { return kept_.solver->work_bytes(); }
  double rcond() const override { return kept_.solver->rcond(); }
  double error_bound() const override { return kept_.solver->error_bound(); }

 private:
  std::shared_ptr<Content> content_;
  Kept kept_;
  bool found_ = false;
};

FactorStore::FactorStore() : content_(std::make_shared<Content>()) {}
FactorStore::~FactorStore() = default;

StiffnessSolverFactory FactorStore::lending(StiffnessSolverFactory make) {
  return [content = content_,
          make = std::move(make)](const StiffnessToAnalyze& matrix) -> std::unique_ptr<StiffnessSolver> {
    const std::uint64_t pattern = pattern_of(matrix);
    std::optional<Kept> kept = content->take(pattern, values_of(matrix.lower));
    if (!kept) try {
        kept = Kept{pattern, std::nullopt, make(matrix)};
      } catch (...) {
        content->give_back({});
        throw;
      }
    return std::make_unique<Lent>(content, std::move(*kept));
  };
}

std::int64_t FactorStore::n_computed() const {
  return content_->computed;
}
std::int64_t FactorStore::n_found() const {
  return content_->found;
}

}  // namespace creepcontact::linalg
