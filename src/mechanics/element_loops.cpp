/// The loops over the points of elements, which are most of a creep rate.
///
/// Displacement gradient at a point: du_i/dx_j = sum_k (sum_a u_ai dN_a/dxi_k) dxi_k/dx_j.
///
/// Elastic strain e = P (B u + B_b a - eps_0), where P replaces the volumetric strain at the points by its projection
/// on few functions (fem::Projection) and a is the inner displacement of elements with a bubble. a follows from its
/// own equilibrium, sum of w (P B_b)^T H e = f_b, with the force f_b on the bubble. P is its own transpose with respect
/// to the weights, so nodal forces need P on the stress.
///
/// Numbers of nodes and points are known at run time only: loops over the nodes are long enough, and all element types
/// share two instances (in space and in the plane) of each loop.

#include <array>
#include <optional>

#include "bubble_terms.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/numerics/parallel.hpp"
#include "element_block.hpp"
#include "lanes.hpp"
#include "trace_projection.hpp"

namespace creepcontact::mechanics {

namespace {

constexpr double half_sqrt2 = tensor::sqrt2 / 2;

template <typename V>
using LaneTensor = std::array<V, 6>;
using Column = std::array<double, ElementView::max_points>;
/// Tensors at the points of an element, component by component.
using Tensors = std::array<Column, 6>;

template <typename V>
CREEPCONTACT_INLINE LaneTensor<V> tensor_at(const Tensors& tensors, std::size_t p) {
  LaneTensor<V> result;
  for_constants<6>([&](auto i) { result[i] = load<V>(&tensors[i][p]); });
  return result;
}
template <typename V>
CREEPCONTACT_INLINE void set(const LaneTensor<V>& values, std::size_t p, Tensors& tensors) {
  for_constants<6>([&](auto i) { store(values[i], &tensors[i][p]); });
}
/// From tensors as callers have them, one after the other.
template <typename V>
CREEPCONTACT_INLINE LaneTensor<V> gathered(const double* tensors, std::size_t stride) {
  LaneTensor<V> result;
  for_constants<6>([&](auto i) { result[i] = load<V>(tensors + i, stride); });
  return result;
}
template <typename V>
CREEPCONTACT_INLINE void scatter(const LaneTensor<V>& values, double* tensors) {
  for_constants<6>([&](auto i) { store(values[i], tensors + i, 6); });
}
template <typename V>
CREEPCONTACT_INLINE V trace(const LaneTensor<V>& tensor) {
  return tensor[0] + tensor[1] + tensor[2];
}
template <typename V>
CREEPCONTACT_INLINE void add_normal(const V& value, LaneTensor<V>& tensor) {
  for_constants<3>([&](auto i) { tensor[i] += value; });
}

/// Component of a symmetric tensor in row i and column j.
constexpr std::array<std::array<std::size_t, 3>, 3> component{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};

/// Nothing is projected, there is no bubble, and the moduli are the same at all points: most quadratic elements.
bool is_plain(const ElementView& element, const ElasticState& elastic) {
  return !changes_trace(element, element.unprojected) && element.bubble == nullptr && elastic.matrices.empty() &&
         elastic.moduli.size() == 1;
}

/// The loops over one element in space (D = 3) or in a plane (D = 2). @tparam plain  is_plain(), or not known
template <std::size_t D, bool plain>
class Loop {
 public:
  CREEPCONTACT_INLINE explicit Loop(const ElementView& element) : element_(element), n_points_(element.n_points) {}

  CREEPCONTACT_INLINE void stress(const double* u, const ElasticState& elastic, std::size_t first,
                                  const CreepStrainView& creep, const Vector3& inner_force, double* stress) const {
    Tensors values;
    set_stress(u, elastic, first, creep, inner_force, values);
    write(values, stress);
  }

  CREEPCONTACT_INLINE void initial_strain_force(const ElasticState& elastic, std::size_t first,
                                                const CreepStrainView& creep, const Vector3& inner_force,
                                                double* forces) const {
    Tensors values;
    set_stress(nullptr, elastic, first, creep, inner_force, values);
    force(-1.0, values, forces);
  }

