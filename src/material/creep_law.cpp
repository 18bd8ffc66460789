#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

CreepLaw::CreepLaw(const ParameterValues& constants) {
  for (const std::vector<Function>& values : constants) {
    parameters_.insert(parameters_.end(), values.begin(), values.end());
    first_.push_back(parameters_.size());
  }
}

void CreepLaw::increment(const PointState& at, double duration, PointIncrement into) const {
  Tensor6 strain_rate = Tensor6::Zero();
  std::vector<double> internal_rate(n_internal());
  rate(at, {tensor::writable(strain_rate), internal_rate});
  into.creep_strain += duration * strain_rate;
  for (std::size_t i = 0; i < internal_rate.size(); ++i) into.internal[i] += duration * internal_rate[i];
}

}  // namespace creepcontact::material
