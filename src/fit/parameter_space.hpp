#pragma once
/// Fitted parameters as unknowns without units, of the order of one and hardly coupled.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "creepcontact/fit/law_choice.hpp"

namespace creepcontact::fit {

/// The unknowns x of a fit. A parameter p that must not be negative is exp(x) U / f, any other x U / f. U is its unit
/// at reference values of stress and time in the middle of the data. f is its thermal activation exp(-Q/(R (T - zero)))
/// at a reference temperature, or 1/f for times and viscosities. So x belongs to the middle of the data, and an
/// exponent or an activation energy turns the law about it instead of shifting it by decades.
class ParameterSpace {
 public:
  /// @param choice, data  must outlive the object
  ParameterSpace(const LawChoice& choice, const TestData& data);

  std::size_t size() const { return choice_.fitted.size(); }
  const material::ParameterInfo& parameter(std::size_t i) const { return choice_.parameter(i); }
  bool is_logarithmic(std::size_t i) const { return !(parameter(i).minimum < 0); }

  /// Fitted parameters in the user's units.
  Eigen::VectorXd values(const Eigen::VectorXd& x) const;
  /// d(values)/dx, or d(log values)/dx for those that are logarithmic.
  Eigen::MatrixXd slopes(const Eigen::VectorXd& x) const;
  /// The law with these parameters. @throws material::ParameterError if the law cannot have them
  std::shared_ptr<const material::CreepLaw> law(const Eigen::VectorXd& x) const;

  /// Bounds of the registry, and limits beyond which a number is not usable as a parameter.
  Eigen::VectorXd lower() const { return bounds(true); }
  Eigen::VectorXd upper() const { return bounds(false); }
  /// Bounds of sensible first guesses. @param strain  of the order of those measured
  Eigen::VectorXd lowest_guess(double strain) const;
  Eigen::VectorXd highest_guess() const;
  /// The first one with a unit of stress or time: the law's rate or strain is nearly in proportion to it; size(): none.
  std::size_t amplitude() const;

 private:
  Eigen::VectorXd bounds(bool low) const;
  material::ParameterValues all_values(const Eigen::VectorXd& fitted) const;
  double unit(std::size_t i, const Eigen::VectorXd& fitted) const;
  double activation(std::size_t i, const Eigen::VectorXd& fitted) const;
  bool has_dimension(std::size_t i) const;
  bool is_energy(std::size_t i) const { return choice_.info->is_activation_energy(choice_.fitted[i]); }
  void find_activated();

  const LawChoice& choice_;
  double stress_ = 1, time_ = 1;                          // references
  double temperature_ = 0, thermal_energy_ = 1;           // the same, and R (T - zero)
  std::vector<std::optional<std::size_t>> activated_by_;  // per unknown: that which is its activation energy
};

}  // namespace creepcontact::fit