  CREEPCONTACT_INLINE void internal_force(const double* stress, double* forces) const {
    Tensors values;
    read(stress, values);
    force(1.0, values, forces);
  }

  CREEPCONTACT_INLINE void project_trace(double unprojected, Tensors& values) const {
    const std::optional<TraceProjection<D>> projection = projected(unprojected, values);
    if (!projection) return;
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p) __attribute__((always_inline)) {
          LaneTensor<V> tensor = tensor_at<V>(values, p);
          add_normal(projection->shift(p, trace(tensor)), tensor);
          set(tensor, p, values);
        });
  }

  /// B u without projection.
  CREEPCONTACT_INLINE void set_strain(const double* u, Tensors& values) const {
    NodalValues nodal;
    take_nodes(u, nodal);
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p)
                       __attribute__((always_inline)) { set(strain<V>(nodal, u, p), p, values); });
  }

  /// Nodal forces of sign * stress.
  CREEPCONTACT_INLINE void force(double sign, const Tensors& stress, double* forces) const {
    const std::optional<TraceProjection<D>> projection = projected(element_.unprojected, stress);
    std::array<Column, D * D> flux;  // weight * component i of stress . grad xi_k
    Column hoop;
    LaneSum axial;
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p) __attribute__((always_inline)) {
          LaneTensor<V> tensor = tensor_at<V>(stress, p);
          if (projection) add_normal(projection->shift(p, trace(tensor)), tensor);
          const V weight = sign * load<V>(element_.weight + p), shear = half_sqrt2 * weight;
          for_constants<6>([&](auto i) { tensor[i] *= i < 3 ? weight : shear; });
          for_constants<D>([&](auto k) {
            std::array<V, D> gradient;
            for_constants<D>([&](auto j) { gradient[j] = load<V>(element_.inverse + (3 * k + j) * n_points_ + p); });
            for_constants<D>([&](auto i) {
              V sum = gradient[0] * tensor[component[i][0]];
              for_constants<D - 1>([&](auto j) { sum += gradient[j + 1] * tensor[component[i][j + 1]]; });
              store(sum, &flux[D * i + k][p]);
            });
          });
          if constexpr (D == 2) {
            if (element_.is_axisymmetric) store(tensor[2] * load<V>(element_.inverse_radius + p), &hoop[p]);
            if (element_.has_axial_node) axial.add(tensor[2]);
          }
        });
    std::size_t a = 0;
    for (; a + 8 < element_.n_nodes; a += 12) add_up<3>(a, flux, hoop, forces);
    if (a + 4 < element_.n_nodes)
      add_up<2>(a, flux, hoop, forces);
    else if (a < element_.n_nodes)
      add_up<1>(a, flux, hoop, forces);
    if (D == 2 && element_.has_axial_node) {
      double* const out = forces + 3 * element_.n_nodes;
      out[0] = out[1] = 0;
      out[2] = axial.value() / element_.axial_length;
    }
  }

  CREEPCONTACT_INLINE void read(const double* from, Tensors& values) const {
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p)
                       __attribute__((always_inline)) { set(gathered<V>(from + 6 * p, 6), p, values); });
  }
  CREEPCONTACT_INLINE void write(const Tensors& values, double* to) const {
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p)
                       __attribute__((always_inline)) { scatter(tensor_at<V>(values, p), to + 6 * p); });
  }

 private:
  /// The projection of the trace of the values; none if all of it stays as it is.
  CREEPCONTACT_INLINE std::optional<TraceProjection<D>> projected(double unprojected, const Tensors& values) const {
    std::optional<TraceProjection<D>> projection;
    if (plain || !changes_trace(element_, unprojected)) return projection;
    projection.emplace(element_, unprojected);
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p)
                       __attribute__((always_inline)) { projection->add(p, trace(tensor_at<V>(values, p))); });
    projection->finish();
    return projection;
  }

  /// Forces on the nodes from `first` on, four of them in a vector: their sums over the points stay in registers.
  template <std::size_t n_vectors>
  CREEPCONTACT_INLINE void add_up(std::size_t first, const std::array<Column, D * D>& flux, const Column& hoop,
                                  double* forces) const {
    std::array<std::array<Four, D>, n_vectors> sums;
    for_constants<n_vectors>([&](auto v) { for_constants<D>([&](auto i) { sums[v][i] = Four{}; }); });
    const std::size_t n = element_.n_padded;
    for (std::size_t p = 0; p < n_points_; ++p) {
      for_constants<D>([&](auto k) {
        for_constants<n_vectors>([&](auto v) {
          const Four derivative = load<Four>(element_.derivatives_by_points + (3 * p + k) * n + first + 4 * v);
          for_constants<D>([&](auto i) { sums[v][i] += derivative * flux[D * i + k][p]; });
        });
      });
      if (D == 2 && element_.is_axisymmetric)
        for_constants<n_vectors>(
            [&](auto v) { sums[v][0] += load<Four>(element_.shape_by_points + p * n + first + 4 * v) * hoop[p]; });
    }
    for_constants<n_vectors>([&](auto v) {
      const std::size_t a = first + 4 * v, n_nodes = element_.n_nodes - a;
      std::array<std::array<double, lanes>, 3> columns{};
      for_constants<D>([&](auto i) { store(sums[v][i], columns[i].data()); });
      for (std::size_t lane = 0; lane < lanes && lane < n_nodes; ++lane)
        for (std::size_t i = 0; i < 3; ++i) forces[3 * (a + lane) + i] = columns[i][lane];
    });
  }

  using NodalValues = std::array<double, ElementView::max_nodes * D>;

  CREEPCONTACT_INLINE void take_nodes(const double* u, NodalValues& nodal) const {
    for (std::size_t a = 0; a < element_.n_nodes; ++a)
      for (std::size_t i = 0; i < D; ++i) nodal[D * a + i] = u[3 * element_.nodes[a] + static_cast<std::int64_t>(i)];
  }

  template <typename V>
  CREEPCONTACT_INLINE LaneTensor<V> strain(const NodalValues& nodal, const double* u, std::size_t p) const {
    std::array<std::array<V, D>, D> by_xi;  // du_i/dxi_k
    for_constants<D>([&](auto i) { for_constants<D>([&](auto k) { by_xi[i][k] = V{}; }); });
    for (std::size_t a = 0; a < element_.n_nodes; ++a) {
      const double* const derivatives = element_.derivatives + 3 * a * n_points_ + p;
      for_constants<D>([&](auto k) {
        const V derivative = load<V>(derivatives + k * n_points_);
        for_constants<D>([&](auto i) { by_xi[i][k] += nodal[D * a + i] * derivative; });
      });
    }
    std::array<std::array<V, D>, D> gradient;  // du_i/dx_j
    for_constants<D>([&](auto j) {
      for_constants<D>([&](auto k) {
        const V inverse = load<V>(element_.inverse + (3 * k + j) * n_points_ + p);
        for_constants<D>([&](auto i) {
          const V product = inverse * by_xi[i][k];
          gradient[i][j] = k == 0 ? product : gradient[i][j] + product;
        });
      });
    });
    LaneTensor<V> strain;
    for_constants<6>([&](auto i) { strain[i] = V{}; });
    for_constants<D>([&](auto i) {
      strain[i] = gradient[i][i];
      for_constants<i>([&](auto j) { strain[component[i][j]] = half_sqrt2 * (gradient[i][j] + gradient[j][i]); });
    });
    if constexpr (D == 2) {
      if (element_.is_axisymmetric) {
        V radial{};
        for (std::size_t a = 0; a < element_.n_nodes; ++a)
          radial += nodal[D * a] * load<V>(element_.shape + a * n_points_ + p);
        strain[2] = radial * load<V>(element_.inverse_radius + p);
      }
      if (element_.has_axial_node)
        strain[2] = V{} + u[3 * element_.nodes[element_.n_nodes] + 2] / element_.axial_length;
    }
    return strain;
  }

  /// @param u  null: none @param first  number of the first point @param inner_force  on the bubble
  CREEPCONTACT_INLINE void set_stress(const double* u, const ElasticState& elastic, std::size_t first,
                                      const CreepStrainView& creep, const Vector3& inner_force, Tensors& values) const {
    NodalValues nodal;
    if (u) take_nodes(u, nodal);
    const bool is_uniform = plain || elastic.moduli.size() == 1;
    const bool is_isotropic = plain || elastic.matrices.empty();
    const bool has_bubble = !plain && element_.bubble && is_isotropic && !element_.is_axisymmetric;
    std::optional<TraceProjection<D>> projection;
    if (!plain && changes_trace(element_, element_.unprojected)) projection.emplace(element_, element_.unprojected);
    std::optional<BubbleTerms> bubble;
    if (has_bubble) bubble.emplace(element_, is_uniform);
    const auto moduli = [&]<typename V>(std::size_t p, V & lambda, V & twice_mu) __attribute__((always_inline)) {
      if (is_uniform) {
        lambda = V{} + elastic.moduli[0].lambda;
        twice_mu = V{} + 2 * elastic.moduli[0].mu;
        return;
      }
      static_assert(sizeof(Moduli) == 2 * sizeof(double));
      lambda = load<V>(&elastic.moduli[first + p].lambda, 2);
      twice_mu = 2 * load<V>(&elastic.moduli[first + p].mu, 2);
    };
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p) __attribute__((always_inline)) {
          LaneTensor<V> tensor;
          if (u)
            tensor = strain<V>(nodal, u, p);
          else
            for_constants<6>([&](auto i) { tensor[i] = V{}; });
          if (!creep.empty()) {
            const LaneTensor<V> known = gathered<V>(&creep.data[(first + p) * creep.stride], creep.stride);
            for_constants<6>([&](auto i) { tensor[i] -= known[i]; });
          }
          if (!elastic.thermal_strain.empty()) {
            const V thermal = -load<V>(&elastic.thermal_strain[first + p]);
            add_normal(thermal, tensor);
          }
          if (!elastic.thermal_tensors.empty()) {
            const LaneTensor<V> thermal = gathered<V>(&elastic.thermal_tensors[6 * (first + p)], 6);
            for_constants<6>([&](auto i) { tensor[i] -= thermal[i]; });
          }
          if (projection) projection->add(p, trace(tensor));
          if (bubble) {
            V lambda, twice_mu;
            moduli(p, lambda, twice_mu);
            bubble->add(p, tensor, lambda, twice_mu);
          }
          set(tensor, p, values);
        });
    if (projection) projection->finish();
    if (bubble) bubble->solve(*projection, inner_force);
    const bool is_bubble_by_matrices = !plain && element_.bubble && !has_bubble;
    for_each_lane(
        n_points_, [&]<typename V>(std::size_t p) __attribute__((always_inline)) {
          LaneTensor<V> tensor = tensor_at<V>(values, p);
          if (projection) add_normal(projection->shift(p, trace(tensor)), tensor);
          if (bubble) bubble->add_strain(p, tensor);
          if (is_isotropic && !is_bubble_by_matrices) {
            V lambda, twice_mu;
            moduli(p, lambda, twice_mu);
            to_stress(lambda, twice_mu, tensor);
          }
          set(tensor, p, values);
        });
    if (is_bubble_by_matrices || !is_isotropic) to_stress_by_points(elastic, first, inner_force, values);
  }

  template <typename V>
  CREEPCONTACT_INLINE void to_stress(const V& lambda, const V& twice_mu, LaneTensor<V>& tensor) const {
    if (D == 2 && element_.has_plane_stress) tensor[2] = -lambda / (lambda + twice_mu) * (tensor[0] + tensor[1]);
    const V spherical = lambda * trace(tensor);
    for_constants<6>([&](auto i) { tensor[i] *= twice_mu; });
    add_normal(spherical, tensor);
  }

  /// The stress of a projected strain where moduli are matrices, or the gradient of the bubble has a hoop strain.
  void to_stress_by_points(const ElasticState& elastic, std::size_t first, const Vector3& inner_force,
                           Tensors& values) const;

  const ElementView& element_;
  std::size_t n_points_;
};

