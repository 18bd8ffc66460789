#include "support/contact/curved_pair.hpp"

#include <cmath>

#include "creepcontact/base/index.hpp"

namespace creepcontact::test {

Part::Part(mesh::Mesh made, std::string surface, const std::vector<std::pair<std::string, Vector3>>& held)
    : mesh(std::move(made)), surface_name(std::move(surface)), constraints(mesh.nodes, supports(held)) {}

contact::Surface Part::surface() const {
  return {surface_name, &mesh, &constraints, mesh::boundary_faces(mesh, surface_name), 1.0};
}

std::vector<mechanics::Support> Part::supports(const std::vector<std::pair<std::string, Vector3>>& held) const {
  std::vector<mechanics::Support> result;
  result.reserve(held.size());
  for (const auto& [group, direction] : held) result.push_back(support(mesh, group, direction));
  return result;
}

double uneven(double x, double amount) {
  return x + amount * std::sin(2 * std::numbers::pi * x) / (2 * std::numbers::pi);
}

mesh::Mesh shell_mesh(const Shell& shell) {
  const double inner = shell.is_inner ? shell.radius - 0.2 : shell.radius;
  return mapped(box_mesh(shell.type, shell.divisions), [&](const Vector3& x) {
    const double angle = shell.angle * uneven(x.x(), shell.irregular);
    const double radius = inner + 0.2 * x.z();
    return Vector3(radius * std::sin(angle), shell.length * uneven(x.y(), -shell.irregular), radius * std::cos(angle));
  });
}

mesh::Mesh sphere_mesh(const Shell& shell) {
  const double inner = shell.is_inner ? shell.radius - 0.2 : shell.radius;
  return mapped(box_mesh(shell.type, shell.divisions), [&](const Vector3& x) {
    const double a = std::tan(0.5 * shell.angle * uneven(x.x(), shell.irregular));
    const double b = std::tan(0.5 * shell.angle * uneven(x.y(), -shell.irregular));
    return Vector3((inner + 0.2 * x.z()) * Vector3(a, b, 1).normalized());
  });
}

Part cylinder(const Shell& shell, bool with_symmetry) {
  std::vector<std::pair<std::string, Vector3>> held;
  if (with_symmetry) {
    held = {{"x0", Vector3::UnitX()},
            {"x1", Vector3(std::cos(shell.angle), 0, -std::sin(shell.angle))},
            {"y0", Vector3::UnitY()},
            {"y1", Vector3::UnitY()}};
  }
  return {shell_mesh(shell), contact_group(shell), held};
}

Part sphere(const Shell& shell, bool with_symmetry) {
  std::vector<std::pair<std::string, Vector3>> held;
  if (with_symmetry) held = {{"x0", Vector3::UnitX()}, {"y0", Vector3::UnitY()}};
  return {sphere_mesh(shell), contact_group(shell), held};
}

Eigen::VectorXd nodal(const mesh::Mesh& mesh, const std::function<Vector3(const Vector3&)>& field) {
  Eigen::VectorXd values(3 * mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) values.segment<3>(3 * i) = field(mesh.nodes[i]);
  return values;
}

}  // namespace creepcontact::test
