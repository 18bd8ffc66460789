#pragma once
/// A quantity as a probe asks for it.

#include "creepcontact/config/config.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::results {

/// Cylindrical components are those about the probe's axis.
class ProbeQuantity {
 public:
  explicit ProbeQuantity(const config::Probe& probe);
  double operator()(const Sample& sample) const;
  const OutputVariable& variable() const { return *quantity_.variable; }

 private:
  const Quantity& quantity_;
  Matrix3 axes_ =
      Matrix3::Identity();  // rows: two directions across the axis, the first as near to x as may be; the axis
  Vector3 origin_ = Vector3::Zero();
};

}  // namespace creepcontact::results