Tensor6 point_value(const Tensors& values, std::size_t p) {
  Tensor6 result;
  for (std::size_t i = 0; i < 6; ++i) result[static_cast<Index>(i)] = values[i][p];
  return result;
}
void set_point(const Tensor6& value, std::size_t p, Tensors& values) {
  for (std::size_t i = 0; i < 6; ++i) values[i][p] = value[static_cast<Index>(i)];
}

using BubbleMatrix = Eigen::Matrix<double, 6, 3>;  // strain, or stress, of unit inner displacements

/// strain += P B_b a, a in equilibrium with H strain - initial stress and the force on the bubble.
/// @param stress  stress(p, B) gives H B for the B of a point @param initial_stress  n_points x 6, or empty
template <typename Stress>
void add_bubble_strain(const ElementView& element, const Stress& stress, std::span<const double> initial_stress,
                       const Vector3& force, Tensors& strain) {
  Matrix3 stiffness = Matrix3::Zero();
  Vector3 residual = force;
  for (std::size_t p = 0; p < element.n_points; ++p) {
    const BubbleMatrix matrix = bubble_strain_matrix(element, p), flux = element.weight[p] * stress(p, matrix);
    stiffness += matrix.transpose().lazyProduct(flux);
    residual -= flux.transpose().lazyProduct(point_value(strain, p));
    if (!initial_stress.empty())
      residual += element.weight[p] * matrix.transpose().lazyProduct(tensor::view(initial_stress, p));
  }
  const Vector3 a = stiffness.inverse() * residual;
  for (std::size_t p = 0; p < element.n_points; ++p)
    set_point(point_value(strain, p) + bubble_strain_matrix(element, p) * a, p, strain);
}

