#include "gasket_creep.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace creepcontact::creep {
namespace {

/// The creep strain of a gasket as a tensor: axial, and of constant volume.
Tensor6 tensor_of(double compression) {
  Tensor6 strain = Tensor6::Zero();
  strain << compression / 2, compression / 2, -compression, 0, 0, 0;
  return strain;
}
Tensor6 stress_of(double pressure) {
  Tensor6 stress = Tensor6::Zero();
  stress[2] = -pressure;
  return stress;
}
double compression_of(const Tensor6& strain) {
  return -strain[2];
}

/// What a law sees at a node; owns the tensors.
struct Seen {
  Tensor6 stress, strain;
  std::vector<double> parameters;
  double time = 0, temperature = 0, min_strain = 0;

  material::PointState of(std::span<const double> internal) const {
    return {.stress = tensor::view(stress),
            .creep_strain = tensor::view(strain),
            .internal = internal,
            .parameters = parameters,
            .time = time,
            .temperature = temperature,
            .min_strain = min_strain};
  }
};

}  // namespace

GasketCreep::GasketCreep(const Assembly& assembly, std::vector<double> min_strain)
    : team_(&assembly.team()), min_strain_(std::move(min_strain)) {
  const StateLayout layout(assembly);
  std::size_t first = layout.size() - layout.n_gaskets();
  for (std::size_t p = 0; p < assembly.pairs().size(); ++p) {
    const contact::Pair& pair = assembly.pairs()[p];
    n_contact_nodes_ += pair.coupling.nodes.size();
    const std::size_t n_state = gasket_stride(pair);
    creeps_ = creeps_ || n_state > 0;
    if (n_state == 0 || assembly.team().rank() != 0) continue;
    OfPair gasket{p,
                  &pair,
                  {},
                  pair.coupling.nodes.size(),
                  n_state,
                  first,
                  pair.gasket->kind().law.thickness(),
                  pair.gasket->kind().stress_per_pressure};
    std::size_t own = 1;
    for (const auto& law : pair.gasket->kind().creep->creep) {
      gasket.mechanisms.push_back({law.get(), own, static_cast<std::size_t>(law->n_internal())});
      own += gasket.mechanisms.back().n;
    }
    first += gasket.n_nodes * n_state;
    gaskets_.push_back(std::move(gasket));
  }
}

template <typename Work>
void GasketCreep::for_each_state(const Work& work) const {
  for (const OfPair& gasket : gaskets_)
    for (std::size_t i = 0; i < gasket.n_nodes; ++i) work(gasket, i, gasket.first + i * gasket.n_state);
}

template <typename Work>
void GasketCreep::for_each_node(const Equilibrium& at, std::span<const double> state, const Work& work) const {
  for (const OfPair& gasket : gaskets_) {
    const std::vector<double> temperatures = gasket.contact->gasket->temperatures(at.time);
    for (std::size_t i = 0; i < gasket.n_nodes; ++i) {
      const std::size_t first = gasket.first + i * gasket.n_state;
      const auto own = state.subspan(first, gasket.n_state);
      const double pressure = at.contact.multiplier[gasket.contact->first_row + gasket.contact->coupling.row(i)];
      Seen seen{stress_of(gasket.stress_per_pressure * pressure),
                tensor_of(own[0]),
                {},
                at.time,
                temperatures[i],
                min_strain_[gasket.pair]};
      const auto see = [&](const Mechanism& mechanism) {
        seen.parameters.clear();
        for (const Function& parameter : mechanism.law->parameters())
          seen.parameters.push_back(parameter({.T = temperatures[i]}));
        return seen.of(own.subspan(mechanism.first, mechanism.n));
      };
      work(gasket, i, first, see);
    }
  }
}

void GasketCreep::closures(std::span<const double> state, std::vector<double>& into) const {
  into.assign(creeps_ ? n_contact_nodes_ : 0, 0.0);
  for_each_state([&](const OfPair& gasket, std::size_t i, std::size_t first) {
    into[static_cast<std::size_t>(gasket.contact->first_node) + i] = gasket.thickness * state[first];
  });
  if (creeps_) team_->broadcast(into, 0);
}

