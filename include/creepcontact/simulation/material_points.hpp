#pragma once
/// The creep laws of one body at all its integration points: rates, their derivative, and the point-wise
/// preconditioner.

#include <optional>
#include <span>
#include <vector>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::simulation {

class MaterialPoints {
 public:
  /// @param body must outlive the object
  explicit MaterialPoints(mechanics::Body& body);

  bool empty() const { return stride_ == 0; }
  std::size_t size() const { return n_points_; }
  std::size_t stride() const { return stride_; }
  bool has_internal_variables() const { return stride_ > 6; }
  mechanics::ElasticState elastic() const { return body_.elastic(); }
  /// Parameters of the laws at the temperature of time t (no work where it does not change).
  void set_time(double t);

  /// See material::Point.
  void set_least_strain(double strain) { least_strain_ = strain; }

  // Stress: n_points x 6. States and rates: n_points x stride, this body's part of y.
  void rate(std::span<const double> stress, const double* state, double* rate) const;
  void derivative(std::span<const double> stress, const double* state, std::span<const double> d_stress,
                  const double* d_state, double* d_rate) const;
  /// The same at one point; d_stress (6), d_state and d_rate (stride) are those of the point.
  void derivative_at(std::size_t p, std::span<const double> stress, const double* state, const double* d_stress,
                     const double* d_state, double* d_rate) const;
  /// Smallest of all points, see CreepLaw; the parameters are those of set_time().
  double start_exponent(double t, std::span<const double> stress, const double* state) const;
  /// change += what the closed forms give from t on over this duration
  void add_increment(double t, double duration, std::span<const double> stress, const double* state,
                     double* change) const;

  bool knows(material::Measure measure) const { return known_[static_cast<std::size_t>(measure)]; }
  /// Of every point the largest of its mechanisms, 0 where none knows the measure.
  std::vector<double> measure(material::Measure of, std::span<const double> stress, const double* state) const;

  /// Keeps C H of this point for precondition(): C = d(rate)/d(stress), H of the body's set time.
  void linearize(std::span<const double> stress, const double* state);
  /// z = (I + gamma C H)^-1 r, closed form of Sherman and Morrison for isotropic laws.
  void precondition(double gamma, const double* r, double* z) const;
  /// Largest eigenvalue, over the points, of C H, or of the same with the internal variables: 2 divided by it is the
  /// Cormeau step.
  double stiffest_rate(std::span<const double> stress, const double* state) const;

 private:
  struct Local {
    double direction[6];                    // of the stress deviator, unit length
    double deviatoric, radial, volumetric;  // parts of C H
  };
  /// The stress as the laws see it: with its mean fitted (Discretization::fit_mean_stress) if a law uses that.
  class LawStress {
   public:
    LawStress(const MaterialPoints& points, std::span<const double> stress);
    operator std::span<const double>() const { return fitted_.empty() ? given_ : fitted_; }

   private:
    std::span<const double> given_;
    std::vector<double> fitted_;
  };

  /// call(law, point, offset of its internal variables in the state of the point) for every mechanism at point p
  template <typename Call>
  void for_each_law(std::size_t p, std::span<const double> stress, const double* state, Call call) const;
  /// Largest eigenvalue of a point's own part of the Jacobian, internal variables included, by power iteration.
  double stiffest_with_internal(std::size_t p, std::span<const double> stress, const double* state, Eigen::VectorXd& v,
                                Eigen::VectorXd& product) const;
  material::Point point(std::size_t p, std::span<const double> stress, const double* state) const;
  material::StressTangent tangent(std::size_t p, std::span<const double> stress, const double* state) const;

  mechanics::Body& body_;
  std::size_t n_points_, stride_;
  std::size_t n_parameters_ = 0;    // of all mechanisms
  bool known_[2] = {false, false};  // by Measure
  bool fits_mean_stress_ = false;   // a law needs it and elements have it
  bool uniform_ = true;             // one set of parameters serves all points
  double time_ = 0;
  double least_strain_ = material::Point{}.least_strain;
  std::vector<double> parameters_;   // (1 or n_points) x n_parameters
  std::vector<double> temperature_;  // empty, or n_points
  std::vector<Local> locals_;
};

}  // namespace creepcontact::simulation
