#include "plastic_tangent.hpp"

#include <algorithm>
#include <cmath>

#include "plastic_points.hpp"

namespace creepcontact::creep {
namespace {

constexpr double tangent_error = 1e-2;  // of products with the Jacobian
constexpr int max_tangent_iterations = 30;

}  // namespace

PlasticTangent::PlasticTangent(const Assembly& assembly, const Equilibrium& at) : assembly_(assembly) {
  for (std::size_t b = 0; at.plastic.flows && b < at.plastic.bodies.size(); ++b) {
    const PlasticState& state = at.plastic.bodies[b];
    const mechanics::Body& body = assembly.bodies()[b];
    if (state.rate.empty()) continue;
    const PlasticPoints points(body, at.conditions[b]);
    for (std::size_t p = 0; 6 * p < state.rate.size(); ++p) {
      const double rate = tensor::view(state.rate, p).norm();
      if (!(rate > 0)) continue;
      const Tensor6 direction = std::sqrt(1.5) / rate * tensor::view(state.rate, p);
      const double hardening = points.hardening(p, state, direction);
      const double volume = body.discretization().weights()[p];
      points_.push_back(
          {b, p, direction, volume * hardening, volume * (hardening + 3 * points.shear_modulus(p)), volume});
    }
  }
  is_elastic_ = !assembly.team().any(!points_.empty());
}

double PlasticTangent::dot(std::span<const double> a, std::span<const double> b) const {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return assembly_.team().sum(sum);
}

void PlasticTangent::add_flow(std::vector<std::vector<double>>& stress, const Response& response) const {
  const std::size_t n = points_.size();
  const auto work_of = [&](const std::vector<std::vector<double>>& of, std::size_t i) {
    const Point& own = points_[i];
    return own.weight * own.direction.dot(tensor::view(of[own.body], own.point));
  };
  std::vector<double> residual(n), preconditioned(n), search, product(n);
  for (std::size_t i = 0; i < n; ++i) {
    residual[i] = work_of(stress, i);
    preconditioned[i] = residual[i] / points_[i].diagonal;
  }
  search = preconditioned;
  double energy = dot(residual, preconditioned);
  const double first = energy;
  std::vector<std::vector<double>> strain(stress.size()), change;
  std::vector<mechanics::CreepStrainView> views(stress.size());
  for (const Point& own : points_) {
    strain[own.body].resize(stress[own.body].size());
    views[own.body] = {strain[own.body], 6};
  }
  for (int iteration = 0; iteration < max_tangent_iterations && energy > tangent_error * tangent_error * first;
       ++iteration) {
    for (std::size_t i = 0; i < n; ++i)
      tensor::writable(strain[points_[i].body], points_[i].point) = search[i] * points_[i].direction;
    response(views, change);
    for (std::size_t i = 0; i < n; ++i) product[i] = points_[i].hardening * search[i] - work_of(change, i);
    const double curvature = dot(search, product);
    if (!(curvature > 0)) break;  // at the limit load
    const double length = energy / curvature;
    for (std::size_t b = 0; b < stress.size(); ++b)
      for (std::size_t k = 0; k < stress[b].size(); ++k) stress[b][k] += length * change[b][k];
    for (std::size_t i = 0; i < n; ++i) {
      residual[i] -= length * product[i];
      preconditioned[i] = residual[i] / points_[i].diagonal;
    }
    const double before = energy;
    energy = dot(residual, preconditioned);
    for (std::size_t i = 0; i < n; ++i) search[i] = preconditioned[i] + energy / before * search[i];
  }
}

}  // namespace creepcontact::creep
