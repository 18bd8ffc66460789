#pragma once
/// The element loops of one element type, with the numbers of nodes and points known to the compiler.
///
/// Displacement gradient at a point: du_i/dx_j = sum_k (sum_a u_ai dN_a/dxi_k) dxi_k/dx_j. The three displacement
/// components (padded to four) are the vector lanes, so no reduction has to be reassociated.
///
/// Elastic strain e = P (B u + B_b a - eps_0), where P replaces the volumetric strain at the points by its projection
/// on few functions (fem::Projection) and a is the inner displacement of elements with a bubble. a follows from its
/// own equilibrium, sum of w (P B_b)^T H e = f_b, with the force f_b on the bubble. P is its own transpose with respect
/// to the weights, so nodal forces need P on the stress.

#include <algorithm>
#include <array>

#include "bubble_terms.hpp"
#include "element_block.hpp"

namespace creepcontact::mechanics {

template <int n_nodes_v, int n_points_v, fem::Projection volumetric, bool with_bubble>
class ElementLoops final : public ElementBlock {
 public:
  ElementLoops(const mesh::CellBlock& cells, const std::vector<Vector3>& nodes, BlockStart start)
      : ElementBlock(cells, nodes, start) {
    std::copy(derivatives().begin(), derivatives().end(), table_.begin());
  }

  void stress(std::span<const double> u, const ElasticState& elastic, CreepStrainView creep,
              std::span<double> stress) const override {
    for_each_element([&](std::size_t e) {
      Values strain;
      element_strain(e, u.data(), strain.data());
      element_stress(e, elastic, creep, strain, stress.data() + first_component(e));
    });
  }

  void internal_force(std::span<const double> stress, std::span<double> element_forces) const override {
    for_each_element([&](std::size_t e) {
      Values values;
      std::copy_n(stress.data() + first_component(e), values.size(), values.data());
      element_force(e, values, element_forces.data());
    });
  }

  void initial_strain_force(const ElasticState& elastic, CreepStrainView creep,
                            std::span<double> element_forces) const override {
    for_each_element([&](std::size_t e) {
      Values strain{}, stress;
      element_stress(e, elastic, creep, strain, stress.data());
      for (double& component : stress) component = -component;
      element_force(e, stress, element_forces.data());
    });
  }

  void fit_mean_stress(std::span<double> stress) const override {
    if (!fits_mean_stress()) return;
    for_each_element([&](std::size_t e) { project_trace(e, stress.data() + first_component(e), 0.0); });
  }

  void tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                      std::span<const double> initial_stress, std::span<double> strain) const override {
    for_each_element([&](std::size_t e) {
      double* out = strain.data() + first_component(e);
      element_strain(e, u.data(), out);
      project_trace(e, out);
      add_bubble_strain(e, moduli, initial_stress, out);
    });
  }

