#pragma once
/// The creep law of RCC-MR: at constant stress the primary creep strain C1 q^n1 t^C2 up to the time t_fp = C3 q^n3,
/// then secondary creep at the rate C q^n. As in strain hardening, the rate depends on the strain eps that has
/// accumulated: primary creep lasts while eps is below C1 q^n1 t_fp^C2. It ends earlier if its rate has fallen to that
/// of secondary creep, the time that C3 and n3 approximate. If it is still faster at t_fp, the rate falls as eps^-20
/// from there: a jump would let neighbouring stages alternate without end wherever the stress relaxes.
/// Source: AFCEN, RCC-MR, Appendix A3 (A3.1S, A3.3S); strain in percent there, as a fraction here.

#include "hardening_law.hpp"
#include "law_table.hpp"

namespace creepcontact::material {

class RccMr final : public HardeningLaw {
 public:
  enum Constant {
    C1,  ///< [1/(time^C2 stress^n1)], >= 0
    C2,  ///< [-], in (0, 1], the same at all temperatures
    n1,  ///< [-], >= 1
    C,   ///< [1/(time stress^n)], >= 0
    n,   ///< [-], >= 1
    C3,  ///< [time/stress^n3], >= 0; 0: see above
    n3,  ///< [-]
    n_constants
  };
  /// @throws ParameterError if C2 is not in its range
  explicit RccMr(const ParameterValues& values);
  std::string name() const override { return "rcc_mr"; }
  double equivalent_rate(double q, double eps, const PointState& at) const override;
  HardeningRate linearized_rate(double q, double eps, const PointState& at) const override;
  double accumulated(double q, double eps, const PointState& at, double duration) const override;
  /// C2, where there is primary creep: wherever a load begins or jumps, some point may be virgin.
  double start_exponent(const PointState& at) const override;

 private:
  struct Stages;
};

LawInfo rcc_mr_info();

}  // namespace creepcontact::material
