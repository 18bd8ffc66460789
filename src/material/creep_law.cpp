#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::material {

void CreepLaw::increment(const Point& at, double duration, double* strain, double* internal) const {
  Tensor6 strain_rate = Tensor6::Zero();
  Eigen::VectorXd internal_rate(n_internal());
  rate(at, strain_rate.data(), internal_rate.data());
  Eigen::Map<Tensor6> own_strain(strain);
  own_strain += duration * strain_rate;
  Eigen::Map<Eigen::VectorXd>(internal, n_internal()) += duration * internal_rate;
}

}  // namespace creepcontact::material