/// strain += P B_b a with the a that balances D strain - initial stress.
void add_tangent_bubble(const ElementView& element, std::span<const Matrix6> moduli,
                        std::span<const double> initial_stress, Tensors& strain) {
  if (!element.bubble) return;
  const auto stress = [&](std::size_t p, const BubbleMatrix& matrix) -> BubbleMatrix {
    return moduli[p].lazyProduct(matrix);
  };
  add_bubble_strain(element, stress, initial_stress, Vector3::Zero(), strain);
}

template <std::size_t D, bool plain>
void Loop<D, plain>::to_stress_by_points(const ElasticState& elastic, std::size_t first, const Vector3& inner_force,
                                         Tensors& values) const {
  if (elastic.matrices.empty()) {
    const auto stress = [&](std::size_t p, const BubbleMatrix& strain) {
      const Moduli& moduli = elastic.at(first + p);
      BubbleMatrix result = 2 * moduli.mu * strain;
      result.topRows<3>().rowwise() += moduli.lambda * strain.topRows<3>().colwise().sum();
      return result;
    };
    add_bubble_strain(element_, stress, {}, inner_force, values);
    for (std::size_t p = 0; p < n_points_; ++p) {
      LaneTensor<double> tensor = tensor_at<double>(values, p);
      const Moduli& moduli = elastic.at(first + p);
      to_stress(moduli.lambda, 2 * moduli.mu, tensor);
      set(tensor, p, values);
    }
    return;
  }
  const std::span<const Matrix6> matrices = elastic.matrices.subspan(first, n_points_);
  if (element_.bubble)
    add_bubble_strain(
        element_,
        [&](std::size_t p, const BubbleMatrix& strain) -> BubbleMatrix { return matrices[p].lazyProduct(strain); }, {},
        inner_force, values);
  for (std::size_t p = 0; p < n_points_; ++p) {
    Tensor6 strain = point_value(values, p);
    if (element_.has_plane_stress) {
      strain[2] = 0;
      strain[2] = -matrices[p].row(2).dot(strain) / matrices[p](2, 2);
    }
    set_point(matrices[p].lazyProduct(strain), p, values);
  }
}

