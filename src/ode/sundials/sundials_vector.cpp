#include "sundials_vector.hpp"

#include <nvector/nvector_serial.h>

#include <cmath>
#include <new>

#include "../elementwise.hpp"
#include "../error_norm.hpp"

namespace creepcontact::ode {

namespace {

std::size_t length(N_Vector v) {
  return NV_LENGTH_S(v);
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

realtype dot(N_Vector x, N_Vector y) {
  const double *p = NV_DATA_S(x), *q = NV_DATA_S(y);
  return sum_over_pieces(
      length(x), [=](std::size_t begin, std::size_t n) { return (piece(p, begin, n) * piece(q, begin, n)).sum(); });
}

/// Takes the place of the root mean square in every test of CVODE and ARKODE.
realtype weighted_norm(N_Vector x, N_Vector w) {
  return error_norm({NV_DATA_S(x), length(x)}, {NV_DATA_S(w), length(w)});
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

}  // namespace

Vector make_vector(std::size_t size, SUNContext context) {
  Vector v(N_VNew_Serial(static_cast<sunindextype>(size), context));
  if (!v) throw std::bad_alloc();
  v->ops->nvlinearsum = linear_sum;
  v->ops->nvscale = scale;
  v->ops->nvconst = fill;
  v->ops->nvdotprod = dot;
  v->ops->nvwrmsnorm = weighted_norm;
  v->ops->nvlinearcombination = linear_combination;
  N_VConst(0.0, v.get());
  return v;
}

}  // namespace creepcontact::ode
