#pragma once
/// A load f(x, t) times a fixed vector field, with the integral over space done as rarely as f allows.

#include "creepcontact/mechanics/loads.hpp"

namespace creepcontact::mechanics {

/// Integral of N^T (field f) over the loaded domain, for a function f.
class SpatialIntegral {
 public:
  virtual ~SpatialIntegral() = default;
  virtual const std::vector<std::int64_t>& nodes() const = 0;
  /// values (3 per node of nodes()) += integral at time t
  virtual void add(const Function& f, double t, std::span<double> values) const = 0;
  /// The part of the field beyond a plane.
  virtual std::vector<FieldPoint> points_beyond(const Cut& cut) const = 0;
};

/// F(t) = factor(t)^power * integral of f(x, t).
class SeparableLoad final : public Load {
 public:
  SeparableLoad(std::unique_ptr<SpatialIntegral> integral, Function f, Function factor = 1.0, int power = 1);
  void add(double t, std::span<double> forces) const override;
  void append_beyond(const Cut& cut, std::vector<PointForces>& parts) const override {
    parts.emplace_back(integral_->points_beyond(cut), f_, factor_, power_);
  }

 private:
  std::vector<double> integrate(const Function& f, double t) const;

  std::unique_ptr<SpatialIntegral> integral_;
  Function f_, factor_;
  int power_;
  std::vector<double> steady_;  // of f, or of 1 where f does not depend on place; empty if f mixes place and time
};

/// Sum of loads, one per component of a vector.
class SumOfLoads final : public Load {
 public:
  explicit SumOfLoads(std::vector<std::unique_ptr<Load>> parts) : parts_(std::move(parts)) {}
  void add(double t, std::span<double> forces) const override {
    for (const auto& part : parts_) part->add(t, forces);
  }
  void append_beyond(const Cut& cut, std::vector<PointForces>& parts) const override {
    for (const auto& part : parts_) part->append_beyond(cut, parts);
  }

 private:
  std::vector<std::unique_ptr<Load>> parts_;
};

inline double evaluate(const Function& f, const Vector3& x, double t) {
  return f({.x = x[0], .y = x[1], .z = x[2], .t = t});
}

}  // namespace creepcontact::mechanics
