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

void PointPreconditioner::apply_once(const PointsState& at, std::span<const material::StressTangent> tangents,
                                     double gamma, std::span<const double> r, std::span<double> z) {
  numerics::for_each_index(tangents.size(), numerics::parallel_points,
                           [&](std::size_t p) { Local(at, tangents[p], p).apply(gamma, &r[6 * p], &z[6 * p]); });
}

}  // namespace creepcontact::creep
