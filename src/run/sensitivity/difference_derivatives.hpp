#pragma once
/// Derivatives by differences of models that run next to the run, each with its own contact, slip and plastic flow.
/// Source: Bock (1981).

#include "derivatives.hpp"
#include "variants.hpp"

namespace creepcontact::run {

class DifferenceDerivatives final : public Derivatives {
 public:
  /// @param variants  of these values
  DifferenceDerivatives(const std::vector<ChangedValue>& values, std::unique_ptr<Variants> variants);

  void rate(double t, std::span<const double> whole, std::span<double> rate) override;
  void start_increment(double t, std::span<const double> whole, double stress_time, double duration,
                       std::span<double> change) override;
  void jacobian_times(double t, std::span<const double> whole, std::span<const double> v,
                      std::span<double> product) override;
  void accept(double t, std::span<const double> whole) override;
  bool rate_has_jumped() const override { return rate_has_jumped_; }
  void forget_evaluations() override;
  void pass_breakpoint(double t, std::span<const double> whole) override;
  void follow_loads(double t) override;
  std::vector<OfProbes> of_probes(double t, std::span<const double> whole) override;
  bool are_differences() const override { return true; }
  void save(creep::Memory& memory) const override;
  void restore(const creep::Memory& memory) override;
  void resume(double t, std::span<const double> whole) override;

 private:
  /// The derivatives of what the variants have left in results_.
  void differentiate(std::span<double> blocks, bool adds) const;

  std::unique_ptr<Variants> variants_;
  std::vector<std::vector<double>> results_;  // of the variants
  bool rate_has_jumped_ = false;
};

}  // namespace creepcontact::run
