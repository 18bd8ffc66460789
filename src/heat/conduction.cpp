#include "creepcontact/heat/conduction.hpp"

#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numeric>
#include <utility>

#include "creepcontact/base/disjoint_sets.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/numerics/parallel.hpp"
#include "kept_factor.hpp"
#include "patches.hpp"

namespace creepcontact::heat {
namespace {

constexpr int most_iterations = 300;
constexpr double steady_tolerance = 1e-12;                        // of the largest flow at a node
constexpr double least_part = 1e-4;                               // of a Newton step
constexpr double of_a_newton_step = 1e-6, of_a_correction = 0.1;  // errors of solutions
constexpr int most_stalled = 4;                                   // iterations in which the residual has not halved
constexpr double rounding_step = 1e-8;                            // of the temperatures
constexpr std::int32_t not_stored = -1;
constexpr double capacity_tolerance = 1e-14;    // where the matrix has capacities alone
constexpr int most_capacity_iterations = 1000;  // some 100 are usual

double norm(std::span<const double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values)).norm();
}

/// x = M^-1 x by conjugate gradients, whose iterations together cost less than a factorisation of capacities would.
/// @param lower  triangle of M @returns false, and x as it was, without convergence
bool solve_well_conditioned(const linalg::SparseMatrix& lower, std::span<double> x) {
  Eigen::ConjugateGradient<linalg::SparseMatrix, Eigen::Lower> solver(lower);
  solver.setTolerance(capacity_tolerance);
  solver.setMaxIterations(most_capacity_iterations);
  Eigen::Map<Eigen::VectorXd> given(x.data(), std::ssize(x));
  const Eigen::VectorXd solution = solver.solve(given);
  if (solver.info() != Eigen::Success || !solution.allFinite()) return false;
  given = solution;
  return true;
}

}  // namespace

double Balance::rest() const {
  const auto sum = [](const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); };
  return sum(flows) + sum(sources) + sum(points) + sum(given) - stored;
}

struct Conduction::Impl {
  explicit Impl(Definition from) : definition(std::move(from)) {
    number_unknowns();
    for (std::size_t b = 0; b < definition.bodies.size(); ++b)
      append(cell_patches(definition.bodies[b], unknown_of[b], definition.time_unit));
    for (const SurfaceFlow& flow : definition.flows)
      append(flow_patches(flow, definition.bodies[flow.body], unknown_of[flow.body], definition.absolute_zero));
    for (const Source& source : definition.sources)
      append(source_patches(source, definition.bodies[source.body], unknown_of[source.body]));
    for (const PointFlow& flow : definition.point_flows) append(point_patches(flow, definition, unknown_of));
    for (const Interface& interface : definition.interfaces)
      append(interface_patches(interface, definition, unknown_of));
    for (std::size_t g = 0; g < definition.given.size(); ++g)
      for (const std::int64_t node : definition.given[g].nodes)
        given[static_cast<std::size_t>(unknown_of[definition.given[g].body][static_cast<std::size_t>(node)])] =
            static_cast<int>(g);
    make_pattern();
    residuals.resize(patches.size());
    matrices.resize(patches.size());
  }

  void append(Patches made) {
    groups.push_back(patches.size());
    std::ranges::move(made, std::back_inserter(patches));
  }

  void number_unknowns() {
    std::vector<std::size_t> first{0};
    for (const Conductor& body : definition.bodies) first.push_back(first.back() + body.mesh->n_cell_nodes());
    DisjointSets sets(first.back());
    for (const auto& [a, b] : definition.equal)
      sets.join(first[a.body] + static_cast<std::size_t>(a.node), first[b.body] + static_cast<std::size_t>(b.node));
    std::vector<int> number(first.back(), -1);
    for (std::size_t b = 0; b < definition.bodies.size(); ++b) {
      std::vector<int>& own = unknown_of.emplace_back();
      for (std::size_t i = first[b]; i < first[b + 1]; ++i) {
        int& unknown = number[sets.find(i)];
        if (unknown < 0) {
          unknown = static_cast<int>(places.size());
          places.push_back(definition.bodies[b].mesh->nodes[i - first[b]]);
          bodies.push_back(b);
        }
        own.push_back(unknown);
      }
    }
    given.assign(places.size(), -1);
  }

