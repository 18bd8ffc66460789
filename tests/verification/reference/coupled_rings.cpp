#include "verification/reference/coupled_rings.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "verification/reference/polynomial.hpp"

namespace creepcontact::reference {
namespace {

// What stands for the time among the stresses of a state begins with 100, by whose size the first steps are measured.
constexpr double first = 100, per_time = 1e-3;

}  // namespace

double JointConductance::value(double p, double gap) const {
  const double closed = p < linear_below ? slope(p) * p : solid * std::pow(p / solid_pressure, 0.95);
  return gas / (1 + gap / gas_gap) + closed;
}

double JointConductance::slope(double p) const {
  if (p < linear_below) return solid * std::pow(linear_below / solid_pressure, 0.95) / linear_below;
  return 0.95 * solid / solid_pressure * std::pow(p / solid_pressure, -0.05);
}

double JointConductance::gap_slope(double gap) const {
  return -gas / gas_gap / std::pow(1 + gap / gas_gap, 2);
}

CoupledRingsHistory::CoupledRingsHistory(const CoupledRings& rings, int degree, double tolerance)
    : rings_(rings), tolerance_(tolerance), stress_per_kelvin_(rings.young_modulus * rings.expansion) {
  assemble(degree);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(2 * n_points_ + n_nodes_ + 1);
  state[state.size() - 1] = first;
  start(state);
}

void CoupledRingsHistory::start(const Eigen::VectorXd& state) {
  integrator_ =
      std::make_unique<StiffIntegrator>([this](const Eigen::VectorXd& y) { return rate(y); },
                                        [this](const Eigen::VectorXd& y) { return jacobian(y); }, state, tolerance_);
}

CoupledRingsHistory::Result CoupledRingsHistory::at(double time) {
  if (!is_ramped_ && time > rings_.ramp) {
    const Eigen::VectorXd state = integrator_->advance(rings_.ramp);
    is_ramped_ = true;
    begin_ = rings_.ramp;
    start(state);
  }
  const Eigen::VectorXd& y = integrator_->advance(time - begin_);
  const Mechanics now = mechanics(y);
  const auto nodes = y.segment(2 * n_points_, n_nodes_);
  const Eigen::Index middle = n_nodes_ / 2;
  return {now.pressure,
          now.gap,
          temperature(nodes[0]),
          temperature(nodes[middle - 1]),
          temperature(nodes[middle]),
          temperature(nodes[n_nodes_ - 1])};
}

void CoupledRingsHistory::assemble(int degree) {
  const LagrangeBasis basis(degree);
  const GaussRule rule = gauss_rule(degree + 2);
  const Eigen::Index per_ring = rule.points.size();
  n_points_ = 2 * per_ring;
  n_nodes_ = 2 * (degree + 1);
  const Eigen::Index p = 2 * (degree - 1);  // the last unknown, after the values of F at nodes inside the rings
  Eigen::MatrixXd stress = Eigen::MatrixXd::Zero(2 * n_points_, p + 1), strain = stress;  // of unknowns
  Eigen::VectorXd measure(2 * n_points_);
  interpolation_ = Eigen::MatrixXd::Zero(n_points_, n_nodes_);
  Eigen::MatrixXd slopes = interpolation_;
  for (const int ring : {0, 1}) {
    const double inner = ring == 0 ? rings_.bore : rings_.fit, outer = ring == 0 ? rings_.fit : rings_.rim;
    for (Eigen::Index g = 0; g < per_ring; ++g) {
      const Eigen::Index point = ring * per_ring + g;
      const double xi = rule.points[g], half = (outer - inner) / 2, r = inner + half * (xi + 1);
      measure.segment<2>(2 * point).setConstant(half * rule.weights[g] * r);
      for (int i = 0; i <= degree; ++i) {
        const double value = basis.value(i, xi), slope = basis.slope(i, xi) / half;
        interpolation_(point, ring * (degree + 1) + i) = value;
        slopes(point, ring * (degree + 1) + i) = slope;
        if (i == (ring == 0 ? 0 : degree)) continue;  // F = 0 where nothing presses
        const bool at_fit = i == (ring == 0 ? degree : 0);
        const Eigen::Index unknown = at_fit ? p : ring * (degree - 1) + i - 1;
        stress.block<2, 1>(2 * point, unknown) += (at_fit ? -rings_.fit : 1) * Eigen::Vector2d(value / r, slope);
      }
      const double nu = rings_.poisson_ratio;
      strain.middleRows<2>(2 * point) = Eigen::Matrix2d{{1, -nu}, {-nu, 1}} * stress.middleRows<2>(2 * point);
    }
  }
  // Unknowns x make 1/2 x'Kx + x'L e - x_p E fit (interference + gap) least, where gap = 0 or x_p = 0.
  const Eigen::MatrixXd L = stress.transpose() * measure.asDiagonal(), K = L * strain;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(p + 1);
  load[p] = rings_.young_modulus * rings_.fit * rings_.interference;
  const auto factor = K.ldlt();
  const Eigen::MatrixXd forces = -factor.solve(L);
  const Eigen::VectorXd forces_0 = factor.solve(load);
  closed_ = {stress * forces,   forces.row(p), Eigen::RowVectorXd::Zero(2 * n_points_),
             stress * forces_0, forces_0[p],   0};
  const Eigen::MatrixXd inside = -K.topLeftCorner(p, p).ldlt().solve(L.topRows(p));
  open_ = {stress.leftCols(p) * inside,
           Eigen::RowVectorXd::Zero(2 * n_points_),
           (K.row(p).head(p) * inside + L.row(p)) / (rings_.young_modulus * rings_.fit),
           Eigen::VectorXd::Zero(2 * n_points_),
           0,
           -rings_.interference};

  const Eigen::VectorXd weights = measure(Eigen::seq(0, Eigen::last, 2));
  const Eigen::MatrixXd capacity = rings_.capacity * interpolation_.transpose() * weights.asDiagonal() * interpolation_;
  conduction_ = rings_.conductivity * slopes.transpose() * weights.asDiagonal() * slopes;
  inverse_capacity_ = rings_.time_unit * capacity.ldlt().solve(Eigen::MatrixXd::Identity(n_nodes_, n_nodes_));
}

Eigen::VectorXd CoupledRingsHistory::strains(const Eigen::VectorXd& y) const {
  Eigen::VectorXd e = y.head(2 * n_points_);
  const Eigen::VectorXd thermal = interpolation_ * y.segment(2 * n_points_, n_nodes_);
  for (Eigen::Index i = 0; i < n_points_; ++i) e.segment<2>(2 * i).array() += thermal[i];
  return e;
}

CoupledRingsHistory::Mechanics CoupledRingsHistory::mechanics(const Eigen::VectorXd& y) const {
  const Eigen::VectorXd e = strains(y);
  const double p = closed_.pressure_0 + closed_.pressure.dot(e);
  if (p >= 0) return {&closed_, p, 0, closed_.stress_0 + closed_.stress * e};
  return {&open_, 0, open_.gap_0 + open_.gap.dot(e), open_.stress_0 + open_.stress * e};
}

double CoupledRingsHistory::ramped(const Ramp& ramp, const Eigen::VectorXd& y) const {
  const double part = is_ramped_ ? 1 : (y[y.size() - 1] - first) / (per_time * rings_.ramp);
  return ramp.start + part * (ramp.end - ramp.start);
}

double CoupledRingsHistory::ramp_slope(const Ramp& ramp) const {
  return is_ramped_ ? 0 : (ramp.end - ramp.start) / (per_time * rings_.ramp);
}

Eigen::VectorXd CoupledRingsHistory::rate(const Eigen::VectorXd& y) const {
  const Mechanics now = mechanics(y);
  Eigen::VectorXd result(y.size());
  const auto nodes = y.segment(2 * n_points_, n_nodes_);
  const Eigen::VectorXd at_points = interpolation_ * nodes;
  for (Eigen::Index i = 0; i < n_points_; ++i) {
    const double r = now.stress[2 * i], theta = now.stress[2 * i + 1];
    const double q = std::sqrt(r * r + theta * theta - r * theta);
    const double A = rings_.A * std::exp(rings_.A_growth * (temperature(at_points[i]) - rings_.A_temperature));
    const double speed = rings_.young_modulus * A * std::pow(q, rings_.n - 1);
    result.segment<2>(2 * i) = speed * Eigen::Vector2d(r - theta / 2, theta - r / 2);
  }
  Eigen::VectorXd flow = -conduction_ * nodes;
  const auto film = [&](const RampedFilm& f, Eigen::Index node, double radius) {
    const double fluid = stress_per_kelvin_ * (ramped(f.fluid, y) - rings_.assembly_temperature);
    flow[node] += radius * ramped(f.coefficient, y) * (fluid - nodes[node]);
  };
  film(rings_.at_bore, 0, rings_.bore);
  film(rings_.at_rim, n_nodes_ - 1, rings_.rim);
  const Eigen::Index inner = n_nodes_ / 2 - 1, outer = inner + 1;
  const double crossing = rings_.fit * rings_.joint.value(now.pressure, now.gap) * (nodes[inner] - nodes[outer]);
  flow[inner] -= crossing;
  flow[outer] += crossing;
  result.segment(2 * n_points_, n_nodes_) = inverse_capacity_ * flow;
  result[y.size() - 1] = per_time;
  return result;
}

Eigen::MatrixXd CoupledRingsHistory::jacobian(const Eigen::VectorXd& y) const {
  const Mechanics now = mechanics(y);
  const Eigen::Index n_creep = 2 * n_points_, last = y.size() - 1;
  const auto of_state = [&](const auto& of_strains) {  // e = creep + interpolated temperature, in both components
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(of_strains.rows(), y.size());
    result.leftCols(n_creep) = of_strains;
    const Eigen::MatrixXd both =
        of_strains(Eigen::all, Eigen::seq(0, Eigen::last, 2)) + of_strains(Eigen::all, Eigen::seq(1, Eigen::last, 2));
    result.middleCols(n_creep, n_nodes_) = both * interpolation_;
    return result;
  };
  const Eigen::MatrixXd stress = of_state(now.response->stress), pressure = of_state(now.response->pressure),
                        gap = of_state(now.response->gap);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(y.size(), y.size());
  const auto nodes = y.segment(n_creep, n_nodes_);
  const Eigen::VectorXd at_points = interpolation_ * nodes;
  for (Eigen::Index i = 0; i < n_points_; ++i) {
    const double r = now.stress[2 * i], theta = now.stress[2 * i + 1];
    const double q = std::sqrt(r * r + theta * theta - r * theta);
    if (q == 0) continue;
    const double A = rings_.A * std::exp(rings_.A_growth * (temperature(at_points[i]) - rings_.A_temperature));
    const double speed = rings_.young_modulus * A * std::pow(q, rings_.n - 1);
    const Eigen::Vector2d direction(r - theta / 2, theta - r / 2);
    const Eigen::Matrix2d by_stress =
        speed * (Eigen::Matrix2d{{1, -0.5}, {-0.5, 1}} + (rings_.n - 1) / (q * q) * direction * direction.transpose());
    result.middleRows<2>(2 * i) = by_stress * stress.middleRows<2>(2 * i);
    result.block(2 * i, n_creep, 2, n_nodes_) +=
        speed * rings_.A_growth / stress_per_kelvin_ * direction * interpolation_.row(i);
  }
  Eigen::MatrixXd flow = Eigen::MatrixXd::Zero(n_nodes_, y.size());
  flow.middleCols(n_creep, n_nodes_) = -conduction_;
  const auto film = [&](const RampedFilm& f, Eigen::Index node, double radius) {
    const double fluid = stress_per_kelvin_ * (ramped(f.fluid, y) - rings_.assembly_temperature);
    const double h = ramped(f.coefficient, y);
    flow(node, n_creep + node) -= radius * h;
    flow(node, last) +=
        radius * (ramp_slope(f.coefficient) * (fluid - nodes[node]) + h * stress_per_kelvin_ * ramp_slope(f.fluid));
  };
  film(rings_.at_bore, 0, rings_.bore);
  film(rings_.at_rim, n_nodes_ - 1, rings_.rim);
  const Eigen::Index inner = n_nodes_ / 2 - 1, outer = inner + 1;
  const JointConductance& joint = rings_.joint;
  Eigen::RowVectorXd crossing = rings_.fit * (nodes[inner] - nodes[outer]) *
                                (joint.slope(now.pressure) * pressure + joint.gap_slope(now.gap) * gap);
  const double h = rings_.fit * joint.value(now.pressure, now.gap);
  crossing[n_creep + inner] += h;
  crossing[n_creep + outer] -= h;
  flow.row(inner) -= crossing;
  flow.row(outer) += crossing;
  result.middleRows(n_creep, n_nodes_) = inverse_capacity_ * flow;
  return result;
}

}  // namespace creepcontact::reference
