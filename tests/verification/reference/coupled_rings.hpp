#pragma once
/// Two rings pressed together with interference, in plane stress, heated by films at the bore and at the rim. Pressure,
/// conductance of the joint, temperature, thermal strain and creep depend on each other; the joint may open.
/// Method of forces along the radius: the stresses sigma_r = F/r, sigma_theta = F' of a polynomial F in each ring
/// minimise the complementary energy under p >= 0, which makes them linear functions of the thermal and creep strains.
/// The temperature is a polynomial in each ring (Galerkin). State, in MPa all: E times the creep strains at Gauss
/// points, E alpha times the temperature since assembly at nodes, and the time.

#include <Eigen/Core>
#include <memory>

#include "verification/reference/stiff_integrator.hpp"

namespace creepcontact::reference {

/// Changes linearly from start to end within the time of the ramp, and stays there.
struct Ramp {
  double start, end;
};

struct RampedFilm {
  Ramp coefficient, fluid;
};

/// gas/(1 + gap/gas_gap) + solid (p/solid_pressure)^0.95, linear in p below linear_below.
struct JointConductance {
  double gas, gas_gap, solid, solid_pressure, linear_below;

  double value(double p, double gap) const;
  double slope(double p) const;
  double gap_slope(double gap) const;
};

/// Both rings are of one material.
struct CoupledRings {
  double bore, fit, rim;        ///< radii
  double interference;          ///< of the radii
  double assembly_temperature;  ///< and that of the start
  double young_modulus, poisson_ratio, expansion;
  double A, n, A_growth, A_temperature;  ///< creep rate A exp(A_growth (T - A_temperature)) q^n
  double conductivity, capacity;         ///< capacity per volume
  double time_unit;                      ///< of t in the unit of time of the heat data
  double ramp;
  RampedFilm at_bore, at_rim;
  JointConductance joint;
};

class CoupledRingsHistory {
 public:
  /// @param degree  of the polynomials
  /// @param tolerance  of the local error, relative to the largest stress of a state
  explicit CoupledRingsHistory(const CoupledRings& rings, int degree = 10, double tolerance = 1e-8);
  CoupledRingsHistory(const CoupledRingsHistory&) = delete;
  CoupledRingsHistory& operator=(const CoupledRingsHistory&) = delete;

  struct Result {
    double pressure, gap;
    double bore, inner_face, outer_face, rim;  ///< temperatures
  };
  /// At a time that is not before the last one.
  Result at(double time);

 private:
  /// Linear in the strains e at the points (times E): stress at the points, pressure and gap.
  struct Response {
    Eigen::MatrixXd stress;
    Eigen::RowVectorXd pressure, gap;
    Eigen::VectorXd stress_0;
    double pressure_0, gap_0;
  };
  struct Mechanics {
    const Response* response;
    double pressure, gap;
    Eigen::VectorXd stress;
  };

  void assemble(int degree);
  void start(const Eigen::VectorXd& state);
  Eigen::VectorXd strains(const Eigen::VectorXd& state) const;
  Mechanics mechanics(const Eigen::VectorXd& state) const;
  double ramped(const Ramp& ramp, const Eigen::VectorXd& state) const;
  double ramp_slope(const Ramp& ramp) const;
  Eigen::VectorXd rate(const Eigen::VectorXd& state) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& state) const;
  double temperature(double stress) const { return rings_.assembly_temperature + stress / stress_per_kelvin_; }

  CoupledRings rings_;
  double tolerance_, stress_per_kelvin_;
  bool is_ramped_ = false;                   ///< the ramp is over
  double begin_ = 0;                         ///< of the integration after or within the ramp
  Eigen::Index n_points_ = 0, n_nodes_ = 0;  ///< nodes: those of one ring after those of the other
  Eigen::MatrixXd interpolation_;            ///< from nodes to points
  Eigen::MatrixXd inverse_capacity_, conduction_;
  Response closed_, open_;
  std::unique_ptr<StiffIntegrator> integrator_;
};

}  // namespace creepcontact::reference