  /// Where in the matrix the entries of the patches are, column by column.
  void make_pattern() {
    const auto is_stored = [&](int i, int j) { return i >= j && (i == j || (given[i] < 0 && given[j] < 0)); };
    const std::size_t n = places.size();
    std::vector<std::vector<const Patch*>> patches_of(n);
    for (const auto& patch : patches)
      for (const int j : patch->nodes)
        if (patches_of[j].empty() || patches_of[j].back() != patch.get()) patches_of[j].push_back(patch.get());
    std::vector<std::int64_t> starts{0}, rows;
    std::vector<int> found_for(n, -1);  // the last column that has this row
    for (int j = 0; j < static_cast<int>(n); ++j) {
      rows.push_back(j);
      found_for[j] = j;
      for (const Patch* patch : patches_of[j])
        for (const int i : patch->nodes)
          if (is_stored(i, j) && std::exchange(found_for[i], j) != j) rows.push_back(i);
      std::sort(rows.begin() + starts.back(), rows.end());
      starts.push_back(std::ssize(rows));
    }
    const std::vector<double> zeros(rows.size(), 0.0);
    matrix = Eigen::Map<const linalg::SparseMatrix>(std::ssize(places), std::ssize(places), std::ssize(rows),
                                                    starts.data(), rows.data(), zeros.data());
    for (const auto& patch : patches)
      for (const int j : patch->nodes) {
        const auto *begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[j],
                   *end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[j + 1];
        for (const int i : patch->nodes)
          positions.push_back(is_stored(i, j) && given[i] < 0
                                  ? static_cast<std::int32_t>(std::lower_bound(begin, end, i) - matrix.innerIndexPtr())
                                  : not_stored);
      }
  }

  double given_value(std::size_t unknown, double t) const {
    const Vector3& x = places[unknown];
    return definition.given[static_cast<std::size_t>(given[unknown])].value({.x = x[0], .y = x[1], .z = x[2], .t = t});
  }
  /// Exact for what is linear within the segment.
  double given_rate(std::size_t unknown, double t) const {
    const double span = std::isfinite(segment_end) ? segment_end - segment_begin : std::max(1.0, std::abs(t));
    const double from = std::max(segment_begin, t - small_part * span),
                 to = std::min(segment_end, t + small_part * span);
    return to > from ? (given_value(unknown, to) - given_value(unknown, from)) / (to - from) : 0;
  }

