#pragma once
/// Shorthands of the mechanics tests: materials, supports on box faces, one elastic solution.

#include <array>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "creepcontact/mechanics/factored_body.hpp"

namespace creepcontact::test {

material::Material elastic_material(double young_modulus = 200.0, double poisson_ratio = 0.3);

mechanics::Support support(const mesh::Mesh& mesh, const std::string& surface, const Vector3& direction,
                           Function value = 0.0);

/// u = (components) as expressions in x, y, z on all six faces of a box.
std::vector<mechanics::Support> boundary_supports(const mesh::Mesh& mesh, const std::array<std::string, 3>& components);

/// Symmetry about the planes x = 0, y = 0, z = 0 of a box.
std::vector<mechanics::Support> symmetry_supports(const mesh::Mesh& mesh);

mechanics::FactoredBody factored(const mechanics::Body& body, const std::vector<std::int64_t>& trailing = {},
                                 double t = 0);

/// K^-1 of a vector over the free unknowns, in place.
void solve_in_place(mechanics::FactoredBody& factored, std::vector<double>& free);

/// Displacement at a time, with the stiffness of that time.
std::vector<double> solve(const mechanics::Body& body, double t = 0, mechanics::CreepStrainView creep = {});

std::vector<double> stress_of(const mechanics::Body& body, const std::vector<double>& u, double t = 0,
                              mechanics::CreepStrainView creep = {});

/// Values at the points as tensors.
std::vector<Tensor6> as_tensors(std::span<const double> values);

double largest(std::span<const double> values);

Vector3 resultant(std::span<const double> forces);

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
