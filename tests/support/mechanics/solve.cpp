#include "support/mechanics/solve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/index.hpp"

namespace creepcontact::test {

material::Material elastic_material(double young_modulus, double poisson_ratio) {
  material::Material material;
  material.name = "elastic";
  material.young_modulus = young_modulus;
  material.poisson_ratio = poisson_ratio;
  return material;
}

mechanics::Support support(const mesh::Mesh& mesh, const std::string& surface, const Vector3& direction,
                           Function value) {
  return {surface, mesh::group_nodes(mesh, surface), {direction}, std::move(value)};
}

std::vector<mechanics::Support> boundary_supports(const mesh::Mesh& mesh,
                                                  const std::array<std::string, 3>& components) {
  std::vector<mechanics::Support> supports;
  for (const auto* surface : {"x0", "x1", "y0", "y1", "z0", "z1"})
    for (int i = 0; i < 3; ++i)
      supports.push_back(
          support(mesh, surface, Vector3::Unit(i), Function::expression(components[i], {"x", "y", "z"})));
  return supports;
}

std::vector<mechanics::Support> symmetry_supports(const mesh::Mesh& mesh) {
  return {support(mesh, "x0", Vector3::UnitX()), support(mesh, "y0", Vector3::UnitY()),
          support(mesh, "z0", Vector3::UnitZ())};
}

mechanics::FactoredBody factored(const mechanics::Body& body, const std::vector<std::int64_t>& trailing, double t) {
  const mechanics::BodyConditions at = body.at(t);
  mechanics::FactoredBody result(body, at, trailing);
  result.factorize(at);
  return result;
}

void solve_in_place(mechanics::FactoredBody& factored, std::vector<double>& free) {
  factored.solver().forward(free, free);
  factored.solver().backward(free, free);
}

std::vector<double> solve(const mechanics::Body& body, double t, mechanics::CreepStrainView creep) {
  mechanics::FactoredBody factor = factored(body, {}, t);
  const mechanics::BodyConditions at = body.at(t);
  std::vector<double> free(body.constraints().n_free());
  std::vector<double> u(body.constraints().n_full());
  body.right_hand_side(at, creep, free);
  solve_in_place(factor, free);
  body.constraints().expand(free, at.prescribed, u);
  return u;
}

std::vector<double> stress_of(const mechanics::Body& body, const std::vector<double>& u, double t,
                              mechanics::CreepStrainView creep) {
  std::vector<double> stress(6 * body.discretization().n_points());
  body.discretization().stress(u, body.at(t).elastic(), creep, stress);
  return stress;
}

std::vector<Tensor6> as_tensors(std::span<const double> values) {
  std::vector<Tensor6> tensors;
  for (std::size_t i = 0; i < values.size(); i += 6) tensors.emplace_back(Tensor6::Map(&values[i]));
  return tensors;
}

double largest(std::span<const double> values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

Vector3 resultant(std::span<const double> forces) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < forces.size(); ++i) sum[i % 3] += forces[i];
  return sum;
}

}  // namespace creepcontact::test
