#pragma once
/// The creep laws of one body at all its integration points: rates and their derivatives.

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::creep {

/// Parameters of the creep laws of a body at one time, evaluated at the temperature of that time.
struct LawParameters {
  double time = 0;
  std::vector<double> temperature;  ///< n_points; empty if the model has no temperature
  std::vector<double> values;       ///< (1 or n_points) x number of parameters of all laws
  bool uniform = true;              ///< true: one set of parameters holds for all points
  bool evaluated = false;           ///< false: `values` are not valid yet
};

/// Where the laws of a body are evaluated: like material::PointState, but for all points of the body. Refers to values
/// of the caller.
struct PointsState {
  const LawParameters& laws;
  mechanics::ElasticState elastic;
  std::span<const double> stress;  ///< n_points x 6, Mandel order
  std::span<const double> state;   ///< n_points x stride: this body's part of y
  /// Per law: CreepLaw::n_prepared() numbers per point. Set by MaterialPoints; null: nothing is prepared.
  const std::vector<std::vector<double>>* prepared = nullptr;
};

/// A direction of change of stress and state, at all points of a body or at a single one. Refers to values of the
/// caller.
struct PointsChange {
  std::span<const double> stress;  ///< 6 per point, Mandel order
  std::span<const double> state;   ///< stride per point
};

/// All creep laws of a body at its points. Rates, stresses and states of the laws add up per point. Immutable.
class MaterialPoints {
 public:
  /// @param body  must outlive the object @param min_strain  see material::PointState
  /// @throws ModelError if a parameter is not admissible at t = 0
  explicit MaterialPoints(const mechanics::Body& body, double min_strain = material::PointState{}.min_strain);

  /// True for an elastic body.
  bool empty() const { return stride_ == 0; }
  std::size_t size() const { return n_points_; }
  /// State variables per point, 6 (creep strain) + internal variables of all laws; 0 for an elastic body.
  std::size_t stride() const { return stride_; }
  bool has_internal_variables() const { return stride_ > 6; }
  /// True if a point's part of the Jacobian is that of isotropic elasticity and the tangents of coaxial laws alone
  /// (PointPreconditioner); else it follows from derivatives (MaterialTangent).
  bool has_closed_form() const {
    return !has_internal_variables() && hill_.empty() && !body_.material().orthotropy && is_coaxial_;
  }
  /// True if all laws are linear, and elasticity and creep are isotropic: LinearElimination applies.
  bool is_linear() const { return is_linear_ && hill_.empty() && !body_.material().orthotropy; }
  /// True if the derivatives of linear laws and the moduli are the same at all points.
  bool is_uniform(const PointsState& at) const {
    return is_linear() && at.laws.uniform && at.elastic.moduli.size() == 1;
  }
  const mechanics::Body& body() const { return body_; }

  /// Evaluates the parameters at the temperature of `at`; no work if they are up to date.
  /// @param into  from an earlier call, or new @throws ModelError if a parameter is not admissible
  void update(const mechanics::BodyConditions& at, LawParameters& into) const;

  /// What the laws prepare at all points together, by law; empty if none does: for PointsState::prepared of many calls
  /// of derivative_at(). The other functions do it themselves.
  std::vector<std::vector<double>> prepare(const PointsState& at, bool with_derivatives) const;

  // The rates of all points and their directional derivative, n_points x stride. Cost: one pass over the points.
  /// @param tangents  of all points, set to what tangents() gives; or empty
  void rate(const PointsState& at, std::span<double> rate, std::span<material::StressTangent> tangents = {}) const;
  void derivative(const PointsState& at, const PointsChange& change, std::span<double> rate_change) const;
  /// derivative() of laws of a closed form, by the tangents of all points: no law is evaluated.
  /// @param tangents  of tangents(at)
  void derivative_by_tangents(const PointsState& at, std::span<const material::StressTangent> tangents,
                              std::span<const double> stress_change, std::span<double> rate_change) const;
  /// The derivative at point p only. @param change, rate_change  of this point
  void derivative_at(std::size_t p, const PointsState& at, const PointsChange& change,
                     std::span<double> rate_change) const;
  /// Smallest start exponent over all points (CreepLaw::start_exponent).
  /// @param t  used instead of the time of the parameters
  double start_exponent(double t, const PointsState& at) const;
  /// change += increments of the laws over `duration` from time t on, at constant stress (CreepLaw::increment).
  /// @param change  n_points x stride
  void add_increment(double t, double duration, const PointsState& at, std::span<double> change) const;

  /// True if some law counts cycles.
  bool counts_cycles() const;
  /// Adds what a cycle does to the state of all points (CreepLaw::add_cycle). @param cycles  one per point
  /// @param state  n_points x stride @throws ModelError as the laws, naming the material
  void add_cycle(std::span<const material::CycleRange> cycles, std::span<double> state) const;

  /// True if some law has the variable.
  bool has(const material::StateVariable& variable) const { return std::ranges::count(known_, &variable) > 0; }
  /// n_points x variable.width()
  std::vector<double> evaluate(const material::StateVariable& variable, const PointsState& at) const;

  /// Sums of the stress tangents of the laws, one per point. Cost: one pass over the points.
  void tangents(const PointsState& at, std::span<material::StressTangent> into) const;
  /// Largest eigenvalue over all points of C H, or of the point-wise Jacobian where that has no closed form. The
  /// stable step of explicit Euler is 2 divided by it (Cormeau 1975).
  /// @param tangents  of tangents(at)
  double stiffest_rate(const PointsState& at, std::span<const material::StressTangent> tangents) const;

 private:
  /// The stress as the laws see it: with fitted mean stress (Discretization::fit_mean_stress) if a law depends on the
  /// mean stress.
  class LawStress {
   public:
    LawStress(const MaterialPoints& points, std::span<const double> stress);
    // NOLINTNEXTLINE(google-explicit-constructor): it represents the stress
    operator std::span<const double>() const { return fitted_.empty() ? given_ : fitted_; }

   private:
    std::span<const double> given_;
    std::vector<double> fitted_;
  };

  /// A stress, or a change of stress, at one point as the laws see it: laws of anisotropic creep through Hill's
  /// transformation (material::hill_transformation).
  class SeenStress {
   public:
    SeenStress(const MaterialPoints& points, std::size_t p, const tensor::ConstMap& given) : given_(given) {
      if (points.hill_.empty()) return;
      transformed_ = points.hill(p) * given;
      seen_ = &transformed_;
    }
    SeenStress(const SeenStress&) = delete;
    SeenStress& operator=(const SeenStress&) = delete;
    tensor::ConstMap of(const material::CreepLaw& law) const {
      return law.strains() && seen_ ? tensor::view(*seen_) : given_;
    }

   private:
    tensor::ConstMap given_;
    Tensor6 transformed_;
    const Tensor6* seen_ = nullptr;
  };

  /// A contiguous part of an array.
  struct Part {
    std::size_t first = 0, size = 0;
    template <typename Number>
    std::span<Number> of(std::span<Number> all) const {
      return {all.data() + first, size};
    }
  };
  /// One law, and its parts of state and parameters.
  struct Mechanism {
    const material::CreepLaw* law;
    std::size_t number;  // of the law
    Part internal;       // of the state of a point
    Part parameters;     // of the parameters of all laws
  };
  /// The entries of point p in an array n_points x stride.
  template <typename Number>
  std::span<Number> of_point(std::size_t p, std::span<Number> all) const {
    return {all.data() + stride_ * p, stride_};
  }
  /// @param stress  as the law sees it, seen_stress()
  material::PointState state_for(const Mechanism& mechanism, std::size_t p, const PointsState& at,
                                 const SeenStress& stress) const;
  static std::span<const double> prepared_for(const Mechanism& mechanism, std::size_t p, const PointsState& at);
  /// Largest eigenvalue of the Jacobian of point p by power iteration.
  double stiffest_at(std::size_t p, const PointsState& at, Eigen::VectorXd& v, Eigen::VectorXd& product) const;

  const mechanics::Body& body_;
  std::size_t n_points_, stride_;
  double min_strain_;
  const Matrix6& hill(std::size_t p) const { return hill_[hill_.size() == 1 ? 0 : p]; }
  /// The strain rate, or its change, of laws that saw the stress through Hill's transformation.
  void turn_back(std::size_t p, std::span<double> rate) const {
    if (!hill_.empty()) tensor::writable(rate, 0) = hill(p) * Tensor6(tensor::writable(rate, 0));
  }

  std::vector<Mechanism> mechanisms_;
  std::vector<const material::StateVariable*> known_;  // to some law
  std::size_t n_parameters_ = 0;                       // of all laws
  std::vector<Matrix6> hill_;                          // one for all points, or one per point; empty: isotropic creep
  bool is_coaxial_ = true;                             // true if all laws are
  bool is_linear_ = true;                              // likewise
  bool fits_mean_stress_ = false;                      // a law needs it and the elements support it
  bool depends_on_temperature_ = false;                // true if some parameter does
  bool prepares_ = false;                              // true if some law does
};

}  // namespace creepcontact::creep
