#include "creepcontact/creep/point_preconditioner.hpp"

#include <limits>

#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::creep {

inline PointPreconditioner::Local::Local(const PointsState& at, const material::StressTangent& tangent, std::size_t p) {
  tensor::Map own = tensor::writable(deviator, 0);
  own = tensor::deviator(tensor::view(at.stress, p));
  const double square = own.squaredNorm();
  inverse_square = square > std::numeric_limits<double>::min() ? 1 / square : 0;
  const material::Moduli& moduli = at.elastic.at(p);
  deviatoric = 2 * moduli.mu * tangent.deviatoric;
  radial = 2 * moduli.mu * tangent.radial;
  volumetric = (3 * moduli.lambda + 2 * moduli.mu) * tangent.volumetric;
}

inline void PointPreconditioner::Local::apply(double gamma, const double* r, double* z) const {
  const double a = 1 + gamma * deviatoric, b = gamma * radial, share = 1 / a;
  const tensor::ConstMap own = tensor::view(deviator, 0);
  const tensor::ConstMap right(r);
  tensor::Map result(z);
  const double mean = tensor::trace(right) / 3;
  const double along = b / (a + b) * inverse_square * own.dot(right);  // the deviator has no mean part
  result = share * (right - along * own);
  const double own_mean = volumetric == 0 ? mean : mean / (1 + gamma * volumetric);
  result.head<3>().array() += own_mean - share * mean;
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
