#include "creepcontact/linalg/factor_store.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "creepcontact/base/checksum.hpp"

namespace creepcontact::linalg {
namespace {

std::uint64_t pattern_of(const StiffnessToAnalyze& matrix) {
  Checksum sum;
  const SparseMatrix& lower = matrix.lower.matrix();
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

struct Key {
  std::uint64_t pattern = 0, values = 0;
  bool operator==(const Key&) const = default;
};

/// What a factor is made of, as far as it is known without a look at the matrix.
struct Origin {
  MatrixInputs inputs;
  std::uint64_t order = 0;  // of its dofs
  bool operator==(const Origin&) const = default;
};

std::optional<Origin> origin_of(const StiffnessToAnalyze& matrix) {
  if (!matrix.lower.inputs()) return std::nullopt;
  Checksum order;
  order.add(matrix.block_of.data(), matrix.block_of.size());
  order.add(matrix.trailing.data(), matrix.trailing.size());
  return Origin{*matrix.lower.inputs(), order.value()};
}

/// A factor, or, while `solver` is null, one that is being computed.
struct Entry {
  Key key;
  std::vector<Origin> origins = {};              // as far as they are known
  std::unique_ptr<StiffnessSolver> solver = {};  // has it; others are made of this one
  int users = 0;
};

}  // namespace

class FactorStore::Content {
 public:
  /// A solver of this pattern, best with the factor of these values. Null: there is none.
  std::unique_ptr<StiffnessSolver> analysed(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const Entry* best = nullptr;
    for (const Entry& entry : entries_)
      if (entry.solver && entry.key.pattern == key.pattern && (best == nullptr || entry.key == key)) best = &entry;
    return best != nullptr ? best->solver->same_pattern() : nullptr;
  }

  /// The key of the factor of this origin, if it is here.
  std::optional<Key> known(const Origin& origin) {
    const std::scoped_lock lock(mutex_);
    for (const Entry& entry : entries_)
      if (entry.solver && std::ranges::find(entry.origins, origin) != entry.origins.end()) return entry.key;
    return std::nullopt;
  }

  /// What a factor in use is made of.
  void learn(const Key& key, const Origin& origin) {
    const std::scoped_lock lock(mutex_);
    std::vector<Origin>& known = find(key)->origins;
    if (std::ranges::find(known, origin) == known.end()) known.push_back(origin);
  }

  /// A solver with this factor, if it is here still. @returns null if not
  std::unique_ptr<StiffnessSolver> take(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = find(key);
    return found != entries_.end() && found->solver ? lend(*found) : nullptr;
  }

  /// A solver with this factor, found or computed by one of the threads that need it. @param own  a solver of the
  /// pattern, used to compute it @param before  the factor that the caller has used so far
  /// @returns whether it was found @throws as StiffnessSolver::factorize()
  bool use(const Key& key, std::optional<Key>& before, std::unique_ptr<StiffnessSolver>& own,
           const SparseMatrix& lower) {
    std::unique_lock lock(mutex_);
    if (before) {
      // What nobody else uses makes room, as it does where there is no store.
      if (Entry& entry = *find(*before); --entry.users == 0 && entry.key != key) entries_.erase(find(*before));
      before.reset();
    }
    for (auto found = find(key); found != entries_.end(); found = find(key)) {
      if (!found->solver) {
        computed_.wait(lock);
        continue;
      }
      own = lend(*found);
      before = key;
      return true;
    }
    entries_.push_back({.key = key, .users = 1});
    lock.unlock();
    std::unique_ptr<StiffnessSolver> copy;
    try {
      own->factorize(lower);
      copy = own->same_pattern();
    } catch (...) {
      lock.lock();
      entries_.erase(find(key));
      computed_.notify_all();
      throw;
    }
    lock.lock();
    find(key)->solver = std::move(copy);
    before = key;
    count_use();
    ++n_computed;
    computed_.notify_all();
    return false;
  }

  void give_back(const Key& key) {
    std::list<Entry> dropped;  // destroyed without the lock
    const std::scoped_lock lock(mutex_);
    const auto entry = find(key);
    --entry->users;
    entries_.splice(entries_.end(), entries_, entry);
    for (auto at = entries_.begin(); entries_.size() > most_in_use_ && at != entries_.end();) {
      const auto next = std::next(at);
      if (at->users == 0) dropped.splice(dropped.end(), entries_, at);
      at = next;
    }
  }

  std::atomic<std::int64_t> n_computed = 0, n_found = 0;

