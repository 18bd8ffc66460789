#include "sundials_vector.hpp"

#include <nvector/nvector_serial.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>

#include "../error_norm.hpp"
#include "delayed_operations.hpp"

namespace creepcontact::ode {

namespace {

/// Begins as that of the serial vector does, so that its macros and its destructor serve.
struct Content {
  _N_VectorContent_Serial serial;
  const Team* team;
  std::size_t counted;         // entries here that are not padding
  std::size_t all_counted;     // by all members
  DelayedOperations* delayed;  // on this vector and all clones of the first one
  std::size_t* vectors;        // that share them
};
static_assert(std::is_standard_layout_v<Content>);

Content& content(N_Vector v) {
  return *static_cast<Content*>(v->content);
}
std::size_t length(N_Vector v) {
  return NV_LENGTH_S(v);
}
void finish(N_Vector v) {
  content(v).delayed->finish(NV_DATA_S(v));
}
/// Delayed with those of z. Operations on x are finished if they are delayed elsewhere.
bool delayed_with(N_Vector z, N_Vector x) {
  const bool together = content(x).delayed == content(z).delayed;
  if (!together) finish(x);
  return together;
}
/// z = operation of x and y. @param c  coefficients of x and y, or the number added
void delay(Elementwise::Kind kind, std::array<double, 2> c, N_Vector x, N_Vector y, N_Vector z) {
  const bool x_later = delayed_with(z, x), y_later = delayed_with(z, y);
  content(z).delayed->add({.kind = kind, .c = c, .x = NV_DATA_S(x), .y = NV_DATA_S(y), .z = NV_DATA_S(z)});
  if (!x_later || !y_later) finish(z);
}
std::span<const double> entries(N_Vector v) {
  finish(v);
  return {NV_DATA_S(v), content(v).counted};
}

double* data(N_Vector v) {
  finish(v);
  return NV_DATA_S(v);
}

using Kind = Elementwise::Kind;

void linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z) {
  delay(Kind::sum, {a, b}, x, y, z);
}
void scale(realtype a, N_Vector x, N_Vector z) {
  delay(Kind::multiple, {a}, x, x, z);
}
void fill(realtype a, N_Vector z) {
  delay(Kind::constant, {a}, z, z, z);
}
void product(N_Vector x, N_Vector y, N_Vector z) {
  delay(Kind::product, {}, x, y, z);
}
void quotient(N_Vector x, N_Vector y, N_Vector z) {
  delay(Kind::quotient, {}, x, y, z);
}
void absolute(N_Vector x, N_Vector z) {
  delay(Kind::absolute, {}, x, x, z);
}
void inverse(N_Vector x, N_Vector z) {
  delay(Kind::inverse, {}, x, x, z);
}
void shift(N_Vector x, realtype a, N_Vector z) {
  delay(Kind::shift, {a}, x, x, z);
}

// What SUNDIALS takes of all entries, in all that the integrators here use of it.

sunindextype length_of_all(N_Vector v) {
  return std::max<sunindextype>(content(v).all_counted, 1);
}

/// Sum of of_piece(begin, length) over the entries here that are not padding.
template <typename OfPiece>
double own_sum(N_Vector x, N_Vector y, const OfPiece& of_piece) {
  delayed_with(x, y);
  return content(x).delayed->finish_and_sum({NV_DATA_S(x), NV_DATA_S(y)}, content(x).counted, of_piece);
}
template <typename OfPiece>
double sum_of_all(N_Vector x, N_Vector y, const OfPiece& of_piece) {
  return content(x).team->sum(own_sum(x, y, of_piece));
}

realtype dot(N_Vector x, N_Vector y) {
  const double *p = NV_DATA_S(x), *q = NV_DATA_S(y);
  return sum_of_all(x, y,
                    [=](std::size_t begin, std::size_t n) { return (piece(p, begin, n) * piece(q, begin, n)).sum(); });
}

/// Takes the place of the root mean square in every test of CVODE and ARKODE.
realtype weighted_norm(N_Vector x, N_Vector w) {
  const double *p = NV_DATA_S(x), *q = NV_DATA_S(w);
  return error_norm(
      *content(x).team, content(x).counted,
      [=](std::size_t begin, std::size_t n) { return piece(p, begin, n) * piece(q, begin, n); },
      [&](std::size_t, const auto& term) { return own_sum(x, w, term); });
}

realtype weighted_euclidean_norm(N_Vector x, N_Vector w) {
  const double *p = NV_DATA_S(x), *q = NV_DATA_S(w);
  return std::sqrt(sum_of_all(x, w, [=](std::size_t begin, std::size_t n) {
    return (piece(p, begin, n) * piece(q, begin, n)).square().sum();
  }));
}

realtype absolute_sum(N_Vector x) {
  const double* p = NV_DATA_S(x);
  return sum_of_all(x, x, [=](std::size_t begin, std::size_t n) { return piece(p, begin, n).abs().sum(); });
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

void destroy(N_Vector v) {
  if (v->content != nullptr) {
    finish(v);  // what is delayed may use it
    if (--*content(v).vectors == 0) {
      delete content(v).delayed;
      delete content(v).vectors;
    }
  }
  N_VDestroy_Serial(v);
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
  ++*own->vectors;
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
  ops->nvdestroy = destroy;
  ops->nvgetarraypointer = data;
  ops->nvlinearsum = linear_sum;
  ops->nvscale = scale;
  ops->nvconst = fill;
  ops->nvprod = product;
  ops->nvdiv = quotient;
  ops->nvabs = absolute;
  ops->nvinv = inverse;
  ops->nvaddconst = shift;
  ops->nvgetlength = length_of_all;
  ops->nvdotprod = dot;
  ops->nvwrmsnorm = weighted_norm;
  ops->nvwl2norm = weighted_euclidean_norm;
  ops->nvl1norm = absolute_sum;
  ops->nvmaxnorm = largest;
  ops->nvmin = smallest;
  // The serial vector's own would not know of what is delayed; no integrator here uses them.
  ops->nvcompare = nullptr;
  ops->nvinvtest = nullptr;
  ops->nvconstrmask = nullptr;
  ops->nvminquotient = nullptr;
  ops->nvwrmsnormmask = nullptr;
  ops->nvsetarraypointer = nullptr;
  // The first clone takes over what the serial vector cannot hold.
  const auto all = static_cast<std::size_t>(team.sum(static_cast<double>(size)));
  auto delayed = std::make_unique<DelayedOperations>(length(serial.get()));
  auto vectors = std::make_unique<std::size_t>(0);
  Content own{*static_cast<N_VectorContent_Serial>(serial->content), &team, size, all, delayed.get(), vectors.get()};
  void* const of_serial = std::exchange(serial->content, &own);
  Vector v(clone(serial.get()));
  serial->content = of_serial;
  serial->ops->nvdestroy = N_VDestroy_Serial;
  if (!v) throw std::bad_alloc();
  static_cast<void>(delayed.release());  // the vectors' own now
  static_cast<void>(vectors.release());
  N_VConst(0.0, v.get());
  return v;
}

}  // namespace creepcontact::ode
