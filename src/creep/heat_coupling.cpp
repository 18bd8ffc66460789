#include "heat_coupling.hpp"

#include <algorithm>
#include <cmath>

#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/numerics/parallel.hpp"

namespace creepcontact::creep {
namespace {

constexpr double strain_difference = 1e-3;  // degrees, for derivatives of functions of T

}  // namespace

HeatCoupling::HeatCoupling(const Assembly& assembly) : assembly_(assembly), rates_(assembly.heat()->definition) {
  for (const mechanics::Body& body : assembly.bodies()) {
    std::map<mesh::CellType, Eigen::MatrixXd>& own = shapes_.emplace_back();
    for (std::size_t e = 0; e < body.discretization().n_elements(); ++e) {
      const mesh::CellType type = body.discretization().element_type(e);
      if (own.contains(type)) continue;
      const fem::ReferenceElement& element = fem::reference_element(type);
      const fem::QuadratureRule& rule = fem::bulk_rule(type, body.mesh().section);
      Eigen::MatrixXd& values = own[type];
      values.resize(rule.size(), element.n_nodes());
      Eigen::VectorXd shape(element.n_nodes());
      for (Index q = 0; q < rule.size(); ++q) {
        element.shape(rule.points.row(q).transpose(), shape);
        values.row(q) = shape.transpose();
      }
    }
  }
}

std::vector<double> HeatCoupling::completed(double t, std::span<const double> T) {
  std::vector<double> all(T.begin(), T.end());
  for (std::size_t u = 0; u < all.size(); ++u)
    if (rates_.problem().is_given(u)) all[u] = rates_.problem().given_value(u, t);
  return all;
}

std::vector<std::vector<double>> HeatCoupling::at_points(double t, std::span<const double> T) {
  return interpolated(completed(t, T));
}

std::vector<std::vector<double>> HeatCoupling::interpolated(std::span<const double> T) {
  std::vector<std::vector<double>> result;
  for (std::size_t b = 0; b < assembly_.bodies().size(); ++b) {
    const mechanics::Discretization& discretization = assembly_.bodies()[b].discretization();
    const std::vector<double> at_nodes = rates_.problem().at_nodes(b, T);
    std::vector<double>& own = result.emplace_back(discretization.n_points());
    numerics::for_each_index(discretization.n_elements(), numerics::parallel_elements, [&](std::size_t e) {
      const std::span<const std::int64_t> nodes = discretization.element_nodes(e);
      const Eigen::MatrixXd& shapes = shapes_[b].at(discretization.element_type(e));
      const std::size_t first = discretization.first_point(e);
      for (Index q = 0; q < shapes.rows(); ++q) {
        double sum = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i)
          sum += shapes(q, static_cast<Index>(i)) * at_nodes[static_cast<std::size_t>(nodes[i])];
        own[first + static_cast<std::size_t>(q)] = sum;
      }
    });
  }
  return result;
}

std::vector<std::vector<double>> HeatCoupling::strain_change(const Equilibrium& at,
                                                             const std::vector<std::vector<double>>& T_change) const {
  std::vector<std::vector<double>> result;
  for (std::size_t b = 0; b < T_change.size(); ++b) {
    const mechanics::Body& body = assembly_.bodies()[b];
    const material::Material& material = body.material();
    const mechanics::BodyConditions& conditions = at.conditions[b];
    const mechanics::ElasticState elastic = conditions.elastic();
    const std::span<const Matrix3> axes = body.material_axes();
    const bool modulus_changes = !material.orthotropy && material.young_modulus.depends_on_temperature();
    std::vector<double>& strain = result.emplace_back(6 * T_change[b].size(), 0.0);
    for (std::size_t p = 0; p < T_change[b].size(); ++p) {
      const double T = conditions.temperature[p];
      tensor::Map own = tensor::writable(strain, p);
      if (!material.thermal_expansion.is_zero()) {
        const Vector3 slope =
            (material.thermal_expansion.strains(T + strain_difference, material.reference_temperature) -
             material.thermal_expansion.strains(T - strain_difference, material.reference_temperature)) /
            (2 * strain_difference) * T_change[b][p];
        if (material.thermal_expansion.has_axes) {
          const Matrix3& turned = axes[axes.size() == 1 ? 0 : p];
          own = tensor::from_matrix(turned * slope.asDiagonal() * turned.transpose());
        } else {
          own = tensor::from_matrix(Matrix3(slope.asDiagonal()));
        }
      }
      if (!modulus_changes) continue;
      const double modulus = material.young_modulus({.T = T}),
                   slope = (material.young_modulus({.T = T + strain_difference}) -
                            material.young_modulus({.T = T - strain_difference})) /
                           (2 * strain_difference);
      own -= slope / modulus * T_change[b][p] * elastic.elastic_strain(p, tensor::view(at.bodies[b].stress, p));
    }
  }
  return result;
}

}  // namespace creepcontact::creep