void GasketCreep::rate(const Equilibrium& at, std::span<const double> state, std::span<double> rate) const {
  for_each_node(at, state, [&](const OfPair& gasket, std::size_t, std::size_t first, const auto& see) {
    Tensor6 sum = Tensor6::Zero();
    for (const Mechanism& mechanism : gasket.mechanisms)
      mechanism.law->rate(see(mechanism),
                          {tensor::Map(sum.data()), rate.subspan(first + mechanism.first, mechanism.n)});
    rate[first] = compression_of(sum);
  });
}

void GasketCreep::derivative(const Equilibrium& at, std::span<const double> state, const Eigen::VectorXd& multiplier,
                             std::span<const double> change, std::span<double> product) const {
  for_each_node(at, state, [&](const OfPair& gasket, std::size_t i, std::size_t first, const auto& see) {
    const Tensor6 stress =
        stress_of(gasket.stress_per_pressure * multiplier[gasket.contact->first_row + gasket.contact->coupling.row(i)]);
    const Tensor6 strain = tensor_of(change[first]);
    Tensor6 sum = Tensor6::Zero();
    for (const Mechanism& mechanism : gasket.mechanisms)
      mechanism.law->derivative(
          see(mechanism),
          {tensor::view(stress), tensor::view(strain), change.subspan(first + mechanism.first, mechanism.n)},
          {tensor::Map(sum.data()), product.subspan(first + mechanism.first, mechanism.n)});
    product[first] = compression_of(sum);
  });
}

GasketCreep::Jacobians GasketCreep::jacobians(const Equilibrium& at, std::span<const double> state) const {
  Jacobians result;
  for_each_node(at, state, [&](const OfPair& gasket, std::size_t, std::size_t, const auto& see) {
    const auto n = static_cast<Eigen::Index>(gasket.n_state);
    Eigen::MatrixXd& jacobian = result.emplace_back(n, n + 1);
    for (Eigen::Index j = 0; j <= n; ++j) {
      const Tensor6 stress = stress_of(j == n ? gasket.stress_per_pressure : 0.0),
                    strain = tensor_of(j == 0 ? 1.0 : 0.0);
      std::vector<double> change(gasket.n_state, 0.0), product(gasket.n_state, 0.0);
      if (j < n) change[static_cast<std::size_t>(j)] = 1;
      Tensor6 sum = Tensor6::Zero();
      for (const Mechanism& mechanism : gasket.mechanisms)
        mechanism.law->derivative(
            see(mechanism),
            {tensor::view(stress), tensor::view(strain), std::span(change).subspan(mechanism.first, mechanism.n)},
            {tensor::Map(sum.data()), std::span(product).subspan(mechanism.first, mechanism.n)});
      product[0] = compression_of(sum);
      jacobian.col(j) = Eigen::Map<const Eigen::VectorXd>(product.data(), n);
    }
  });
  return result;
}

double GasketCreep::start_exponent(double t, const Equilibrium& at, std::span<const double> state) const {
  double smallest = 1;
  for_each_node(at, state, [&](const OfPair& gasket, std::size_t, std::size_t, const auto& see) {
    for (const Mechanism& mechanism : gasket.mechanisms) {
      material::PointState point = see(mechanism);
      point.time = t;
      smallest = std::min(smallest, mechanism.law->start_exponent(point));
    }
  });
  return smallest;
}

void GasketCreep::add_increment(double t, double duration, const Equilibrium& at, std::span<const double> state,
                                std::span<double> change) const {
  for_each_node(at, state, [&](const OfPair& gasket, std::size_t, std::size_t first, const auto& see) {
    Tensor6 sum = Tensor6::Zero();
    for (const Mechanism& mechanism : gasket.mechanisms) {
      material::PointState point = see(mechanism);
      point.time = t;
      mechanism.law->increment(point, duration,
                               {tensor::Map(sum.data()), change.subspan(first + mechanism.first, mechanism.n)});
    }
    change[first] += compression_of(sum);
  });
}

