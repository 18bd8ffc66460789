#include "delayed_operations.hpp"

#include <algorithm>
#include <utility>

namespace creepcontact::ode {

void Elementwise::operator()(std::size_t begin, std::size_t n) const {
  const auto a = piece(x, begin, n), b = piece(y, begin, n);
  auto result = piece(z, begin, n);
  switch (kind) {
    case Kind::sum:
      result = c[0] * a + c[1] * b;
      return;
    case Kind::multiple:
      result = c[0] * a;
      return;
    case Kind::constant:
      result.setConstant(c[0]);
      return;
    case Kind::product:
      result = a * b;
      return;
    case Kind::quotient:
      result = a / b;
      return;
    case Kind::absolute:
      result = a.abs();
      return;
    case Kind::inverse:
      result = a.inverse();
      return;
    case Kind::shift:
      result = a + c[0];
      return;
  }
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