  void initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                            std::span<double> element_forces) const override {
    for_each_element([&](std::size_t e) {
      Values stress, strain{};
      std::copy_n(initial_stress.data() + first_component(e), stress.size(), stress.data());
      if constexpr (with_bubble) {
        add_bubble_strain(e, moduli, initial_stress, strain.data());
        for (std::size_t p = 0; p < P; ++p)
          Eigen::Map<Tensor6>(&stress[6 * p]) -=
              moduli[start().point + e * P + p] * Eigen::Map<const Tensor6>(&strain[6 * p]);
      }
      element_force(e, stress, element_forces.data());
    });
  }

 private:
  static constexpr std::size_t N = n_nodes_v, P = n_points_v;
  using Values = std::array<double, 6 * P>;  // a tensor at every point of an element
  using Lanes = Eigen::Array4d;

  template <typename Work>
  void for_each_element(const Work& work) const {
    numerics::for_each_index(n_elements(), numerics::parallel_elements, work);
  }

  std::size_t first_component(std::size_t e) const { return 6 * (start().point + e * P); }

  /// Replaces the trace (of strain, of stress) at the points by its projection, as far as the element is projected.
  void project_trace(std::size_t e, double* values) const {
    project_trace(e, values, n_nodes_v == 20 ? unprojected_part(e) : 0.0);
  }

  /// @param kept  share of the trace that stays as it is
  void project_trace(std::size_t e, double* values, double kept) const {
    if constexpr (volumetric == fem::Projection::none) return;
    if (kept == 1) return;
    const PointGeometry* at = geometry().data() + e * P;
    double sum = 0, volume = 0;
    for (std::size_t p = 0; p < P; ++p) {
      const double* v = values + 6 * p;
      sum += at[p].weight * (v[0] + v[1] + v[2]);
      volume += at[p].weight;
    }
    const double mean = sum / volume;
    std::array<double, 3> slope{};
    [[maybe_unused]] const LinearFunctions* linear = nullptr;
    if constexpr (volumetric == fem::Projection::linear) {
      linear = linear_functions().data() + e * P;
      for (std::size_t p = 0; p < P; ++p) {
        const double* v = values + 6 * p;
        const double weighted = at[p].weight * (v[0] + v[1] + v[2]);
        for (std::size_t j = 0; j < 3; ++j) slope[j] += linear[p][j] * weighted;
      }
    }
    for (std::size_t p = 0; p < P; ++p) {
      double* v = values + 6 * p;
      double projected = mean;
      if constexpr (volumetric == fem::Projection::linear)
        projected += slope[0] * linear[p][0] + slope[1] * linear[p][1] + slope[2] * linear[p][2];
      const double shift = (1 - kept) * (projected - (v[0] + v[1] + v[2])) / 3.0;
      for (std::size_t i = 0; i < 3; ++i) v[i] += shift;
    }
  }

  /// B u without projection.
  void element_strain(std::size_t e, const double* u, double* strain) const {
    std::array<Lanes, N> nodal;
    const std::int64_t* cell = connectivity().data() + e * N;
    for (std::size_t a = 0; a < N; ++a) {
      const double* at_node = u + 3 * cell[a];
      nodal[a] = Lanes(at_node[0], at_node[1], at_node[2], 0.0);
    }
    const PointGeometry* at = geometry().data() + e * P;
    for (std::size_t p = 0; p < P; ++p) {
      Lanes d0 = Lanes::Zero(), d1 = Lanes::Zero(), d2 = Lanes::Zero();
      const double* table = table_.data() + p * N * 3;
      for (std::size_t a = 0; a < N; ++a, table += 3) {
        d0 += table[0] * nodal[a];
        d1 += table[1] * nodal[a];
        d2 += table[2] * nodal[a];
      }
      const double* inverse = at[p].inverse;
      const Lanes x = inverse[0] * d0 + inverse[3] * d1 + inverse[6] * d2;  // du/dx
      const Lanes y = inverse[1] * d0 + inverse[4] * d1 + inverse[7] * d2;
      const Lanes z = inverse[2] * d0 + inverse[5] * d1 + inverse[8] * d2;
      constexpr double half_sqrt2 = tensor::sqrt2 / 2;
      double* out = strain + 6 * p;
      out[0] = x[0];
      out[1] = y[1];
      out[2] = z[2];
      out[3] = half_sqrt2 * (x[1] + y[0]);
      out[4] = half_sqrt2 * (y[2] + z[1]);
      out[5] = half_sqrt2 * (z[0] + x[2]);
    }
  }

  /// From the strain of the nodal displacement, which becomes the elastic strain (without the bubble's part).
  void element_stress(std::size_t e, const ElasticState& elastic, CreepStrainView creep, Values& strain,
                      double* stress) const {
    const std::size_t first = start().point + e * P;
    if (creep.data != nullptr) {
      for (std::size_t p = 0; p < P; ++p) {
        const double* c = creep.data + (first + p) * creep.stride;
        for (std::size_t i = 0; i < 6; ++i) strain[6 * p + i] -= c[i];
      }
    }
    if (!elastic.thermal_strain.empty()) {
      for (std::size_t p = 0; p < P; ++p)
        for (std::size_t i = 0; i < 3; ++i) strain[6 * p + i] -= elastic.thermal_strain[first + p];
    }
    project_trace(e, strain.data());
    for (std::size_t p = 0; p < P; ++p) {
      const Moduli& h = elastic.at(first + p);
      const double* in = strain.data() + 6 * p;
      double* out = stress + 6 * p;
      const double spherical = h.lambda * (in[0] + in[1] + in[2]);
      for (std::size_t i = 0; i < 6; ++i) out[i] = 2.0 * h.mu * in[i] + (i < 3 ? spherical : 0.0);
    }
    if constexpr (with_bubble) {
      const BubbleTerms<P> bubble = bubble_terms(e);
      const auto moduli = [&](std::size_t p) -> const Moduli& { return elastic.at(first + p); };
      std::array<double, 3> force{};
      if (!elastic.inner_force.empty()) std::copy_n(&elastic.inner_force[3 * (start().inner + e)], 3, force.data());
      bubble.balance(moduli, force, stress);
    }
  }

  void element_force(std::size_t e, Values& stress, double* element_forces) const {
    const PointGeometry* at = geometry().data() + e * P;
    project_trace(e, stress.data());
    std::array<Lanes, 3 * P> flux;  // weight * stress . grad xi_k
    for (std::size_t p = 0; p < P; ++p) {
      constexpr double half_sqrt2 = tensor::sqrt2 / 2;
      const double* s = stress.data() + 6 * p;
      const double xy = half_sqrt2 * s[3], yz = half_sqrt2 * s[4], zx = half_sqrt2 * s[5];
      const Lanes x = at[p].weight * Lanes(s[0], xy, zx, 0.0);
      const Lanes y = at[p].weight * Lanes(xy, s[1], yz, 0.0);
      const Lanes z = at[p].weight * Lanes(zx, yz, s[2], 0.0);
      const double* inverse = at[p].inverse;
      for (std::size_t k = 0; k < 3; ++k)
        flux[3 * p + k] = inverse[3 * k] * x + inverse[3 * k + 1] * y + inverse[3 * k + 2] * z;
    }
    double* out = element_forces + 3 * (start().entry + e * N);
    for (std::size_t a = 0; a < N; ++a, out += 3) {
      Lanes force = Lanes::Zero();
      for (std::size_t p = 0; p < P; ++p) {
        const double* table = table_.data() + (p * N + a) * 3;
        force += table[0] * flux[3 * p] + table[1] * flux[3 * p + 1] + table[2] * flux[3 * p + 2];
      }
      out[0] = force[0];
      out[1] = force[1];
      out[2] = force[2];
    }
  }

  /// strain += P B_b a with the a that balances D strain - initial stress.
  void add_bubble_strain([[maybe_unused]] std::size_t e, [[maybe_unused]] std::span<const Matrix6> moduli,
                         [[maybe_unused]] std::span<const double> initial_stress,
                         [[maybe_unused]] double* strain) const {
    if constexpr (with_bubble) {
      const std::size_t first = start().point + e * P;
      bubble_terms(e).add_strain(moduli.data() + first, initial_stress.data() + 6 * first, strain);
    }
  }

  BubbleTerms<P> bubble_terms(std::size_t e) const {
    return BubbleTerms<P>(geometry().data() + e * P, linear_functions().data() + e * P, bubble_derivatives().data());
  }

  std::array<double, P * N * 3> table_{};
};

}  // namespace creepcontact::mechanics