/// work(loop) with the Loop of the element.
template <bool plain = false, typename Work>
CREEPCONTACT_INLINE void with_loop(const ElementView& element, std::size_t dimension, const Work& work) {
  if (dimension == 3)
    work(Loop<3, plain>(element));
  else
    work(Loop<2, plain>(element));
}

/// What the loops need to know of an element. A version of each for plain elements keeps its values in registers.
struct OfElement {
  const ElementView& view;
  std::size_t dimension;
  std::size_t first;  // number of its first point
};

template <bool plain>
CREEPCONTACT_INLINE void set_stress(const OfElement& element, const double* u, const ElasticState& elastic,
                                    const CreepStrainView& creep, const Vector3& inner_force, double* stress) {
  with_loop<plain>(
      element.view, element.dimension, [&](const auto& loop) __attribute__((always_inline)) {
        loop.stress(u, elastic, element.first, creep, inner_force, stress);
      });
}
template <bool plain>
CREEPCONTACT_INLINE void set_initial_strain_force(const OfElement& element, const ElasticState& elastic,
                                                  const CreepStrainView& creep, const Vector3& inner_force,
                                                  double* forces) {
  with_loop<plain>(
      element.view, element.dimension, [&](const auto& loop) __attribute__((always_inline)) {
        loop.initial_strain_force(elastic, element.first, creep, inner_force, forces);
      });
}

