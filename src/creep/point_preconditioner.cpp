#include "creepcontact/creep/point_preconditioner.hpp"

#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::creep {

inline PointPreconditioner::Local::Local(const PointsState& at, const material::StressTangent& tangent, std::size_t p) {
  tensor::Map unit = tensor::writable(direction, 0);
  unit = tensor::deviator(tensor::view(at.stress, p));
  if (const double length = unit.norm(); length > 0) unit /= length;
  const material::Moduli& moduli = at.elastic.at(p);
  deviatoric = 2 * moduli.mu * tangent.deviatoric;
  radial = 2 * moduli.mu * tangent.radial;
  volumetric = (3 * moduli.lambda + 2 * moduli.mu) * tangent.volumetric;
}

inline void PointPreconditioner::Local::apply(double gamma, const double* r, double* z) const {
  const double a = gamma * deviatoric, b = gamma * radial;
  const tensor::ConstMap unit = tensor::view(direction, 0);
  const tensor::ConstMap right(r);
  tensor::Map result(z);
  const double mean = tensor::trace(right) / 3;
  Tensor6 deviator = right;
  deviator.head<3>().array() -= mean;
  result = (deviator - (b / (1 + a + b)) * unit.dot(deviator) * unit) / (1 + a);
  result.head<3>().array() += mean / (1 + gamma * volumetric);
}

void PointPreconditioner::linearize(const PointsState& at, std::span<const material::StressTangent> tangents) {
  locals_.resize(tangents.size());
  numerics::for_each_index(locals_.size(), numerics::parallel_points,
                           [&](std::size_t p) { locals_[p] = Local(at, tangents[p], p); });
}

void PointPreconditioner::apply(double gamma, std::span<const double> r, std::span<double> z) const {
  numerics::for_each_index(locals_.size(), numerics::parallel_points,
                           [&](std::size_t p) { locals_[p].apply(gamma, &r[6 * p], &z[6 * p]); });
}

namespace {

/// PointPreconditioner::apply() at one point, without a root.
/// @param stress, r, z  six numbers each
inline void apply_at(const double* stress, const material::Moduli& moduli, const material::StressTangent& tangent,
                     double gamma, const double* r, double* z) {
  const double a = 2 * gamma * moduli.mu * tangent.deviatoric, b = 2 * gamma * moduli.mu * tangent.radial;
  const double mean_stress = (stress[0] + stress[1] + stress[2]) / 3, mean = (r[0] + r[1] + r[2]) / 3;
  std::array<double, 6> s, d;
  double along = 0, square = 0;
#pragma GCC unroll 6
  for (std::size_t i = 0; i < 6; ++i) {
    s[i] = i < 3 ? stress[i] - mean_stress : stress[i];
    d[i] = i < 3 ? r[i] - mean : r[i];
    along += s[i] * d[i];
    square += s[i] * s[i];
  }
  const double back = square > 0 ? b * along / ((1 + a + b) * square) : 0, inverse = 1 / (1 + a);
  const double volumetric = mean / (1 + gamma * (3 * moduli.lambda + 2 * moduli.mu) * tangent.volumetric);
#pragma GCC unroll 6
  for (std::size_t i = 0; i < 6; ++i) z[i] = (d[i] - back * s[i]) * inverse + (i < 3 ? volumetric : 0);
}

}  // namespace

void PointPreconditioner::apply_once(const PointsState& at, std::span<const material::StressTangent> tangents,
                                     double gamma, std::span<const double> r, std::span<double> z) {
  numerics::for_each_index(tangents.size(), numerics::parallel_points, [&](std::size_t p) {
    apply_at(&at.stress[6 * p], at.elastic.at(p), tangents[p], gamma, &r[6 * p], &z[6 * p]);
  });
}

}  // namespace creepcontact::creep
