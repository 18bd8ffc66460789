#include "creepcontact/creep/point_preconditioner.hpp"

#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::creep {

void PointPreconditioner::linearize(const PointsState& at, std::span<const material::StressTangent> tangents) {
  locals_.resize(tangents.size());
  numerics::for_each_index(locals_.size(), numerics::parallel_points, [&](std::size_t p) {
    const material::StressTangent& part = tangents[p];
    Local& local = locals_[p];
    tensor::Map direction = tensor::writable(local.direction, 0);
    direction = tensor::deviator(tensor::view(at.stress, p));
    if (const double length = direction.norm(); length > 0) direction /= length;
    const material::Moduli& moduli = at.elastic.at(p);
    local.deviatoric = 2 * moduli.mu * part.deviatoric;
    local.radial = 2 * moduli.mu * part.radial;
    local.volumetric = (3 * moduli.lambda + 2 * moduli.mu) * part.volumetric;
  });
}

void PointPreconditioner::apply(double gamma, std::span<const double> r, std::span<double> z) const {
  numerics::for_each_index(locals_.size(), numerics::parallel_points, [&](std::size_t p) {
    const Local& local = locals_[p];
    const double a = gamma * local.deviatoric;
    const double b = gamma * local.radial;
    const tensor::ConstMap direction = tensor::view(local.direction, 0);
    const tensor::ConstMap right(&r[stride_ * p]);
    tensor::Map result(&z[stride_ * p]);
    const double mean = tensor::trace(right) / 3;
    Tensor6 deviator = right;
    deviator.head<3>().array() -= mean;
    result = (deviator - (b / (1 + a + b)) * direction.dot(deviator) * direction) / (1 + a);
    result.head<3>().array() += mean / (1 + gamma * local.volumetric);
    for (std::size_t k = 6; k < stride_; ++k) z[stride_ * p + k] = r[stride_ * p + k];
  });
}

}  // namespace creepcontact::creep
