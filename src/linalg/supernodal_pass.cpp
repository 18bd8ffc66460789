#include "supernodal_pass.hpp"

#include <algorithm>
#include <cstring>

#include "creepcontact/base/index.hpp"
#include "cut_tree.hpp"
#include "panel_kernels.hpp"
#include "strips.hpp"

namespace creepcontact::linalg {

namespace {

/// Panels after panel p are updated in groups: those that other threads wait for first one by one, later ones together,
/// because long columns are read faster. @param begin  first panel of a group @returns the first after it
std::size_t next_group(std::size_t p, std::size_t begin, std::size_t n_panels) {
  return std::min(begin + std::max<std::size_t>(1, begin - p - 1), n_panels);
}

}  // namespace

struct SupernodalPass::Impl : CutTree {
  class Forward final : public TaskList {
   public:
    explicit Forward(Impl& pass) : pass_(pass) {}
    std::span<const double> work() const override { return pass_.work; }
    void begin() override { pass_.reset(); }
    void run(std::size_t task) noexcept override {
      const Task& t = pass_.tasks[task];
      t.subtree != nullptr ? pass_.forward_subtree(*t.subtree) : pass_.forward_panel(*t.front, t.panel);
    }

   private:
    Impl& pass_;
  };
  class Backward final : public TaskList {
   public:
    explicit Backward(Impl& pass) : pass_(pass) {}
    std::span<const double> work() const override { return pass_.backward_work; }
    void begin() override { pass_.reset(); }
    void run(std::size_t task) noexcept override {
      const Task& t = pass_.tasks[pass_.tasks.size() - 1 - task];
      t.subtree != nullptr ? pass_.backward_subtree(*t.subtree) : pass_.backward_panel(*t.front, t.panel);
    }

   private:
    Impl& pass_;
  };

  explicit Impl(const Supernodes& supernodes);
  Panel panel(std::int64_t s, std::int64_t row, std::int64_t column, std::int64_t n_rows,
              std::int64_t n_columns) const {
    const std::int64_t stride = nodes.n_rows(s);
    return {factor + nodes.first_value[s] + column * stride + row, stride, n_rows, n_columns};
  }
  void begin(const double* entries, std::span<const std::span<const double>> given,
             std::span<const std::span<double>> results);
  void set_width(std::size_t vectors);
  void reset();
  /// Row k of what is given, for all vectors, in the order of the factor if `numbered` is null.
  void load(std::int64_t k, const std::int64_t* numbered, double* row) const {
    const std::int64_t at = numbered != nullptr ? numbered[k] : k;
    for (std::size_t v = 0; v < from.size(); ++v) row[v] = from[v][at];
    for (std::size_t v = from.size(); v < width; ++v) row[v] = 0;
  }
  // Rows are too short for a call of a library, and their length is 1 or a multiple of 4.
  void copy(const double* x_row, double* to) const {
    if (width == 1) *to = *x_row;
    for (std::size_t v = 0; v + 4 <= width; v += 4) std::memcpy(to + v, x_row + v, 4 * sizeof(double));
  }
  void add(const double* x_row, double* to) const {
    if (width == 1) *to += *x_row;
    for (std::size_t v = 0; v + 4 <= width; v += 4) {
      Vector<4> sum, part;
      linalg::load<4>(to + v, sum);
      linalg::load<4>(x_row + v, part);
      sum += part;
      std::memcpy(to + v, &sum, sizeof sum);
    }
  }
  /// Rows begin .. end of the solution into the results, row k at place(k).
  template <typename Place>
  void store(std::int64_t begin, std::int64_t end, const Place& place) const {
    constexpr std::int64_t in_cache = 32;
    for (std::int64_t first = begin; first < end; first += in_cache)
      for (std::size_t v = 0; v < into.size(); ++v)
        for (std::int64_t k = first; k < std::min(end, first + in_cache); ++k)
          into[v][place(k)] = solution[k * width + v];
  }
  /// For a forward pass with several vectors.
  void store_forward(std::int64_t begin, std::int64_t end) const {
    store(begin, end, [](std::int64_t k) { return k; });
  }
  void store_backward(std::int64_t begin, std::int64_t end) const {
    store(begin, end, [this](std::int64_t k) { return nodes.permutation[k]; });
  }
  void forward_subtree(Subtree& subtree);
  void forward_panel(Front& front, std::size_t p);
  void assemble(Front& front);
  void backward_subtree(Subtree& subtree);
  void backward_panel(Front& front, std::size_t p);

