#pragma once
/// Loops over the state, shared out among the OpenMP threads where it is long enough to pay.

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::ode {

/// operation(i) for i = 0 .. n-1, in no particular order.
template <typename Operation>
void for_each_index(std::size_t n, Operation operation) {
#pragma omp parallel for simd schedule(static) if (parallel : n >= numerics::parallel_entries)
  for (std::size_t i = 0; i < n; ++i) operation(i);
}

/// Entries that stay in the innermost cache while they are worked on.
inline constexpr std::size_t piece_length = 256;

/// operation(begin, length) for consecutive pieces of 0 .. n-1.
template <typename Operation>
void for_each_piece(std::size_t n, Operation operation) {
#pragma omp parallel for schedule(static) if (n >= numerics::parallel_entries)
  for (std::size_t begin = 0; begin < n; begin += piece_length) operation(begin, std::min(piece_length, n - begin));
}

/// Sum of term(begin, length) over the same pieces, added in their order: the same bits whatever the threads do.
template <typename Term>
double sum_over_pieces(std::size_t n, Term term) {
  static thread_local std::vector<double> kept;  // allocated once
  std::vector<double>& part = kept;              // of the calling thread
  part.resize((n + piece_length - 1) / piece_length);
#pragma omp parallel for schedule(static) if (n >= numerics::parallel_entries)
  for (std::size_t p = 0; p < part.size(); ++p)
    part[p] = term(p * piece_length, std::min(piece_length, n - p * piece_length));
  double sum = 0;
  for (const double value : part) sum += value;
  return sum;
}

/// Entries begin .. begin+length-1 as an Eigen array: vectorised by every compiler, reductions included.
inline Eigen::Map<const Eigen::ArrayXd> piece(const double* data, std::size_t begin, std::size_t length) {
  return {data + begin, static_cast<Index>(length)};
}
inline Eigen::Map<Eigen::ArrayXd> piece(double* data, std::size_t begin, std::size_t length) {
  return {data + begin, static_cast<Index>(length)};
}

}  // namespace creepcontact::ode
