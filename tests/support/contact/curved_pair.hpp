#pragma once
/// Two bodies with curved surfaces in contact, without stiffness: for tests of the coupling itself.

#include <array>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/contact/geometry/mortar.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {

/// One body and its contact surface.
struct Part {
  Part(mesh::Mesh made, std::string surface, const std::vector<std::pair<std::string, Vector3>>& held = {});

  contact::Surface surface() const;
  std::vector<mechanics::Support> supports(const std::vector<std::pair<std::string, Vector3>>& held) const;

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
double uneven(double x, double amount);

mesh::Mesh shell_mesh(const Shell& shell);

/// A shell of a sphere: the part over a square, seen from the centre.
mesh::Mesh sphere_mesh(const Shell& shell);

inline const char* contact_group(const Shell& shell) {
  return shell.is_inner ? "z1" : "z0";
}

/// Free at its arc's ends, or with planes of symmetry at the ends of a quarter.
Part cylinder(const Shell& shell, bool with_symmetry = false);

Part sphere(const Shell& shell, bool with_symmetry = false);

Eigen::VectorXd nodal(const mesh::Mesh& mesh, const std::function<Vector3(const Vector3&)>& field);

}  // namespace creepcontact::test
