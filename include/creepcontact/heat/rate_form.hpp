#pragma once
/// Heat conduction as ordinary differential equations, dT/dt = C(T)^-1 (q(t, T) - K(T) T), for a state that has other
/// parts too and integrators of such equations. The conductances of interfaces may depend on contact.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/heat/conduction.hpp"

namespace creepcontact::heat {

class KeptFactor;

/// Where temperatures are given, entries of T do not count, and rates are those of the given ones. One thread at a
/// time.
class RateForm {
 public:
  explicit RateForm(const Definition& definition);
  ~RateForm();

  Conduction& problem() { return problem_; }
  std::size_t size() const { return problem_.size(); }

  /// @param rate  overwritten. Cost: a pass through the elements and a solve with C; if capacities depend on T, about
  /// five passes with conjugate gradients
  void rate(double t, std::span<const double> T, const ContactAtNodes& contact, std::span<double> rate);
  /// The change of the rate for small changes of T and of contact, by central differences: exact where nothing is
  /// nonlinear. Cost: as two rates
  void derivative(double t, std::span<const double> T, const ContactAtNodes& contact, std::span<const double> T_change,
                  const ContactAtNodes& contact_change, std::span<double> product);

  /// Makes C and K at this point those of precondition().
  void prepare(double t, std::span<const double> T, const ContactAtNodes& contact);
  /// z = (C + gamma K)^-1 C r, an approximation of (1 - gamma J)^-1 r at constant contact. A factor serves values of
  /// gamma within a quarter.
  void precondition(double gamma, std::span<const double> r, std::span<double> z);

  /// Temperatures of a steady state at these conductances. See Conduction::steady()
  void steady(double t, const ContactAtNodes& contact, std::span<double> T) { problem_.steady(t, T, contact); }
  /// The change of steady temperatures for a change of contact; nullopt where nothing holds them, as before the first
  /// film acts. Cost: a factorisation
  std::optional<std::vector<double>> steady_change(double t, std::span<const double> T, const ContactAtNodes& contact,
                                                   const ContactAtNodes& contact_change);

 private:
  /// x = C(T)^-1 x
  void solve_capacity(double t, std::span<const double> T, std::span<double> x);

  Conduction problem_;
  std::unique_ptr<KeptFactor> capacity_, both_, steady_;
  linalg::SparseMatrix capacity_matrix_, both_matrix_, steady_matrix_;  // of the factors
  linalg::SparseMatrix prepared_capacity_, prepared_conduction_;
  bool has_capacity_ = false;  // in capacity_
  double gamma_ = 0;           // of both_; 0: not made
};

}  // namespace creepcontact::heat