  std::vector<double> backward_work;
  /// In the order of the factor, row by row: the back substitution, and the forward pass with several vectors.
  std::vector<double> solution;
  Forward forward{*this};
  Backward backward{*this};

  // of the pass under way
  const double* factor = nullptr;
  std::size_t width = 1;  // vectors, padded()
  std::vector<std::span<const double>> from;
  std::vector<std::span<double>> into;
  double* x = nullptr;  // of the forward pass, as `solution`; with one vector what it is to become itself
};

SupernodalPass::Impl::Impl(const Supernodes& supernodes)
    : CutTree(supernodes), backward_work(work.rbegin(), work.rend()) {
  set_width(1);
}

void SupernodalPass::Impl::set_width(std::size_t vectors) {
  width = vectors;
  const auto n = [&](std::int64_t rows) { return static_cast<std::size_t>(rows) * width; };
  solution.resize(n(std::ssize(nodes.permutation)));
  for (Subtree& subtree : subtrees) {
    subtree.update.resize(n(nodes.n_below(branches[subtree.branch]->root)));
    subtree.work.resize(n(subtree.most_rows));
  }
  for (const auto& front : fronts) {
    const std::int64_t n_rows = nodes.n_rows(branches[front->branch]->root);
    front->values.resize(n(n_rows));
    for (Column& panel : front->panels) panel.update.resize(n(n_rows - panel.end));
  }
}

void SupernodalPass::Impl::begin(const double* entries, std::span<const std::span<const double>> given,
                                 std::span<const std::span<double>> results) {
  if (padded(given.size()) != width) set_width(padded(given.size()));
  factor = entries;
  from.assign(given.begin(), given.end());
  into.assign(results.begin(), results.end());
  x = width == 1 ? into.front().data() : solution.data();
}

void SupernodalPass::Impl::reset() {
  for (const auto& branch : branches) {
    branch->forward_done.reset();
    branch->backward_done.reset();
  }
  for (const auto& front : fronts)
    for (Column& panel : front->panels) panel.progress.reset();
}

void SupernodalPass::Impl::forward_subtree(Subtree& subtree) {
  const auto r = static_cast<std::int64_t>(width);
  const std::int64_t root = branches[subtree.branch]->root;
  const std::int64_t begin = nodes.first_column[subtree.first], end = nodes.first_column[root + 1];
  for (std::int64_t k = begin; k < end; ++k) load(k, nodes.permutation.data(), x + k * r);
  std::ranges::fill(subtree.update, 0.0);
  const std::int32_t* outside = subtree.outside.data();
  double* const local = subtree.work.data();
  for (std::int64_t s = subtree.first; s <= root; ++s) {
    const std::int64_t n = nodes.n_columns(s), n_rows = nodes.n_rows(s), first = nodes.first_column[s];
    std::copy_n(x + first * r, n * r, local);
    std::fill(local + n * r, local + n_rows * r, 0.0);
    eliminate(panel(s, 0, 0, n_rows, n), local, width);
    std::copy_n(local, n * r, x + first * r);
    const std::int64_t* const rows = nodes.rows_of(s).data();
    std::int64_t i = n;
    for (; i < n_rows && rows[i] < end; ++i) add(local + i * r, x + rows[i] * r);
    for (; i < n_rows; ++i) add(local + i * r, &subtree.update[*outside++ * r]);
  }
  if (width > 1) store_forward(begin, end);
  branches[subtree.branch]->forward_done.reach(1);
}

void SupernodalPass::Impl::assemble(Front& front) {
  const auto r = static_cast<std::int64_t>(width);
  const std::int64_t s = branches[front.branch]->root, n = nodes.n_columns(s), first = nodes.first_column[s];
  for (std::int64_t k = 0; k < n; ++k) load(first + k, nodes.permutation.data(), &front.values[k * r]);
  std::fill(front.values.begin() + n * r, front.values.end(), 0.0);
  for (const std::size_t child : front.children) {
    const Branch& branch = *branches[child];
    branch.forward_done.wait_for(1);
    const std::size_t n_update = branch.in_front.size() * width;
    const std::span<double> update = subtree_of[child] >= 0 ? std::span(subtrees[subtree_of[child]].update)
                                                            : std::span(fronts[front_of[child]]->values).last(n_update);
    if (front_of[child] >= 0) {
      for (const Column& panel : fronts[front_of[child]]->panels) {
        const double* const of_panel = panel.update.data() + (panel.update.size() - update.size());
        for (std::size_t i = 0; i < update.size(); ++i) update[i] += of_panel[i];
      }
    }
    for (std::size_t i = 0; i < branch.in_front.size(); ++i)
      add(&update[i * width], &front.values[branch.in_front[i] * r]);
  }
}

void SupernodalPass::Impl::forward_panel(Front& front, std::size_t p) {
  const auto r = static_cast<std::int64_t>(width);
  const std::int64_t s = branches[front.branch]->root, n_rows = nodes.n_rows(s), first = nodes.first_column[s];
  Column& own = front.panels[p];
  const std::int64_t n_own = own.end - own.begin;
  if (p == 0) assemble(front);
  // A panel reaches stage 1 with its own solution, and one more with every further panel whose rows it has updated.
  for (std::size_t q = 0; q < p; ++q) front.panels[q].progress.wait_for(static_cast<std::int32_t>(p - q + 1));
  double* const local = x + (first + own.begin) * r;
  std::copy_n(front.values.data() + own.begin * r, n_own * r, local);
  for (std::size_t q = 0; q < p; ++q) {
    const Column& before = front.panels[q];
    const double* const update = before.update.data() + (own.begin - before.end) * r;
    for (std::int64_t i = 0; i < n_own * r; ++i) local[i] += update[i];
  }
  eliminate(panel(s, own.begin, own.begin, n_own, n_own), local, width);
  own.progress.reach(1);
  std::ranges::fill(own.update, 0.0);
  const std::size_t n_panels = front.panels.size();
  const auto first_row = [&](std::size_t q) {  // the rows below follow the last panel
    return q < n_panels ? front.panels[q].begin : q == n_panels ? nodes.n_columns(s) : n_rows;
  };
  for (std::size_t q = p + 1; q <= n_panels;) {
    const std::int64_t row = first_row(q);
    q = next_group(p, q, n_panels + 1);
    subtract_product(panel(s, row, own.begin, first_row(q) - row, n_own), local,
                     own.update.data() + (row - own.end) * r, width);
    own.progress.reach(static_cast<std::int32_t>(q - p));
  }
  if (width > 1) store_forward(first + own.begin, first + own.end);
  if (p + 1 < n_panels) return;
  for (std::size_t q = 0; q < p; ++q) front.panels[q].progress.wait_for(static_cast<std::int32_t>(p - q + 2));
  branches[front.branch]->forward_done.reach(1);
}

void SupernodalPass::Impl::backward_panel(Front& front, std::size_t p) {
  const auto r = static_cast<std::int64_t>(width);
  const Branch& branch = *branches[front.branch];
  const std::int64_t s = branch.root, n = nodes.n_columns(s), first = nodes.first_column[s];
  const std::span<const std::int64_t> below = nodes.rows_below(s);
  Column& own = front.panels[p];
  const std::int64_t n_own = own.end - own.begin;
  double* const values = front.values.data() + n * r;
  if (p + 1 == front.panels.size()) {
    if (branch.parent >= 0) branches[branch.parent]->backward_done.wait_for(1);
    for (std::size_t i = 0; i < below.size(); ++i) copy(&solution[below[i] * r], values + i * width);
    own.progress.reach(1);
  } else {
    front.panels.back().progress.wait_for(1);
  }
  double* const local = &solution[(first + own.begin) * r];
  for (std::int64_t k = 0; k < n_own; ++k) load(first + own.begin + k, nullptr, local + k * r);
  subtract_transposed_product(panel(s, n, own.begin, std::ssize(below), n_own), values, local, width);
  // The same groups, the one that becomes known last at the end.
  for (std::size_t end = front.panels.size(); end > p + 1;) {
    std::size_t begin = p + 1;
    for (std::size_t next = begin; next < end; next = next_group(p, next, end)) begin = next;
    for (std::size_t q = begin; q < end; ++q) front.panels[q].progress.wait_for(2);
    const std::int64_t row = front.panels[begin].begin;
    subtract_transposed_product(panel(s, row, own.begin, front.panels[end - 1].end - row, n_own),
                                &solution[(first + row) * r], local, width);
    end = begin;
  }
  substitute(panel(s, own.begin, own.begin, n_own, n_own), local, width);
  own.progress.reach(2);
  if (p == 0) branches[front.branch]->backward_done.reach(1);
  store_backward(first + own.begin, first + own.end);
}

void SupernodalPass::Impl::backward_subtree(Subtree& subtree) {
  const auto r = static_cast<std::int64_t>(width);
  const Branch& branch = *branches[subtree.branch];
  if (branch.parent >= 0) branches[branch.parent]->backward_done.wait_for(1);
  const std::span<const std::int64_t> below = nodes.rows_below(branch.root);
  for (std::size_t i = 0; i < below.size(); ++i) copy(&solution[below[i] * r], &subtree.update[i * width]);
  const std::int32_t* outside = subtree.outside.data() + subtree.outside.size();
  double* const local = subtree.work.data();
  const std::int64_t end = nodes.first_column[branch.root + 1];
  for (std::int64_t s = branch.root; s >= subtree.first; --s) {
    const std::int64_t n = nodes.n_columns(s), n_rows = nodes.n_rows(s), first = nodes.first_column[s];
    const std::int64_t* const rows = nodes.rows_of(s).data();
    for (std::int64_t k = 0; k < n; ++k) load(first + k, nullptr, local + k * r);
    std::int64_t i = n_rows;
    for (; i > n && rows[i - 1] >= end; --i) copy(&subtree.update[*--outside * r], local + (i - 1) * r);
    for (; i > n; --i) copy(&solution[rows[i - 1] * r], local + (i - 1) * r);
    substitute(panel(s, 0, 0, n_rows, n), local, width);
    std::copy_n(local, n * r, &solution[first * r]);
  }
  store_backward(nodes.first_column[subtree.first], end);
}

SupernodalPass::SupernodalPass(const Supernodes& supernodes) : impl_(std::make_unique<Impl>(supernodes)) {}
SupernodalPass::~SupernodalPass() = default;

TaskList& SupernodalPass::forward(const double* factor, std::span<const std::span<const double>> b,
                                  std::span<const std::span<double>> y) {
  impl_->begin(factor, b, y);
  return impl_->forward;
}

TaskList& SupernodalPass::backward(const double* factor, std::span<const std::span<const double>> y,
                                   std::span<const std::span<double>> x) {
  impl_->begin(factor, y, x);
  return impl_->backward;
}

}  // namespace creepcontact::linalg
