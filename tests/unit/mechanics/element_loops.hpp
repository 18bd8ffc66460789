#pragma once
/// A distorted box of one element type, with its element loops.

#include <gtest/gtest.h>

#include <random>

#include "creepcontact/base/index.hpp"
#include "creepcontact/fem/bubble.hpp"
#include "creepcontact/fem/reference_element.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {

using mechanics::CreepStrainView;
using mechanics::Discretization;
using mechanics::ElasticState;
using mechanics::Moduli;

inline std::vector<double> noise(std::size_t n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> values(n);
  for (double& value : values) value = uniform(generator);
  return values;
}

inline double dot(std::span<const double> a, std::span<const double> b) {
  return Eigen::VectorXd::Map(a.data(), a.size()).dot(Eigen::VectorXd::Map(b.data(), b.size()));
}

class ElementLoops : public testing::TestWithParam<CellType> {
 protected:
  mesh::Mesh mesh_ = box_mesh(GetParam(), {2, 3, 2}, {1.0, 1.5, 0.8}, {0.1, 0.2, 0.3}, 0.2);
  Discretization body_{mesh_};
  std::size_t n_dofs_ = 3 * body_.n_nodes(), n_values_ = 6 * body_.n_points();

  /// With moduli for which stress is strain.
  std::vector<double> strain(const std::vector<double>& u) const {
    const std::array unit{Moduli{.lambda = 0, .mu = 0.5}};
    std::vector<double> result(n_values_);
    body_.stress(u, {unit}, {}, result);
    return result;
  }
  /// Fit of the volumetric strains of an element by the functions that its type says, weighted by volume.
  Eigen::VectorXd projected(std::size_t element, const Eigen::VectorXd& traces) const {
    const fem::Projection kind = fem::reference_element(GetParam()).volumetric_strain();
    if (kind == fem::Projection::none) return traces;
    Eigen::MatrixXd basis = Eigen::MatrixXd::Ones(traces.size(), kind == fem::Projection::linear ? 4 : 1);
    Eigen::VectorXd root(traces.size());
    for (Index p = 0; p < traces.size(); ++p) {
      const std::size_t point = body_.first_point(element) + p;
      root[p] = std::sqrt(body_.weights()[point]);
      if (basis.cols() == 4) basis.row(p).tail<3>() = body_.point_coordinates()[point];
    }
    return basis * linalg::least_squares(root.asDiagonal() * basis, root.cwiseProduct(traces));
  }
  /// Elastic constants that differ from point to point.
  std::vector<Moduli> varied_moduli() const {
    std::vector<Moduli> moduli;
    for (std::size_t p = 0; p < body_.n_points(); ++p)
      moduli.push_back(material::lame(100.0 + static_cast<double>(p % 7), 0.2 + 0.01 * static_cast<double>(p % 5)));
    return moduli;
  }
};

}  // namespace creepcontact::test
