#include "sundials_vector.hpp"

#include <nvector/nvector_serial.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>

#include "../elementwise.hpp"
#include "../error_norm.hpp"
#include "../state_norms.hpp"

namespace creepcontact::ode {

namespace {

/// Begins as that of the serial vector does, so that the operations that need no other member are its own.
struct Content {
  _N_VectorContent_Serial serial;
  const Team* team;
  std::size_t counted;      // entries here that are not padding
  std::size_t all_counted;  // by all members
};
static_assert(std::is_standard_layout_v<Content>);

Content& content(N_Vector v) {
  return *static_cast<Content*>(v->content);
}
std::size_t length(N_Vector v) {
  return NV_LENGTH_S(v);
}
std::span<const double> entries(N_Vector v) {
  return {NV_DATA_S(v), content(v).counted};
}

// z may be x or y in all of these: entry i is read before it is written.

void linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
  const double *p = NV_DATA_S(x), *q = NV_DATA_S(y);
  double* r = NV_DATA_S(z);
  for_each_index(length(z), [=](std::size_t i) { r[i] = a * p[i] + b * q[i]; });
}

void scale(realtype a, N_Vector x, N_Vector z) {
  const double* p = NV_DATA_S(x);
  double* r = NV_DATA_S(z);
  for_each_index(length(z), [=](std::size_t i) { r[i] = a * p[i]; });
}

void fill(realtype a, N_Vector z) {
  double* r = NV_DATA_S(z);
  for_each_index(length(z), [=](std::size_t i) { r[i] = a; });
}

/// z = sum c_k x_k, piece by piece; only x_0 may be z.
int linear_combination(int terms, realtype* c, N_Vector* x, N_Vector z) {
  double* r = NV_DATA_S(z);
  for_each_piece(length(z), [=](std::size_t begin, std::size_t n) {
    auto sum = piece(r, begin, n);
    sum = c[0] * piece(NV_DATA_S(x[0]), begin, n);
    for (int k = 1; k < terms; ++k) sum += c[k] * piece(NV_DATA_S(x[k]), begin, n);
  });
  return 0;
}

// What SUNDIALS takes of all entries, in all that the integrators here use of it.

sunindextype length_of_all(N_Vector v) {
  return std::max<sunindextype>(content(v).all_counted, 1);
}

/// Over the entries of all members that are not padding.
template <typename OfPiece>
double sum_of_all(N_Vector x, OfPiece&& of_piece) {
  return content(x).team->sum(sum_over_pieces(content(x).counted, std::forward<OfPiece>(of_piece)));
}

realtype dot(N_Vector x, N_Vector y) {
  const double *p = NV_DATA_S(x), *q = NV_DATA_S(y);
  return sum_of_all(x,
                    [=](std::size_t begin, std::size_t n) { return (piece(p, begin, n) * piece(q, begin, n)).sum(); });
}

/// Takes the place of the root mean square in every test of CVODE and ARKODE.
realtype weighted_norm(N_Vector x, N_Vector w) {
  return error_norm(*content(x).team, entries(x), entries(w));
}

realtype weighted_euclidean_norm(N_Vector x, N_Vector w) {
  const double *p = NV_DATA_S(x), *q = NV_DATA_S(w);
  return std::sqrt(sum_of_all(
      x, [=](std::size_t begin, std::size_t n) { return (piece(p, begin, n) * piece(q, begin, n)).square().sum(); }));
}

realtype absolute_sum(N_Vector x) {
  const double* p = NV_DATA_S(x);
  return sum_of_all(x, [=](std::size_t begin, std::size_t n) { return piece(p, begin, n).abs().sum(); });
}

realtype largest(N_Vector x) {
  double own = 0;
  for (const double value : entries(x)) own = std::max(own, std::abs(value));
  return content(x).team->max(own);
}

realtype smallest(N_Vector x) {
  double own = std::numeric_limits<double>::max();
  for (const double value : entries(x)) own = std::min(own, value);
  return content(x).team->min(own);
}

N_Vector clone_empty(N_Vector v) {
  const N_Vector result = N_VNewEmpty(v->sunctx);
  if (result == nullptr) return nullptr;
  // Freed by the destructor of the serial vector.
  auto* const own = static_cast<Content*>(std::malloc(sizeof(Content)));
  if (own == nullptr || N_VCopyOps(v, result) != 0) {
    std::free(own);
    N_VFreeEmpty(result);
    return nullptr;
  }
  *own = content(v);
  own->serial.own_data = SUNFALSE;
  own->serial.data = nullptr;
  result->content = own;
  return result;
}

N_Vector clone(N_Vector v) {
  const N_Vector result = clone_empty(v);
  if (result == nullptr) return nullptr;
  content(result).serial.data = static_cast<double*>(std::malloc(length(v) * sizeof(double)));
  if (NV_DATA_S(result) == nullptr) {
    N_VDestroy(result);
    return nullptr;
  }
  content(result).serial.own_data = SUNTRUE;
  return result;
}

}  // namespace

Vector make_vector(const Team& team, std::size_t size, SUNContext context) {
  const Vector serial(N_VNewEmpty_Serial(std::max<std::size_t>(size, 1), context));
  if (!serial) throw std::bad_alloc();
  N_Vector_Ops ops = serial->ops;
  ops->nvclone = clone;
  ops->nvcloneempty = clone_empty;
  ops->nvlinearsum = linear_sum;
  ops->nvscale = scale;
  ops->nvconst = fill;
  ops->nvlinearcombination = linear_combination;
  ops->nvgetlength = length_of_all;
  ops->nvdotprod = dot;
  ops->nvwrmsnorm = weighted_norm;
  ops->nvwl2norm = weighted_euclidean_norm;
  ops->nvl1norm = absolute_sum;
  ops->nvmaxnorm = largest;
  ops->nvmin = smallest;
  // The first clone takes over what the serial vector cannot hold.
  const auto all = static_cast<std::size_t>(team.sum(static_cast<double>(size)));
  Content own{*static_cast<N_VectorContent_Serial>(serial->content), &team, size, all};
  void* const of_serial = std::exchange(serial->content, &own);
  Vector v(clone(serial.get()));
  serial->content = of_serial;
  if (!v) throw std::bad_alloc();
  N_VConst(0.0, v.get());
  return v;
}

}  // namespace creepcontact::ode
