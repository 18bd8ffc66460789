#pragma once
/// Shorthands of the mechanics tests: materials, supports on box faces, one elastic solution.

#include <type_traits>

#include "creepcontact/mechanics/factored_body.hpp"

namespace creepcontact::test {

inline material::Material elastic_material(double young_modulus = 200.0, double poisson_ratio = 0.3) {
  material::Material material;
  material.name = "elastic";
  material.young_modulus = young_modulus;
  material.poisson_ratio = poisson_ratio;
  return material;
}

inline mechanics::Support support(const mesh::Mesh& mesh, const std::string& surface, const Vector3& direction,
                                  Function value = 0.0) {
  return {surface, mesh::group_nodes(mesh, surface), {direction}, std::move(value)};
}

/// u = (components) as expressions in x, y, z on all six faces of a box.
inline std::vector<mechanics::Support> boundary_supports(const mesh::Mesh& mesh,
                                                         const std::array<std::string, 3>& components) {
  std::vector<mechanics::Support> supports;
  for (const auto* surface : {"x0", "x1", "y0", "y1", "z0", "z1"})
    for (int i = 0; i < 3; ++i)
      supports.push_back(
          support(mesh, surface, Vector3::Unit(i), Function::expression(components[i], {"x", "y", "z"})));
  return supports;
}

/// Symmetry about the planes x = 0, y = 0, z = 0 of a box.
inline std::vector<mechanics::Support> symmetry_supports(const mesh::Mesh& mesh) {
  return {support(mesh, "x0", Vector3::UnitX()), support(mesh, "y0", Vector3::UnitY()),
          support(mesh, "z0", Vector3::UnitZ())};
}

inline mechanics::FactoredBody factored(const mechanics::Body& body, const std::vector<std::int64_t>& trailing = {},
                                        double t = 0) {
  const mechanics::BodyConditions at = body.at(t);
  mechanics::FactoredBody result(body, at, trailing);
  result.factorize(at);
  return result;
}

/// K^-1 of a vector over the free unknowns, in place.
inline void solve_in_place(mechanics::FactoredBody& factored, std::vector<double>& free) {
  factored.solver().forward(free, free);
  factored.solver().backward(free, free);
}

/// Displacement at a time, with the stiffness of that time.
inline std::vector<double> solve(const mechanics::Body& body, double t = 0, mechanics::CreepStrainView creep = {}) {
  mechanics::FactoredBody factor = factored(body, {}, t);
  const mechanics::BodyConditions at = body.at(t);
  std::vector<double> free(body.constraints().n_free());
  std::vector<double> u(body.constraints().n_full());
  body.right_hand_side(at, creep, free);
  solve_in_place(factor, free);
  body.constraints().expand(free, at.prescribed, u);
  return u;
}

inline std::vector<double> stress_of(const mechanics::Body& body, const std::vector<double>& u, double t = 0,
                                     mechanics::CreepStrainView creep = {}) {
  std::vector<double> stress(6 * body.discretization().n_points());
  body.discretization().stress(u, body.at(t).elastic(), creep, stress);
  return stress;
}

/// Values at the points as tensors.
inline std::vector<Tensor6> as_tensors(std::span<const double> values) {
  std::vector<Tensor6> tensors;
  for (std::size_t i = 0; i < values.size(); i += 6) tensors.emplace_back(Tensor6::Map(&values[i]));
  return tensors;
}

inline double largest(std::span<const double> values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

inline Vector3 resultant(std::span<const double> forces) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < forces.size(); ++i) sum[i % 3] += forces[i];
  return sum;
}

/// Displacement of all nodes by a function of place.
template <typename Field>
std::vector<double> nodal_field(const mesh::Mesh& mesh, const Field& field) {
  static_assert(std::is_same_v<std::invoke_result_t<Field, Vector3>, Vector3>, "no expression of temporaries");
  std::vector<double> values;
  for (const Vector3& x : mesh.nodes) {
    const Vector3 value = field(x);
    values.insert(values.end(), {value[0], value[1], value[2]});
  }
  return values;
}

}  // namespace creepcontact::test