[[gnu::flatten]] CREEPCONTACT_LONG_VECTORS void stress_loop(const OfElement& element, const double* u,
                                                            const ElasticState& elastic, const CreepStrainView& creep,
                                                            const Vector3& inner_force, double* stress) {
  set_stress<false>(element, u, elastic, creep, inner_force, stress);
}
[[gnu::flatten]] CREEPCONTACT_LONG_VECTORS void plain_stress_loop(const OfElement& element, const double* u,
                                                                  const ElasticState& elastic,
                                                                  const CreepStrainView& creep, double* stress) {
  set_stress<true>(element, u, elastic, creep, Vector3::Zero(), stress);
}
[[gnu::flatten]] CREEPCONTACT_LONG_VECTORS void initial_strain_loop(const OfElement& element,
                                                                    const ElasticState& elastic,
                                                                    const CreepStrainView& creep,
                                                                    const Vector3& inner_force, double* forces) {
  set_initial_strain_force<false>(element, elastic, creep, inner_force, forces);
}
[[gnu::flatten]] CREEPCONTACT_LONG_VECTORS void plain_initial_strain_loop(const OfElement& element,
                                                                          const ElasticState& elastic,
                                                                          const CreepStrainView& creep,
                                                                          double* forces) {
  set_initial_strain_force<true>(element, elastic, creep, Vector3::Zero(), forces);
}

[[gnu::flatten]] CREEPCONTACT_LONG_VECTORS void force_loop(const ElementView& element, std::size_t dimension,
                                                           const double* stress, double* forces) {
  with_loop(
      element,
      dimension, [&](const auto& loop) __attribute__((always_inline)) { loop.internal_force(stress, forces); });
}

}  // namespace

template <typename Work>
void ElementBlock::for_each_element(const Work& work) const {
  numerics::for_each_index(n_elements(), numerics::parallel_elements,
                           [&](std::size_t e) { work(view(e), e, start_.point + e * n_points_); });
}

ElementView ElementBlock::view(std::size_t e) const {
  return {.n_nodes = n_nodes_,
          .n_points = n_points_,
          .nodes = connectivity_.data() + e * n_coupled_,
          .n_padded = n_padded(),
          .derivatives = derivative_lanes_.data(),
          .derivatives_by_points = derivatives_by_points_.data(),
          .shape = shape_lanes_.data(),
          .shape_by_points = shape_by_points_.data(),
          .inverse = geometry(e),
          .weight = geometry(e) + 9 * n_points_,
          .linear = linear_functions(e),
          .inverse_radius = inverse_radius(e),
          .bubble = has_bubble() ? &bubbles_[e] : nullptr,
          .bubble_derivatives = bubble_derivatives_.data(),
          .bubble_values = bubble_values_.data(),
          .projection = projection(),
          .unprojected = fits_mean_stress() ? unprojected_part_[e] : 0,
          .axial_length = section_.axial_length,
          .is_axisymmetric = section_.is_axisymmetric(),
          .has_axial_node = section_.has_axial_node(),
          .has_plane_stress = has_plane_stress()};
}

