#include "delayed_operations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/instruction_sets.hpp"

namespace creepcontact::ode {

namespace {

/// z may be x or y: entry i is read before it is written.
template <typename Operation>
CREEPCONTACT_INLINE void for_each_entry(std::size_t n, const Operation& operation) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) operation(i);
}

CREEPCONTACT_LONG_VECTORS
void run_operation(Elementwise::Kind kind, double a, double b, const double* x, const double* y, double* z,
                   std::size_t n) {
  using Kind = Elementwise::Kind;
  switch (kind) {
    case Kind::sum:
      return for_each_entry(n, [=](std::size_t i) { z[i] = a * x[i] + b * y[i]; });
    case Kind::multiple:
      return for_each_entry(n, [=](std::size_t i) { z[i] = a * x[i]; });
    case Kind::constant:
      return for_each_entry(n, [=](std::size_t i) { z[i] = a; });
    case Kind::product:
      return for_each_entry(n, [=](std::size_t i) { z[i] = x[i] * y[i]; });
    case Kind::quotient:
      return for_each_entry(n, [=](std::size_t i) { z[i] = x[i] / y[i]; });
    case Kind::absolute:
      return for_each_entry(n, [=](std::size_t i) { z[i] = std::abs(x[i]); });
    case Kind::inverse:
      return for_each_entry(n, [=](std::size_t i) { z[i] = 1 / x[i]; });
    case Kind::shift:
      return for_each_entry(n, [=](std::size_t i) { z[i] = x[i] + a; });
  }
}

}  // namespace

void Elementwise::operator()(std::size_t begin, std::size_t n) const {
  run_operation(kind, c[0], c[1], x + begin, y + begin, z + begin, n);
}

void DelayedOperations::run(const std::vector<Elementwise>& due) const {
  if (due.empty()) return;
  for_each_piece(length_, [&](std::size_t begin, std::size_t n) {
    for (const Elementwise& operation : due) operation(begin, n);
  });
}

void DelayedOperations::finish_all() {
  run(std::exchange(waiting_, {}));
}

void DelayedOperations::finish(const double* vector) {
  run(take({vector}, {vector}));
}

std::vector<Elementwise> DelayedOperations::take(std::vector<const double*> read, std::vector<const double*> written) {
  const auto is_in = [](const std::vector<const double*>& vectors, const double* vector) {
    return std::ranges::find(vectors, vector) != vectors.end();
  };
  std::vector<Elementwise> due, left;
  for (std::size_t k = waiting_.size(); k-- > 0;) {
    const Elementwise& operation = waiting_[k];
    if (is_in(read, operation.z) || is_in(written, operation.z) || is_in(written, operation.x) ||
        is_in(written, operation.y)) {
      due.push_back(operation);
      read.insert(read.end(), {operation.x, operation.y});
      written.push_back(operation.z);
    } else {
      left.push_back(operation);
    }
  }
  std::ranges::reverse(due);
  std::ranges::reverse(left);
  waiting_ = std::move(left);
  return due;
}

}  // namespace creepcontact::ode
