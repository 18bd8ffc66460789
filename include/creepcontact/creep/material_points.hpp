#pragma once
/// The creep laws of one body at all its integration points: rates and their derivative.

#include <optional>
#include <span>
#include <vector>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::creep {

/// Parameters of a body's laws at the temperature of one time.
struct LawParameters {
  double time = 0;
  std::vector<double> temperature;  ///< n_points; empty if none is given
  std::vector<double> values;       ///< (1 or n_points) x number of parameters of all laws
  bool uniform = true;              ///< one set serves all points
  bool evaluated = false;
};

/// Where the laws of a body are evaluated: material::PointState of all its points. Refers to values of the caller.
struct PointsState {
  const LawParameters& laws;
  mechanics::ElasticState elastic;
  std::span<const double> stress;  ///< n_points x 6, Mandel order
  std::span<const double> state;   ///< n_points x stride: this body's part of y
};

/// A direction in which stress and state change, at all points of a body or at one. Refers to values of the caller.
struct PointsChange {
  std::span<const double> stress;  ///< 6 per point, Mandel order
  std::span<const double> state;   ///< stride per point
};

/// Immutable.
class MaterialPoints {
 public:
  /// @param body must outlive the object @param least_strain  see material::PointState
  explicit MaterialPoints(const mechanics::Body& body, double least_strain = material::PointState{}.least_strain);

  bool empty() const { return stride_ == 0; }
  std::size_t size() const { return n_points_; }
  std::size_t stride() const { return stride_; }
  bool has_internal_variables() const { return stride_ > 6; }
  const mechanics::Body& body() const { return body_; }

  /// Parameters at the temperature of these conditions (no work where it does not change).
  /// @param into  of this object, or new @throws ModelError if a parameter is not admissible
  void update(const mechanics::BodyConditions& at, LawParameters& into) const;

  // Rates: n_points x stride, as the state. Cost of each: one pass over the points.
  void rate(const PointsState& at, std::span<double> rate) const;
  void derivative(const PointsState& at, const PointsChange& change, std::span<double> rate_change) const;
  /// The same at one point. @param change, rate_change  of this point alone
  void derivative_at(std::size_t p, const PointsState& at, const PointsChange& change,
                     std::span<double> rate_change) const;
  /// Smallest of all points, see CreepLaw. @param t  takes the place of the parameters' time
  double start_exponent(double t, const PointsState& at) const;
  /// change += what the closed forms give from t on over this duration. @param change  n_points x stride
  void add_increment(double t, double duration, const PointsState& at, std::span<double> change) const;

  bool knows(material::Measure measure) const { return known_[static_cast<std::size_t>(measure)]; }
  /// Of every point the largest of its mechanisms, 0 where none knows the measure.
  std::vector<double> measure(material::Measure of, const PointsState& at) const;

  /// Sum of the laws at one point.
  material::StressTangent tangent(std::size_t p, const PointsState& at) const;
  /// Largest eigenvalue, over the points, of C H, or of the same with the internal variables: 2 divided by it is the
  /// Cormeau step.
  double stiffest_rate(const PointsState& at) const;

 private:
  /// The stress as the laws see it: with its mean fitted (Discretization::fit_mean_stress) if a law uses that.
  class LawStress {
   public:
    LawStress(const MaterialPoints& points, std::span<const double> stress);
    // NOLINTNEXTLINE(google-explicit-constructor): it stands for the stress
    operator std::span<const double>() const { return fitted_.empty() ? given_ : fitted_; }

   private:
    std::span<const double> given_;
    std::vector<double> fitted_;
  };

  /// A part of numbers that stand one after the other.
  struct Part {
    std::size_t first = 0, size = 0;
    template <typename Number>
    std::span<Number> of(std::span<Number> all) const {
      return {all.data() + first, size};
    }
  };
  /// One law, and what belongs to it.
  struct Mechanism {
    const material::CreepLaw* law;
    Part internal;    // of the state of a point
    Part parameters;  // of those of all mechanisms
  };
  /// Of n_points x stride numbers those of one point.
  template <typename Number>
  std::span<Number> of_point(std::size_t p, std::span<Number> all) const {
    return {all.data() + stride_ * p, stride_};
  }
  material::PointState seen_by(const Mechanism& mechanism, std::size_t p, const PointsState& at) const;
  /// Largest eigenvalue of a point's own part of the Jacobian, internal variables included, by power iteration.
  double stiffest_with_internal(std::size_t p, const PointsState& at, Eigen::VectorXd& v,
                                Eigen::VectorXd& product) const;

  const mechanics::Body& body_;
  std::size_t n_points_, stride_;
  double least_strain_;
  std::vector<Mechanism> mechanisms_;
  std::size_t n_parameters_ = 0;         // of all mechanisms
  bool known_[2] = {false, false};       // by Measure
  bool fits_mean_stress_ = false;        // a law needs it and elements have it
  bool depends_on_temperature_ = false;  // some parameter
};

}  // namespace creepcontact::creep