 private:
  std::list<Entry>::iterator find(const Key& key) { return std::ranges::find(entries_, key, &Entry::key); }
  /// A solver with the factor of an entry that has one.
  std::unique_ptr<StiffnessSolver> lend(Entry& entry) {
    std::unique_ptr<StiffnessSolver> solver = entry.solver->same_pattern();
    ++entry.users;
    count_use();
    ++n_found;
    return solver;
  }
  void count_use() {
    const auto in_use = std::ranges::count_if(entries_, [](const Entry& entry) { return entry.users > 0; });
    most_in_use_ = std::max(most_in_use_, static_cast<std::size_t>(in_use));
  }

  std::mutex mutex_;
  std::condition_variable computed_;
  std::list<Entry> entries_;  // the one that came back last at the end
  std::size_t most_in_use_ = 0;
};

/// A solver whose factors are those of the store.
class FactorStore::Lent final : public StiffnessSolver {
 public:
  /// @param analysed  the matrix that was analysed @param origin  of its factor, if it is known
  Lent(std::shared_ptr<Content> content, GatheredPasses* gathering, const Key& analysed, std::optional<Origin> origin,
       std::unique_ptr<StiffnessSolver> solver)
      : content_(std::move(content)),
        gathering_(gathering),
        analysed_(analysed),
        origin_(origin),
        solver_(std::move(solver)) {}
  ~Lent() override {
    solver_.reset();
    if (used_) content_->give_back(*used_);
  }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

  std::unique_ptr<StiffnessSolver> same_pattern() const override { return solver_->same_pattern(); }
  const void* shared_factor() const override { return solver_->shared_factor(); }
  GatheredPasses* gathering() override { return gathering_; }
  void factorize(const SparseMatrix& lower) override {
    const Key key{analysed_.pattern, values_of(lower)};
    found_ = content_->use(key, used_, solver_, lower);
    if (origin_ && key == analysed_) content_->learn(key, *origin_);
  }
  bool take_factor() override {
    if (!origin_ || used_) return false;
    std::unique_ptr<StiffnessSolver> found = content_->take(analysed_);
    if (!found) return false;
    solver_ = std::move(found);
    used_ = analysed_;
    return found_ = true;
  }
  bool found_factor() const override { return found_; }
  std::int64_t size() const override { return solver_->size(); }
  std::int64_t trailing_size() const override { return solver_->trailing_size(); }
  TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override {
    return solver_->forward_tasks(b, y);
  }
  TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override {
    return solver_->backward_tasks(y, x);
  }
  TaskList& tasks_of_several(PassDirection direction, std::span<const PassVector> vectors) override {
    return solver_->tasks_of_several(direction, vectors);
  }
  Eigen::MatrixXd trailing_factor() const override { return solver_->trailing_factor(); }
  std::int64_t factor_bytes() const override { return solver_->factor_bytes(); }
  std::int64_t work_bytes() const override { return solver_->work_bytes(); }
  double rcond() const override { return solver_->rcond(); }
  double error_bound() const override { return solver_->error_bound(); }

 private:
  std::shared_ptr<Content> content_;
  GatheredPasses* gathering_;
  Key analysed_;
  std::optional<Origin> origin_;
  std::unique_ptr<StiffnessSolver> solver_;
  std::optional<Key> used_;
  bool found_ = false;
};

FactorStore::FactorStore() : content_(std::make_shared<Content>()) {}
FactorStore::~FactorStore() = default;

StiffnessSolverFactory FactorStore::lending(GatheredPasses* gathering, StiffnessSolverFactory make) {
  return [content = content_, gathering,
          make = std::move(make)](const StiffnessToAnalyze& matrix) -> std::unique_ptr<StiffnessSolver> {
    const std::optional<Origin> origin = origin_of(matrix);
    std::optional<Key> key = origin ? content->known(*origin) : std::nullopt;
    std::unique_ptr<StiffnessSolver> solver = key ? content->analysed(*key) : nullptr;
    if (!solver) {
      key = {pattern_of(matrix), values_of(matrix.lower)};
      solver = content->analysed(*key);
    }
    if (!solver) solver = make(matrix);
    return std::make_unique<Lent>(content, gathering, *key, origin, std::move(solver));
  };
}

std::int64_t FactorStore::n_computed() const {
  return content_->n_computed;
}
std::int64_t FactorStore::n_found() const {
  return content_->n_found;
}

}  // namespace creepcontact::linalg
