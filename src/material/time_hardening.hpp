#pragma once
/// Time hardening (flow theory): f = sum of A_i q^n_i m_i t^(m_i - 1), which at constant stress gives the creep strain
/// sum of A_i q^n_i t^m_i. One term, or a sum as of Graham and Walles (m = 1/3, 1, 3: primary, secondary, tertiary).
/// t is the time of the run: material put under load later creeps as slowly as all of it does then. With m < 1 the rate
/// is infinite at t = 0.
/// Sources: P. G. McVetty, Mechanical Engineering 56 (1934); A. Graham, K. F. A. Walles, J. Iron Steel Inst. 179
/// (1955).

#include "creepcontact/base/index.hpp"
#include "flow_law.hpp"
#include "law_table.hpp"
#include "power_law.hpp"

namespace creepcontact::material {

class TimeHardening final : public FlowLaw {
 public:
  /// @param values  by power_law::Constant; the terms as lists of one length
  /// @throws ParameterError if the lists differ in length
  TimeHardening(std::string name, const ParameterValues& values);
  std::string name() const override { return name_; }
  EquivalentRate equivalent_rate(double q, const PointState& at) const override;
  double start_exponent(const PointState& at) const override;
  void increment(const PointState& at, double duration, PointIncrement into) const override;

 private:
  struct Terms {
    std::span<const double> A, n, m;
  };
  Terms terms(const PointState& at) const;

  std::string name_;
  Index n_terms_;
};

LawInfo time_hardening_info();
LawInfo graham_walles_info();

}  // namespace creepcontact::material
