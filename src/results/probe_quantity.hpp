#pragma once
/// A quantity as a probe asks for it.

#include "creepcontact/config/config.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::results {

/// Rows: two directions across an axis, the first as near to x as may be; the axis.
Matrix3 cylindrical_axes(const Vector3& axis);
/// The sample as an observer with these axes sees it, so that its cylindrical components are those about the third.
Sample turned(const Sample& sample, const Matrix3& axes, const Vector3& origin);

/// Cylindrical components are those about the probe's axis.
class ProbeQuantity {
 public:
  explicit ProbeQuantity(const config::Probe& probe);
  double operator()(const Sample& sample) const;
  const OutputVariable& variable() const { return *quantity_.variable; }

 private:
  const Quantity& quantity_;
  Matrix3 axes_;
  Vector3 origin_ = Vector3::Zero();
};

}  // namespace creepcontact::results
