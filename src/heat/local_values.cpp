#include "creepcontact/heat/local_values.hpp"

#include <Eigen/LU>
#include <cmath>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/tangents.hpp"
#include "patches.hpp"

namespace creepcontact::heat {
namespace {

constexpr double no_jump = 1e-9;  // of the temperatures

}  // namespace

std::vector<double> flux(const Conductor& body, const mechanics::Discretization& elements, std::span<const double> T) {
  std::vector<double> result(3 * elements.n_points());
  const mesh::Section& section = body.mesh->section;
  for (std::size_t e = 0; e < elements.n_elements(); ++e) {
    const fem::ReferenceElement& element = fem::reference_element(elements.element_type(e));
    const fem::QuadratureRule& rule = fem::bulk_rule(element.type(), section);
    const std::span<const std::int64_t> nodes = elements.element_nodes(e);
    Eigen::Matrix3Xd x(3, std::ssize(nodes));
    Eigen::VectorXd own(std::ssize(nodes)), shape(std::ssize(nodes));
    for (Index i = 0; i < own.size(); ++i) {
      const auto node = static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)]);
      x.col(i) = body.mesh->nodes[node];
      own[i] = T[node];
    }
    Eigen::MatrixX3d gradient(own.size(), 3);
    for (Index q = 0; q < rule.size(); ++q) {
      const Vector3 xi = rule.points.row(q).transpose();
      element.shape(xi, shape);
      element.gradient(xi, gradient);
      Vector3 slope = fem::jacobian(element, x, gradient).inverse().transpose() * (gradient.transpose() * own);
      if (section.dimension() == 2) slope[2] = 0;
      const Vector3 place = x * shape;
      const Vector3 through = conductivity(body, shape.dot(own), place) * slope;
      for (Index k = 0; k < 3; ++k)
        result[3 * (elements.first_point(e) + static_cast<std::size_t>(q)) + static_cast<std::size_t>(k)] = -through[k];
    }
  }
  return result;
}

std::vector<NodeOfInterface> at_contact_nodes(const Definition& definition, std::span<const std::vector<double>> T,
                                              double t, const ContactAtNodes& contact, std::size_t n_nodes) {
  struct Sums {
    double area = 0, jump = 0, conductance = 0, flow = 0;
  };
  std::vector<Sums> sums(n_nodes);
  double largest = 0;
  for (const Interface& interface : definition.interfaces) {
    if (interface.contact_nodes.empty()) continue;
    const std::array bodies{&definition.bodies[interface.first], &definition.bodies[interface.second]};
    const auto at = [](const contact::ShapeValues& shapes, const std::vector<std::int64_t>& nodes,
                       const std::vector<double>& values) {
      double sum = 0;
      for (Index i = 0; i < shapes.size(); ++i)
        sum += shapes[i] * values[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)])];
      return sum;
    };
    for (const contact::FacingFaces& faces : interface.faces)
      for (const contact::FacingFaces::Point& point : faces.points) {
        const double first = at(point.first, faces.first_nodes, T[interface.first]),
                     second = at(point.second, faces.second_nodes, T[interface.second]);
        const double h =
            conductance(interface, faces, point, bodies, {.t = t, .contact = contact}, (first + second) / 2);
        largest = std::max({largest, std::abs(first), std::abs(second)});
        for (Index i = 0; i < point.hats.size(); ++i) {
          const int node =
              interface.contact_nodes[static_cast<std::size_t>(faces.first_nodes[static_cast<std::size_t>(i)])];
          if (node < 0) continue;
          Sums& own = sums[static_cast<std::size_t>(node)];
          const double weight = point.area * point.hats[i];
          own.area += weight;
          own.jump += weight * (first - second);
          own.conductance += weight * h;
          own.flow += weight * h * (first - second);
        }
      }
  }
  std::vector<NodeOfInterface> result(n_nodes);
  for (std::size_t i = 0; i < n_nodes; ++i) {
    const Sums& own = sums[i];
    if (!(own.area > 0)) continue;
    result[i].jump = own.jump / own.area;
    const bool has_jump = std::abs(result[i].jump) > no_jump * largest && own.flow / own.jump > 0;
    result[i].conductance = has_jump ? own.flow / own.jump : own.conductance / own.area;
  }
  return result;
}

}  // namespace creepcontact::heat
