#pragma once
/// Two bodies with curved surfaces in contact, without stiffness: for tests of the coupling itself.

#include <cmath>
#include <functional>
#include <numbers>

#include "creepcontact/contact/geometry/mortar.hpp"
#include "unit/mechanics/meshes.hpp"
#include "unit/mechanics/solve.hpp"

namespace creepcontact::test {

/// One body and its contact surface.
struct Part {
  Part(mesh::Mesh made, std::string surface, const std::vector<std::pair<std::string, Vector3>>& held = {})
      : mesh(std::move(made)), surface_name(std::move(surface)), constraints(mesh.nodes, supports(held)) {}

  contact::Surface surface() const {
    return {surface_name, &mesh, &constraints, mesh::boundary_faces(mesh, surface_name), 1.0};
  }
  std::vector<mechanics::Support> supports(const std::vector<std::pair<std::string, Vector3>>& held) const {
    std::vector<mechanics::Support> result;
    for (const auto& [group, direction] : held) result.push_back(support(mesh, group, direction));
    return result;
  }

  mesh::Mesh mesh;
  std::string surface_name;
  mechanics::Constraints constraints;
};

/// A shell of a cylinder about the y axis: an arc, its length and its thickness, in grid cells of a box.
struct Shell {
  mesh::CellType type = mesh::CellType::hex8;
  std::array<int, 3> divisions{8, 2, 1};
  double radius = 1;     ///< of the contact surface
  bool is_inner = true;  ///< inner body: thickness inwards, contact at its outer surface
  double angle = std::numbers::pi / 2;
  double length = 0.5;
  double irregular = 0;  ///< uneven division along arc and axis
};

/// 0..1 onto itself, unevenly.
inline double uneven(double x, double amount) {
  return x + amount * std::sin(2 * std::numbers::pi * x) / (2 * std::numbers::pi);
}

inline mesh::Mesh shell_mesh(const Shell& shell) {
  const double inner = shell.is_inner ? shell.radius - 0.2 : shell.radius;
  return mapped(box_mesh(shell.type, shell.divisions), [&](const Vector3& x) {
    const double angle = shell.angle * uneven(x.x(), shell.irregular);
    const double radius = inner + 0.2 * x.z();
    return Vector3(radius * std::sin(angle), shell.length * uneven(x.y(), -shell.irregular), radius * std::cos(angle));
  });
}

/// A shell of a sphere: the part over a square, seen from the centre.
inline mesh::Mesh sphere_mesh(const Shell& shell) {
  const double inner = shell.is_inner ? shell.radius - 0.2 : shell.radius;
  return mapped(box_mesh(shell.type, shell.divisions), [&](const Vector3& x) {
    const double a = std::tan(0.5 * shell.angle * uneven(x.x(), shell.irregular));
    const double b = std::tan(0.5 * shell.angle * uneven(x.y(), -shell.irregular));
    return Vector3((inner + 0.2 * x.z()) * Vector3(a, b, 1).normalized());
  });
}

inline const char* contact_group(const Shell& shell) {
  return shell.is_inner ? "z1" : "z0";
}

/// Free at its arc's ends, or with planes of symmetry at the ends of a quarter.
inline Part cylinder(const Shell& shell, bool with_symmetry = false) {
  std::vector<std::pair<std::string, Vector3>> held;
  if (with_symmetry) {
    held = {{"x0", Vector3::UnitX()},
            {"x1", Vector3(std::cos(shell.angle), 0, -std::sin(shell.angle))},
            {"y0", Vector3::UnitY()},
            {"y1", Vector3::UnitY()}};
  }
  return {shell_mesh(shell), contact_group(shell), held};
}

inline Part sphere(const Shell& shell, bool with_symmetry = false) {
  std::vector<std::pair<std::string, Vector3>> held;
  if (with_symmetry) held = {{"x0", Vector3::UnitX()}, {"y0", Vector3::UnitY()}};
  return {sphere_mesh(shell), contact_group(shell), held};
}

inline Eigen::VectorXd nodal(const mesh::Mesh& mesh, const std::function<Vector3(const Vector3&)>& field) {
  Eigen::VectorXd values(3 * mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) values.segment<3>(3 * i) = field(mesh.nodes[i]);
  return values;
}

}  // namespace creepcontact::test
