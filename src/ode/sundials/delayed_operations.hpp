#pragma once
/// Elementwise operations on long vectors, delayed and then done together. An integrator works on ten vectors and more
/// by dozens of operations per step; each alone would read and write whole vectors from and to the memory. Together
/// they run piece by piece, each piece of all vectors in the cache. Operations that the wanted vector does not depend
/// on wait on. The order of the operations on an entry stays the same, so the bits do too.

#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "../elementwise.hpp"

namespace creepcontact::ode {

/// z = c0 x + c1 y, c0 x, c0, x y, x / y, |x|, 1 / x or x + c0. z may be one of its arguments.
struct Elementwise {
  enum class Kind { sum, multiple, constant, product, quotient, absolute, inverse, shift };

  Kind kind;
  std::array<double, 2> c;
  const double *x, *y;
  double* z;

  /// @param n  entries from `begin` on
  void operator()(std::size_t begin, std::size_t n) const;
};

/// Operations on vectors of one length, each known by its first entry, in order. Use from one thread at a time.
class DelayedOperations {
 public:
  explicit DelayedOperations(std::size_t length) : length_(length) {}

  void add(const Elementwise& operation) {
    waiting_.push_back(operation);
    if (waiting_.size() >= most) finish_all();
  }
  void finish_all();
  /// What reads or writes this vector, and all that goes before.
  void finish(const double* vector);
  /// Finishes what these vectors depend on, and sums term(begin, length) over the pieces of the first `counted` entries
  /// in the same pass.
  template <typename Term>
  double finish_and_sum(std::initializer_list<const double*> vectors, std::size_t counted, const Term& term) {
    const std::vector<Elementwise> due = take(vectors, {});
    const double sum = sum_over_pieces(counted, [&](std::size_t begin, std::size_t n) {
      for (const Elementwise& operation : due) operation(begin, n);
      return term(begin, n);
    });
    for (const Elementwise& operation : due) operation(counted, length_ - counted);  // padding
    return sum;
  }

 private:
  static constexpr std::size_t most = 100;

  /// Removes from what is waiting all operations that write vectors to be read, or that read or write vectors to be
  /// written, and those that must go before them.
  std::vector<Elementwise> take(std::vector<const double*> read, std::vector<const double*> written);
  void run(const std::vector<Elementwise>& due) const;

  std::size_t length_;
  std::vector<Elementwise> waiting_;
};

}  // namespace creepcontact::ode
