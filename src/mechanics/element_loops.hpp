#pragma once
/// The element loops of one element type, with the numbers of nodes and points known to the compiler.
///
/// Displacement gradient at a point: du_i/dx_j = sum_k (sum_a u_ai dN_a/dxi_k) dxi_k/dx_j. The points of an element
/// are the vector lanes.
///
/// Elastic strain e = P (B u + B_b a - eps_0), where P replaces the volumetric strain at the points by its projection
/// on few functions (fem::Projection) and a is the inner displacement of elements with a bubble. a follows from its
/// own equilibrium, sum of w (P B_b)^T H e = f_b, with the force f_b on the bubble. P is its own transpose with respect
/// to the weights, so nodal forces need P on the stress.

#include <algorithm>
#include <array>

#include "bubble_terms.hpp"
#include "creepcontact/base/index.hpp"
#include "element_block.hpp"

namespace creepcontact::mechanics {

template <int n_nodes_v, int n_points_v, fem::Projection volumetric, bool with_bubble,
          Kinematics kinematics = Kinematics::solid>
class ElementLoops final : public ElementBlock {
 public:
  ElementLoops(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes, const mesh::Section& section,
               BlockStart start)
      : ElementBlock(cells, nodes, section, start) {
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t p = 0; p < P; ++p) table_[(3 * a + k) * P + p] = derivatives()[(p * N + a) * 3 + k];
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t p = 0; p < P; ++p)
        shape_table_[a * P + p] = shape()(static_cast<Index>(a), static_cast<Index>(p));
  }

  void stress(std::span<const double> u, const ElasticState& elastic, CreepStrainView creep,
              std::span<double> stress) const override {
    for_each_element([&](std::size_t e) {
      Tensors values = element_strain(e, u.data());
      to_stress(e, elastic, creep, values);
      write(values, stress, e);
    });
  }

  void internal_force(std::span<const double> stress, std::span<double> element_forces) const override {
    for_each_element([&](std::size_t e) {
      Tensors values = read(stress, e);
      element_force(e, values, element_forces.data());
    });
  }

  void initial_strain_force(const ElasticState& elastic, CreepStrainView creep,
                            std::span<double> element_forces) const override {
    for_each_element([&](std::size_t e) {
      Tensors values = Tensors::Zero();
      to_stress(e, elastic, creep, values);
      values = -values;
      element_force(e, values, element_forces.data());
    });
  }

  void fit_mean_stress(std::span<double> stress) const override {
    if (!fits_mean_stress()) return;
    for_each_element([&](std::size_t e) {
      Tensors values = read(stress, e);
      project_trace(e, values, 0.0);
      write(values, stress, e);
    });
  }

  void tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                      std::span<const double> initial_stress, std::span<double> strain) const override {
    for_each_element([&](std::size_t e) {
      Tensors values = element_strain(e, u.data());
      project_trace(e, values);
      add_bubble_strain(e, moduli, initial_stress, values);
      if constexpr (kinematics == Kinematics::plane_stress)
        for (std::size_t p = 0; p < P; ++p) {
          const Index row = p;
          const auto zz = moduli[first_point(e) + p].row(2);
          values(row, 2) = 0;
          const double known = zz.dot(values.row(row).matrix());
          values(row, 2) = (initial_stress[6 * (first_point(e) + p) + 2] - known) / zz[2];
        }
      write(values, strain, e);
    });
  }

  void initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                            std::span<double> element_forces) const override {
    for_each_element([&](std::size_t e) {
      Tensors stress = read(initial_stress, e);
      if constexpr (with_bubble) {
        Tensors strain = Tensors::Zero();
        add_bubble_strain(e, moduli, initial_stress, strain);
        for (std::size_t p = 0; p < P; ++p) {
          const Index row = p;
          stress.row(row) -= (moduli[first_point(e) + p] * strain.row(row).matrix().transpose()).transpose().array();
        }
      }
      if constexpr (kinematics == Kinematics::plane_stress)
        for (std::size_t p = 0; p < P; ++p) {
          const Index row = p;
          const auto zz = moduli[first_point(e) + p].row(2);
          stress.row(row) -= stress(row, 2) / zz[2] * zz.array();
        }
      element_force(e, stress, element_forces.data());
    });
  }

 private:
  static constexpr std::size_t N = n_nodes_v, P = n_points_v;
  static constexpr std::size_t S = N + (kinematics == Kinematics::generalized ? 1 : 0);  // with the axial node
  static constexpr std::size_t D = kinematics == Kinematics::solid ? 3 : 2;              // dimensions of the gradients
  using Values = Lanes<n_points_v>;
  using Tensors = LaneTensors<n_points_v>;
  using ConstValues = Eigen::Map<const Values>;
  using Terms = BubbleTerms<n_points_v, kinematics>;
  using Points = Eigen::Array<double, 6, n_points_v>;  // tensors at the points as callers see them

  template <typename Work>
  void for_each_element(const Work& work) const {
    numerics::for_each_index(n_elements(), numerics::parallel_elements, work);
  }

  std::size_t first_point(std::size_t e) const { return start().point + e * P; }

  Tensors read(std::span<const double> values, std::size_t e) const {
    return Eigen::Map<const Points>(values.data() + 6 * first_point(e)).transpose();
  }
  void write(const Tensors& from, std::span<double> values, std::size_t e) const {
    Eigen::Map<Points>(values.data() + 6 * first_point(e)) = from.transpose();
  }

  ConstValues inverse(std::size_t e, std::size_t k, std::size_t j) const {
    return ConstValues(geometry(e) + (3 * k + j) * P);
  }
  ConstValues weight(std::size_t e) const { return ConstValues(geometry(e) + 9 * P); }
  ConstValues shape_at_points(std::size_t a) const { return ConstValues(&shape_table_[a * P]); }
  /// dN_a/dxi_k at the points.
  ConstValues derivative(std::size_t a, std::size_t k) const { return ConstValues(&table_[(3 * a + k) * P]); }

  /// Replaces the trace (of strain, of stress) at the points by its projection, as far as the element is projected.
  void project_trace(std::size_t e, Tensors& values) const {
    if constexpr (volumetric == fem::Projection::none) return;
    project_trace(e, values, n_nodes_v == 20 || (n_nodes_v == 8 && n_points_v == 4) ? unprojected_part(e) : 0.0);
  }

  /// @param kept  share of the trace that stays as it is
  void project_trace(std::size_t e, Tensors& values, double kept) const {
    if constexpr (volumetric == fem::Projection::none) return;
    if (kept == 1) return;
    const Values trace = values.col(0) + values.col(1) + values.col(2), weighted = weight(e) * trace;
    Values shift = weighted.sum() / weight(e).sum() - trace;
    if constexpr (volumetric == fem::Projection::linear) {
      for (std::size_t j = 0; j < D; ++j) {
        const ConstValues linear(linear_functions(e) + j * P);
        shift += (linear * weighted).sum() * linear;
      }
    }
    shift *= (1 - kept) / 3;
    for (Index i = 0; i < 3; ++i) values.col(i) += shift;
  }

  /// B u without projection.
  Tensors element_strain(std::size_t e, const double* u) const {
    constexpr double half_sqrt2 = tensor::sqrt2 / 2;
    const std::int64_t* cell = connectivity().data() + e * S;
    std::array<std::array<double, N>, D> nodal;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) nodal[i][a] = u[3 * cell[a] + static_cast<std::int64_t>(i)];
    std::array<std::array<Values, D>, D> gradient;  // du_i/dx_j
    for (std::size_t i = 0; i < D; ++i) {
      std::array<Values, D> by_xi;
      for (std::size_t k = 0; k < D; ++k) {
        Values sum = Values::Zero();
        for (std::size_t a = 0; a < N; ++a) sum += nodal[i][a] * derivative(a, k);
        by_xi[k] = sum;
      }
      for (std::size_t j = 0; j < D; ++j) {
        if constexpr (D == 3)
          gradient[i][j] = inverse(e, 0, j) * by_xi[0] + inverse(e, 1, j) * by_xi[1] + inverse(e, 2, j) * by_xi[2];
        else
          gradient[i][j] = inverse(e, 0, j) * by_xi[0] + inverse(e, 1, j) * by_xi[1];
      }
    }
    Tensors strain;
    if constexpr (D == 3) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        strain.col(i) = gradient[i][i];
        strain.col(3 + i) = half_sqrt2 * (gradient[i][j] + gradient[j][i]);
      }
    } else {
      strain.setZero();
      strain.col(0) = gradient[0][0];
      strain.col(1) = gradient[1][1];
      strain.col(3) = half_sqrt2 * (gradient[0][1] + gradient[1][0]);
    }
    if constexpr (kinematics == Kinematics::axisymmetric) {
      Values radial = Values::Zero();
      for (std::size_t a = 0; a < N; ++a) radial += nodal[0][a] * shape_at_points(a);
      strain.col(2) = radial * ConstValues(inverse_radius(e));
    }
    if constexpr (kinematics == Kinematics::generalized) strain.col(2) = u[3 * cell[N] + 2] / axial_length();
    return strain;
  }

  /// @param values  the strain of the nodal displacement, which becomes the stress
  void to_stress(std::size_t e, const ElasticState& elastic, CreepStrainView creep, Tensors& values) const {
    const std::size_t first = first_point(e);
    if (!creep.empty()) {
      using Strided = Eigen::Map<const Points, 0, Eigen::OuterStride<>>;
      values -= Strided(&creep.data[first * creep.stride], Eigen::OuterStride<>(creep.stride)).transpose();
    }
    if (!elastic.thermal_strain.empty()) {
      const ConstValues thermal(elastic.thermal_strain.data() + first);
      for (Index i = 0; i < 3; ++i) values.col(i) -= thermal;
    }
    if (!elastic.thermal_tensors.empty()) values -= read(elastic.thermal_tensors, e);
    project_trace(e, values);
    [[maybe_unused]] Vector3 force = Vector3::Zero();  // on the bubble
    if constexpr (with_bubble)
      if (!elastic.inner_force.empty()) force = Vector3::Map(&elastic.inner_force[3 * (start().inner + e)]);
    if (!elastic.matrices.empty()) return to_stress_by_matrices(e, elastic.matrices.subspan(first, P), force, values);
    const LaneModuli<n_points_v> moduli(elastic, first);
    if constexpr (with_bubble) bubble_terms(e).add_strain(moduli, force, values);
    if constexpr (kinematics == Kinematics::plane_stress)
      values.col(2) = -moduli.lambda / (moduli.lambda + moduli.twice_mu) * (values.col(0) + values.col(1));
    const Values spherical = moduli.lambda * (values.col(0) + values.col(1) + values.col(2));
    for (Index i = 0; i < 6; ++i) values.col(i) *= moduli.twice_mu;
    for (Index i = 0; i < 3; ++i) values.col(i) += spherical;
  }

  void to_stress_by_matrices([[maybe_unused]] std::size_t e, std::span<const Matrix6> matrices,
                             [[maybe_unused]] const Vector3& force, Tensors& values) const {
    if constexpr (with_bubble) bubble_terms(e).add_strain(matrices, {}, force, values);
    for (std::size_t p = 0; p < P; ++p) {
      Tensor6 strain = values.row(static_cast<Index>(p)).matrix().transpose();
      if constexpr (kinematics == Kinematics::plane_stress) {
        strain[2] = 0;
        strain[2] = -matrices[p].row(2).dot(strain) / matrices[p](2, 2);
      }
      values.row(static_cast<Index>(p)) = (matrices[p] * strain).transpose().array();
    }
  }

  void element_force(std::size_t e, Tensors& stress, double* element_forces) const {
    constexpr double half_sqrt2 = tensor::sqrt2 / 2;
    constexpr std::array<std::array<Index, 3>, 3> column{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};
    project_trace(e, stress);
    for (Index i = 0; i < 6; ++i) stress.col(i) *= (i < 3 ? 1 : half_sqrt2) * weight(e);
    std::array<std::array<Values, D>, D> flux;  // weight * component i of stress . grad xi_k
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t k = 0; k < D; ++k) {
        const auto first = stress.col(column[i][0]), second = stress.col(column[i][1]);
        if constexpr (D == 3)
          flux[i][k] =
              inverse(e, k, 0) * first + inverse(e, k, 1) * second + inverse(e, k, 2) * stress.col(column[i][2]);
        else
          flux[i][k] = inverse(e, k, 0) * first + inverse(e, k, 1) * second;
      }
    [[maybe_unused]] Values hoop;
    if constexpr (kinematics == Kinematics::axisymmetric) hoop = stress.col(2) * ConstValues(inverse_radius(e));
    double* out = element_forces + 3 * (start().entry + e * S);
    for (std::size_t a = 0; a < N; ++a) {
      for (std::size_t i = 0; i < D; ++i) {
        if constexpr (D == 3)
          *out++ =
              (derivative(a, 0) * flux[i][0] + derivative(a, 1) * flux[i][1] + derivative(a, 2) * flux[i][2]).sum();
        else
          *out++ = (derivative(a, 0) * flux[i][0] + derivative(a, 1) * flux[i][1]).sum();
      }
      if constexpr (kinematics == Kinematics::axisymmetric) *(out - 2) += (shape_at_points(a) * hoop).sum();
      if constexpr (D == 2) *out++ = 0;
    }
    if constexpr (kinematics == Kinematics::generalized) {
      *out++ = 0;
      *out++ = 0;
      *out = stress.col(2).sum() / axial_length();
    }
  }

  /// strain += P B_b a with the a that balances D strain - initial stress.
  void add_bubble_strain([[maybe_unused]] std::size_t e, [[maybe_unused]] std::span<const Matrix6> moduli,
                         [[maybe_unused]] std::span<const double> initial_stress,
                         [[maybe_unused]] Tensors& strain) const {
    if constexpr (with_bubble)
      bubble_terms(e).add_strain(moduli.subspan(first_point(e), P), initial_stress.subspan(6 * first_point(e), 6 * P),
                                 Vector3::Zero(), strain);
  }

  Terms bubble_terms(std::size_t e) const {
    Values hoop = Values::Zero();
    if constexpr (kinematics == Kinematics::axisymmetric)
      hoop = ConstValues(bubble_values()) * ConstValues(inverse_radius(e));
    return {bubble(e), typename Terms::Geometry(geometry(e)), typename Terms::Vectors(linear_functions(e)),
            typename Terms::Vectors(bubble_derivatives().data()), hoop};
  }

  std::array<double, P * N * 3> table_{};
  std::array<double, P * N> shape_table_{};
};

}  // namespace creepcontact::mechanics