  /// The temperatures and rates of all unknowns, with the given ones.
  void complete(double t, std::span<const double> y, std::span<const double> rate) {
    T = Eigen::Map<const Eigen::VectorXd>(y.data(), std::ssize(y));
    T_rate = rate.empty() ? Eigen::VectorXd::Zero(T.size())
                          : Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(rate.data(), std::ssize(rate)));
    for (std::size_t u = 0; u < given.size(); ++u) {
      if (given[u] < 0) continue;
      T[static_cast<Index>(u)] = given_value(u, t);
      T_rate[static_cast<Index>(u)] = rate.empty() ? 0 : given_rate(u, t);
    }
  }

  void evaluate(const Moment& at, bool with_matrix) {
    std::exception_ptr failure;  // none may leave a thread
    numerics::for_each_index(patches.size(), numerics::parallel_elements, [&](std::size_t p) {
      const Patch& patch = *patches[p];
      const auto n = std::ssize(patch.nodes);
      thread_local Eigen::VectorXd own, own_rate;  // no allocations
      own.resize(n);
      own_rate.resize(n);
      for (Index i = 0; i < n; ++i) {
        own[i] = T[patch.nodes[static_cast<std::size_t>(i)]];
        own_rate[i] = T_rate[patch.nodes[static_cast<std::size_t>(i)]];
      }
      residuals[p].resize(n);
      try {
        patch.evaluate(at, own, own_rate, residuals[p], with_matrix ? &matrices[p] : nullptr);
      } catch (...) {
#pragma omp critical
        failure = std::current_exception();
      }
    });
    if (failure) std::rethrow_exception(failure);
  }

  /// @param scale  not empty: sums of the absolute values
  void gather(std::span<double> into, std::span<double> scale = {}) const {
    std::ranges::fill(into, 0.0);
    std::ranges::fill(scale, 0.0);
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (std::size_t i = 0; i < patches[p]->nodes.size(); ++i) {
        const double value = residuals[p][static_cast<Index>(i)];
        into[static_cast<std::size_t>(patches[p]->nodes[i])] += value;
        if (!scale.empty()) scale[static_cast<std::size_t>(patches[p]->nodes[i])] += std::abs(value);
      }
  }

  /// Adds the matrices of the patches.
  void gather_matrices(Eigen::Ref<Eigen::VectorXd> into) const {
    into.setZero();
    std::size_t k = 0;
    for (const Eigen::MatrixXd& matrix_of_patch : matrices)
      for (const double value : matrix_of_patch.reshaped())
        if (const std::int32_t at = positions[k++]; at != not_stored) into[at] += value;
  }
  void gather_capacities() {
    numerics::for_each_index(patches.size(), numerics::parallel_elements, [&](std::size_t p) {
      const auto n = std::ssize(patches[p]->nodes);
      thread_local Eigen::VectorXd own;
      own.resize(n);
      for (Index i = 0; i < n; ++i) own[i] = T[patches[p]->nodes[static_cast<std::size_t>(i)]];
      if (!patches[p]->capacities(own, matrices[p])) matrices[p].setZero(n, n);
    });
    capacities.resize(matrix.nonZeros());
    gather_matrices(capacities);
  }
  void hold_given() {
    const auto diagonal = [&](std::size_t u) -> double& {  // the first of its column
      return matrix.valuePtr()[matrix.outerIndexPtr()[u]];
    };
    of_given = 0;
    for (std::size_t u = 0; u < given.size(); ++u)
      if (given[u] < 0) of_given = std::max(of_given, diagonal(u));
    if (!(of_given > 0)) of_given = 1;
    for (std::size_t u = 0; u < given.size(); ++u)
      if (given[u] >= 0) diagonal(u) = of_given;
  }

  /// The matrix of the last evaluation.
  void assemble() {
    gather_matrices(Eigen::Map<Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros()));
    hold_given();
    factor.set(matrix);
  }
  /// The matrix becomes conduction + c capacities.
  void shift(double c) {
    if (c == shifted_by) return;
    Eigen::Map<Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros()) = conduction + c * capacities;
    hold_given();
    factor.set(matrix);
    shifted_by = c;
  }

  /// @param work  with the factor, which may be singular
  template <typename Work>
  void with_factor(const Work& work) {
    try {
      work();
    } catch (const linalg::SingularMatrix& singular) {
      const std::string& name =
          definition.bodies[bodies[static_cast<std::size_t>(std::max<std::int64_t>(singular.row, 0))]].name;
      throw ModelError(fmt::format(
          "nothing holds the temperature of body '{}': it has no given temperature, no film whose coefficient is "
          "above zero, and no contact that conducts to a body that has one; or its conductivity or its heat capacity "
          "is "
          "zero",
          name));
    }
  }
  void factorize() {
    with_factor([&] { factor.factorize(); });
  }
  void solve(std::span<double> x, KeptFactor::Accuracy accuracy) {
    for (std::size_t u = 0; u < given.size(); ++u)
      if (given[u] >= 0) x[u] *= of_given;
    with_factor([&] { factor.solve(x, accuracy); });
  }

  static constexpr double small_part = 1e-6;  // of a segment, for derivatives
  Definition definition;
  UnknownOf unknown_of;
  std::vector<Vector3> places;      // of the unknowns
  std::vector<std::size_t> bodies;  // that they belong to
  std::vector<int> given;           // by unknown: index of the given temperature, or -1
  Patches patches;
  std::vector<std::size_t> groups;  // first patches: of bodies, flows, sources, points, interfaces
  linalg::SparseMatrix matrix;      // lower triangle
  double of_given = 1;  // diagonal of given temperatures: of the size of the others, so that these have pivots
  std::vector<std::int32_t> positions;
  std::vector<Eigen::VectorXd> residuals;
  std::vector<Eigen::MatrixXd> matrices;
  Eigen::VectorXd T, T_rate;
  KeptFactor factor;
  Eigen::VectorXd conduction, capacities;  // parts of the entries of the matrix, as prepared
  double shifted_by = std::numeric_limits<double>::quiet_NaN();
  double segment_begin = -std::numeric_limits<double>::infinity(), segment_end = -segment_begin;
};

Conduction::Conduction(Definition definition) : impl_(std::make_unique<Impl>(std::move(definition))) {}
Conduction::~Conduction() = default;

const Definition& Conduction::definition() const {
  return impl_->definition;
}
std::size_t Conduction::size() const {
  return impl_->places.size();
}
std::size_t Conduction::n_factorizations() const {
  return impl_->factor.n_factorizations();
}
std::size_t Conduction::n_passes() const {
  return impl_->factor.n_passes();
}
const std::vector<std::vector<int>>& Conduction::unknown_of() const {
  return impl_->unknown_of;
}
std::vector<double> Conduction::unknowns(const Function& temperature) const {
  std::vector<double> result;
  for (const Vector3& x : impl_->places) result.push_back(temperature({.x = x[0], .y = x[1], .z = x[2]}));
  return result;
}

