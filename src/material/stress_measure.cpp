#include "stress_measure.hpp"

namespace creepcontact::material {

StressMeasure::StressMeasure(const Tensor6& stress, double alpha, DamagingTension X) {
  if (alpha < 1.0) {
    const Tensor6 s = tensor::deviator(stress);
    const double q = std::sqrt(1.5) * s.norm();
    value += (1.0 - alpha) * q;
    if (q > 0.0) gradient += (1.0 - alpha) * 1.5 / q * s;
  }
  if (alpha > 0.0 && X == DamagingTension::trace) {
    if (const double trace = tensor::trace(stress); trace > 0.0) {
      value += alpha * trace;
      gradient += alpha * tensor::identity();
    }
  } else if (alpha > 0.0) {
    const tensor::Principal principal(tensor::to_matrix(stress));
    if (const double largest = principal.values[2]; largest > 0.0) {
      const Vector3 direction = principal.directions.col(2);
      value += alpha * largest;
      gradient += alpha * tensor::from_matrix(direction * direction.transpose());
    }
  }
}

}  // namespace creepcontact::material