Vector3 ElementBlock::inner_force(const ElasticState& elastic, std::size_t e) const {
  if (!has_bubble() || elastic.inner_force.empty()) return Vector3::Zero();
  return Vector3::Map(&elastic.inner_force[3 * (start_.inner + e)]);
}

double* ElementBlock::forces_of(std::size_t e, std::span<double> element_forces) const {
  return &element_forces[3 * (start_.entry + e * n_coupled_)];
}

void ElementBlock::stress(std::span<const double> u, const ElasticState& elastic, const CreepStrainView& creep,
                          std::span<double> stress) const {
  for_each_element([&](const ElementView& element, std::size_t e, std::size_t first) {
    const OfElement of{element, dimension(), first};
    if (is_plain(element, elastic))
      plain_stress_loop(of, u.data(), elastic, creep, &stress[6 * first]);
    else
      stress_loop(of, u.data(), elastic, creep, inner_force(elastic, e), &stress[6 * first]);
  });
}

void ElementBlock::internal_force(std::span<const double> stress, std::span<double> element_forces) const {
  for_each_element([&](const ElementView& element, std::size_t e, std::size_t first) {
    force_loop(element, dimension(), &stress[6 * first], forces_of(e, element_forces));
  });
}

void ElementBlock::initial_strain_force(const ElasticState& elastic, const CreepStrainView& creep,
                                        std::span<double> element_forces) const {
  for_each_element([&](const ElementView& element, std::size_t e, std::size_t first) {
    const OfElement of{element, dimension(), first};
    if (is_plain(element, elastic))
      plain_initial_strain_loop(of, elastic, creep, forces_of(e, element_forces));
    else
      initial_strain_loop(of, elastic, creep, inner_force(elastic, e), forces_of(e, element_forces));
  });
}

// The loops below serve tangents and results: their cost is that of the matrices, or small.

void ElementBlock::fit_mean_stress(std::span<double> stress) const {
  if (!fits_mean_stress()) return;
  for_each_element([&](const ElementView& element, std::size_t, std::size_t first) {
    with_loop(element, dimension(), [&](const auto& loop) {
      Tensors values;
      loop.read(&stress[6 * first], values);
      loop.project_trace(0, values);
      loop.write(values, &stress[6 * first]);
    });
  });
}

void ElementBlock::tangent_strain(std::span<const double> u, std::span<const Matrix6> moduli,
                                  std::span<const double> initial_stress, std::span<double> strain) const {
  for_each_element([&](const ElementView& element, std::size_t, std::size_t first) {
    with_loop(element, dimension(), [&](const auto& loop) {
      Tensors values;
      loop.set_strain(u.data(), values);
      loop.project_trace(element.unprojected, values);
      add_tangent_bubble(element, moduli.subspan(first), initial_stress.subspan(6 * first), values);
      for (std::size_t p = 0; p < n_points_ && has_plane_stress(); ++p) {
        const auto zz = moduli[first + p].row(2);
        values[2][p] = 0;
        const double known = zz.dot(point_value(values, p));
        values[2][p] = (initial_stress[6 * (first + p) + 2] - known) / zz[2];
      }
      loop.write(values, &strain[6 * first]);
    });
  });
}

void ElementBlock::initial_stress_force(std::span<const Matrix6> moduli, std::span<const double> initial_stress,
                                        std::span<double> element_forces) const {
  for_each_element([&](const ElementView& element, std::size_t e, std::size_t first) {
    Tensors stress, strain{};
    if (element.bubble) add_tangent_bubble(element, moduli.subspan(first), initial_stress.subspan(6 * first), strain);
    for (std::size_t p = 0; p < n_points_; ++p) {
      Tensor6 value = tensor::view(initial_stress, first + p);
      if (element.bubble) value -= moduli[first + p].lazyProduct(point_value(strain, p));
      if (has_plane_stress()) {
        const auto zz = moduli[first + p].row(2);
        value -= value[2] / zz[2] * zz.transpose();
      }
      set_point(value, p, stress);
    }
    with_loop(element, dimension(), [&](const auto& loop) { loop.force(1.0, stress, forces_of(e, element_forces)); });
  });
}

}  // namespace creepcontact::mechanics