std::vector<double> Conduction::unknowns(std::span<const std::vector<double>> at_nodes) const {
  std::vector<double> result(size());
  for (std::size_t b = 0; b < at_nodes.size(); ++b)
    for (std::size_t i = 0; i < at_nodes[b].size(); ++i)
      result[static_cast<std::size_t>(impl_->unknown_of[b][i])] = at_nodes[b][i];
  return result;
}

std::vector<double> Conduction::at_nodes(std::size_t body, std::span<const double> unknowns) const {
  std::vector<double> result;
  for (const int unknown : impl_->unknown_of[body]) result.push_back(unknowns[static_cast<std::size_t>(unknown)]);
  return result;
}

void Conduction::set_segment(double begin, double end) {
  impl_->segment_begin = begin;
  impl_->segment_end = end;
}

void Conduction::residual(double t, std::span<const double> y, std::span<const double> rate,
                          std::span<double> residual) {
  impl_->complete(t, y, rate);
  impl_->evaluate({.t = t}, false);
  impl_->gather(residual);
  for (std::size_t u = 0; u < size(); ++u)
    if (impl_->given[u] >= 0) residual[u] = y[u] - impl_->given_value(u, t);
}

void Conduction::prepare(double t, std::span<const double> y, std::span<const double> rate, double c) {
  impl_->complete(t, y, rate);
  impl_->evaluate({.t = t}, true);
  impl_->conduction.resize(impl_->matrix.nonZeros());
  impl_->gather_matrices(impl_->conduction);
  impl_->gather_capacities();
  impl_->shifted_by = std::numeric_limits<double>::quiet_NaN();
  impl_->shift(c);
}

void Conduction::shift(double c) {
  impl_->shift(c);
}

void Conduction::solve(std::span<double> x, double tolerance) {
  impl_->solve(x, {of_a_correction, tolerance});
}

void Conduction::steady(double t, std::span<double> y, const ContactAtNodes& contact) {
  Impl& own = *impl_;
  const bool radiates = std::ranges::any_of(
      own.definition.flows, [](const SurfaceFlow& flow) { return flow.kind == SurfaceFlow::Kind::radiation; });
  std::vector<double> residual(size()), scale(size()), trial(size()), step(size());
  const auto evaluate = [&](std::span<double> at, bool with_matrix) {
    own.complete(t, at, {});
    std::copy_n(own.T.data(), size(), at.begin());
    own.evaluate({.t = t, .contact = contact}, with_matrix);
    own.gather(residual, scale);
    for (std::size_t u = 0; u < size(); ++u)
      if (own.given[u] >= 0) residual[u] = 0;
    return norm(residual);
  };
  double smallest = std::numeric_limits<double>::infinity();
  int stalled = 0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double before = evaluate(y, true);
    if (!std::isfinite(before)) throw SolverError(fmt::format("heat: no finite heat flows at t = {:.6g}", t));
    const double allowed = steady_tolerance * *std::ranges::max_element(scale);
    if (iteration > 0 && std::ranges::all_of(residual, [&](double value) { return std::abs(value) <= allowed; }))
      return;
    own.assemble();
    if (iteration == 0) own.factorize();
    step = residual;
    own.solve(step, {of_a_newton_step});
    const double size_of_step = norm(step);
    for (double part = 1;; part /= 2) {
      for (std::size_t u = 0; u < size(); ++u) trial[u] = y[u] - part * step[u];
      const bool is_possible =
          !radiates || std::ranges::all_of(trial, [&](double value) { return value > own.definition.absolute_zero; });
      if (is_possible && (evaluate(trial, false) < before || part * size_of_step <= 1e-14 * norm(trial))) break;
      if (part < least_part) break;
    }
    std::ranges::copy(trial, y.begin());
    // Flows across thin elements are far larger than those along them, and leave their rounding.
    stalled = before > smallest / 2 ? stalled + 1 : 0;
    smallest = std::min(smallest, before);
    if (stalled >= most_stalled && size_of_step <= rounding_step * norm(y)) return;
  }
  throw SolverError(
      fmt::format("heat: no steady temperatures found at t = {:.6g} in {} iterations; is one of the functions of T "
                  "discontinuous, or has the problem no steady state?",
                  t, most_iterations));
}