void GasketCreep::precondition(const Jacobians& at, const Eigen::VectorXd& flexibility, double gamma,
                               std::span<const double> r, std::span<double> z) const {
  std::size_t node = 0;
  for_each_state([&](const OfPair& gasket, std::size_t i, std::size_t first) {
    const auto n = static_cast<Eigen::Index>(gasket.n_state);
    const Eigen::MatrixXd& jacobian = at[node++];
    const auto row = gasket.contact->first_row + gasket.contact->coupling.row(i);
    // The closure by creep opens the gap, so that the pressure falls by area/(F + compliance) times it.
    const double falling = gasket.thickness * gasket.contact->coupling.area[i] / flexibility[row];
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) - gamma * jacobian.leftCols(n);
    matrix.col(0) += gamma * falling * jacobian.col(n);
    Eigen::Map<Eigen::VectorXd>(&z[first], n) =
        matrix.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(&r[first], n));
  });
}

double GasketCreep::stiffest_rate(const Jacobians& at, const Eigen::VectorXd& flexibility) const {
  double largest = 0;
  std::size_t node = 0;
  for_each_state([&](const OfPair& gasket, std::size_t i, std::size_t) {
    const auto n = static_cast<Eigen::Index>(gasket.n_state);
    const Eigen::MatrixXd& jacobian = at[node++];
    const auto row = gasket.contact->first_row + gasket.contact->coupling.row(i);
    Eigen::MatrixXd matrix = jacobian.leftCols(n);
    matrix.col(0) -= gasket.thickness * gasket.contact->coupling.area[i] / flexibility[row] * jacobian.col(n);
    largest = std::max(largest, matrix.norm());  // a bound: the smallest one needs no eigenvalues
  });
  return largest;
}

GasketCreep::Eliminated GasketCreep::eliminated(const Jacobians& at, double gamma, std::span<const double> r,
                                                Eigen::Index n_rows) const {
  Eliminated result{Eigen::VectorXd::Zero(n_rows), Eigen::VectorXd::Zero(n_rows)};
  std::size_t node = 0;
  for_each_state([&](const OfPair& gasket, std::size_t i, std::size_t first) {
    const auto n = static_cast<Eigen::Index>(gasket.n_state);
    const Eigen::MatrixXd& jacobian = at[node++];
    const auto row = gasket.contact->first_row + gasket.contact->coupling.row(i);
    const Eigen::PartialPivLU<Eigen::MatrixXd> factor(Eigen::MatrixXd::Identity(n, n) - gamma * jacobian.leftCols(n));
    const double closing = gasket.thickness * gasket.contact->coupling.area[i];
    result.opening[row] = closing * factor.solve(Eigen::Map<const Eigen::VectorXd>(&r[first], n))[0];
    result.compliance[row] = closing * gamma * factor.solve(jacobian.col(n))[0];
  });
  return result;
}

void GasketCreep::solution(const Jacobians& at, double gamma, std::span<const double> r,
                           const Eigen::VectorXd& multiplier, std::span<double> z) const {
  std::size_t node = 0;
  for_each_state([&](const OfPair& gasket, std::size_t i, std::size_t first) {
    const auto n = static_cast<Eigen::Index>(gasket.n_state);
    const Eigen::MatrixXd& jacobian = at[node++];
    const double pressure = multiplier[gasket.contact->first_row + gasket.contact->coupling.row(i)];
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) - gamma * jacobian.leftCols(n);
    Eigen::Map<Eigen::VectorXd>(&z[first], n) = matrix.partialPivLu().solve(
        Eigen::Map<const Eigen::VectorXd>(&r[first], n) + gamma * pressure * jacobian.col(n));
  });
}

std::vector<double> typical_gasket_strains(const Assembly& assembly, const Equilibrium& at) {
  std::vector<double> result(assembly.pairs().size(), 0.0);
  for (std::size_t p = 0; p < result.size(); ++p) {
    const contact::Pair& pair = assembly.pairs()[p];
    if (gasket_stride(pair) == 0 || at.contact.compliance.size() == 0) continue;
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
      const auto row = pair.first_row + pair.coupling.row(i);
      const double strain = at.contact.multiplier[row] * at.contact.compliance[row] /
                            (pair.coupling.area[i] * pair.gasket->kind().law.thickness());
      sum += pair.coupling.area[i] * strain * strain;
      area += pair.coupling.area[i];
    }
    result[p] = std::sqrt(sum / area);
  }
  return result;
}

}  // namespace creepcontact::creep