void Conduction::make_consistent(double t, std::span<double> y, std::span<double> rate, const ContactAtNodes& contact) {
  Impl& own = *impl_;
  std::ranges::fill(rate, 0.0);
  own.complete(t, y, rate);
  std::copy_n(own.T.data(), size(), y.begin());
  own.evaluate({.t = t, .conduction = 0, .capacity = 1, .contact = contact}, true);
  std::vector<double> residual(size());
  own.gather(residual);
  for (std::size_t u = 0; u < size(); ++u)
    if (own.given[u] >= 0) residual[u] = 0;
  own.assemble();
  if (!solve_well_conditioned(own.matrix, residual)) {
    own.factorize();
    own.solve(residual, {});
  }
  for (std::size_t u = 0; u < size(); ++u) rate[u] = own.given[u] >= 0 ? own.given_rate(u, t) : -residual[u];
}

bool Conduction::is_given(std::size_t unknown) const {
  return impl_->given[unknown] >= 0;
}
double Conduction::given_value(std::size_t unknown, double t) const {
  return impl_->given_value(unknown, t);
}
double Conduction::given_rate(std::size_t unknown, double t) const {
  return impl_->given_rate(unknown, t);
}
bool Conduction::has_constant_capacity() const {
  return std::ranges::none_of(definition().bodies,
                              [](const Conductor& body) { return body.capacity.depends_on_temperature(); });
}

void Conduction::inflow(double t, std::span<const double> y, const ContactAtNodes& contact, std::span<double> into) {
  impl_->complete(t, y, {});
  impl_->evaluate({.t = t, .contact = contact}, false);
  impl_->gather(into);
  for (std::size_t u = 0; u < size(); ++u) into[u] = is_given(u) ? 0 : -into[u];
}

const linalg::SparseMatrix& Conduction::matrix(double t, std::span<const double> y, const ContactAtNodes& contact,
                                               double conduction, double capacity) {
  impl_->complete(t, y, {});
  impl_->evaluate({.t = t, .conduction = conduction, .capacity = capacity, .contact = contact}, true);
  impl_->gather_matrices(Eigen::Map<Eigen::VectorXd>(impl_->matrix.valuePtr(), impl_->matrix.nonZeros()));
  impl_->hold_given();
  return impl_->matrix;
}

double Conduction::flow_scale(double t, std::span<const double> y, const ContactAtNodes& contact) {
  const linalg::SparseMatrix& K = matrix(t, y, contact, 1, 0);
  double result = 0;
  for (std::size_t u = 0; u < size(); ++u)
    if (!is_given(u)) result = std::max(result, std::abs(K.valuePtr()[K.outerIndexPtr()[u]] * y[u]));
  return result;
}

Balance Conduction::balance(double t, std::span<const double> y, std::span<const double> rate,
                            const ContactAtNodes& contact) const {
  Impl& own = *impl_;
  const Definition& all = own.definition;
  Balance result;
  own.complete(t, y, rate);
  own.evaluate({.t = t, .contact = contact}, false);
  std::vector<double> total(size());
  own.gather(total);
  result.given.assign(all.given.size(), 0.0);
  for (std::size_t u = 0; u < size(); ++u)
    if (own.given[u] >= 0) result.given[static_cast<std::size_t>(own.given[u])] += total[u];
  const auto sum_of_group = [&](std::size_t group) {
    const std::size_t end = group + 1 < own.groups.size() ? own.groups[group + 1] : own.patches.size();
    double sum = 0;
    for (std::size_t p = own.groups[group]; p < end; ++p) sum += own.residuals[p].sum();
    return sum;
  };
  std::size_t group = 0;
  for (; group < all.bodies.size(); ++group) result.stored += sum_of_group(group);  // conduction adds up to zero
  for (std::size_t i = 0; i < all.flows.size(); ++i) result.flows.push_back(-sum_of_group(group++));
  for (std::size_t i = 0; i < all.sources.size(); ++i) result.sources.push_back(-sum_of_group(group++));
  for (std::size_t i = 0; i < all.point_flows.size(); ++i) result.points.push_back(-sum_of_group(group++));
  for (const Interface& interface : all.interfaces) {
    const std::size_t first = own.groups[group++];
    double sum = 0;
    for (std::size_t f = 0; f < interface.faces.size(); ++f)
      sum += own.residuals[first + f].head(std::ssize(interface.faces[f].first_nodes)).sum();
    result.interfaces.push_back(sum);
  }
  return result;
}

}  // namespace creepcontact::heat
