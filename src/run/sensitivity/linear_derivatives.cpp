#include "linear_derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/numerics/long_vectors.hpp"

namespace creepcontact::run {
namespace {

constexpr double rounding = 1e-12;  // of the largest gap or pressure

Eigen::VectorXd central_difference(const Eigen::VectorXd& more, const Eigen::VectorXd& less) {
  return (more - less) / (2 * relative_change);
}
/// more = central difference
void replace_by_difference(std::vector<double>& more, std::span<const double> less) {
  numerics::for_each_piece(more.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) more[i] = run::central_difference(more[i], less[i]);
  });
}

/// into += central difference
void add_difference(std::span<const double> more, std::span<const double> less, std::span<double> into) {
  numerics::for_each_piece(into.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) into[i] += run::central_difference(more[i], less[i]);
  });
}
/// forces += the difference of the external forces on the free unknowns.
void add_difference_of_loads(const mechanics::BodyConditions& more, const mechanics::BodyConditions& less,
                             const mechanics::Body& body, std::vector<double>& forces) {
  const std::span<const double> of_more = more.external_forces(), of_less = less.external_forces();
  if (std::ranges::equal(of_more, of_less)) return;
  std::vector<double> change(of_more.begin(), of_more.end()), free(forces.size());
  replace_by_difference(change, of_less);
  body.constraints().restrict_to_free(change, free);
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] += free[i];
}

}  // namespace

bool LinearDerivatives::suit(const creep::EquilibriumSolver& solver) {
  const creep::Assembly& assembly = solver.assembly();
  return solver.is_piecewise_linear() && assembly.heat() == nullptr &&
         std::ranges::none_of(assembly.pairs(), [](const contact::Pair& pair) { return pair.is_relative; });
}

LinearDerivatives::LinearDerivatives(const std::vector<ChangedValue>& values, creep::CreepSystem& system,
                                     creep::EquilibriumSolver& solver, std::vector<std::unique_ptr<NearbyModel>> models,
                                     Stopwatch& watch)
    : Derivatives(values, system),
      solver_(solver),
      watch_(watch),
      models_(std::move(models)),
      interference_(values.size(), std::vector<double>(solver.assembly().pairs().size(), 0.0)),
      equations_(values.size()),
      changes_(values.size()) {}

Eigen::VectorXd LinearDerivatives::gap_of(const contact::Pair& pair) const {
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(solver_.interface().n_rows());
  gap.segment(pair.first_row, pair.coupling.n_rows()) = pair.interference_gap();
  return gap;
}

bool LinearDerivatives::follows_displacements(std::size_t k, const creep::Equilibrium& at) const {
  for (std::size_t b = 0; b < solver_.assembly().bodies().size(); ++b)
    if (more(k).stresses_differ(b, at) || less(k).stresses_differ(b, at)) return true;
  return false;
}

void LinearDerivatives::equations(std::size_t k, const creep::Equilibrium& at, const creep::Evaluation* solved,
                                  std::span<const double> state_change, creep::EquationChange& change) {
  const auto lap = watch_.lap(Part::material);
  NearbyModel &with_more = more(k), &with_less = less(k);
  const contact::InterfaceLoad load = with_more.load(at), opposite = with_less.load(at);
  change.gap = central_difference(load.gap, opposite.gap);
  change.work = central_difference(load.work, opposite.work);
  base().layout().views(state_change, change.strain);
  change.stress.resize(change.strain.size());
  change.forces.resize(change.strain.size());
  for (std::size_t b = 0; b < change.strain.size(); ++b) {
    const mechanics::FactoredBody& factored = solver_.interface().factored(b);
    const mechanics::Body& body = factored.body();
    std::vector<double>& forces = change.forces[b];
    forces.resize(static_cast<std::size_t>(body.constraints().n_free()));
    if (solved != nullptr && (with_more.stresses_differ(b, at) || with_less.stresses_differ(b, at))) {
      with_more.stress(b, *solved, change.strain[b], change.stress[b]);
      with_less.stress(b, *solved, change.strain[b], opposite_);
      replace_by_difference(change.stress[b], opposite_);
      change.strain[b] = {};
      body.residual({}, change.stress[b], forces);
    } else {
      change.stress[b].clear();
      if (change.strain[b].empty())
        std::ranges::fill(forces, 0.0);
      else
        body.initial_strain_force(factored.elastic(), change.strain[b], forces);
    }
    add_difference_of_loads(with_more.conditions(b, at), with_less.conditions(b, at), body, forces);
  }
  for (std::size_t p = 0; p < interference_[k].size(); ++p)
    if (interference_[k][p] != 0) change.gap += interference_[k][p] * gap_of(solver_.assembly().pairs()[p]);
}

const std::vector<creep::EquilibriumChange>& LinearDerivatives::respond(const creep::Evaluation& at,
                                                                        std::span<const double> whole) {
  std::vector<std::size_t> all(values().size());
  std::iota(all.begin(), all.end(), 0);
  respond(all, at, whole);
  return changes_;
}

void LinearDerivatives::respond(std::span<const std::size_t> to, const creep::Evaluation& at,
                                std::span<const double> whole) {
  std::vector<creep::ChangeTask> tasks;
  for (const std::size_t k : to) {
    equations(k, at.equilibrium, &at, block(whole, k + 1), equations_[k]);
    tasks.push_back(task(k));
  }
  solver_.changes(at.equilibrium, tasks);
}

bool LinearDerivatives::laws_differ(std::size_t k, std::size_t body, const creep::Evaluation& at) const {
  // Constants that points do not see, and axes of the material, show in the key alone.
  const std::string &key = values()[k].key, &material = solver_.assembly().bodies()[body].material().name;
  if (key.starts_with("bodies.") || key.starts_with(fmt::format("materials.{}.", material))) return true;
  if (key.starts_with("materials.\"")) return true;  // a name in quotes
  const creep::LawParameters &with_more = more(k).law_parameters(body, at.equilibrium),
                             &with_less = less(k).law_parameters(body, at.equilibrium);
  return with_more.values != with_less.values || with_more.temperature != with_less.temperature;
}

const creep::Evaluation& LinearDerivatives::evaluate_with_changes(double t, std::span<const double> whole) {
  std::vector<std::size_t> rest(values().size());  // all of them, where nothing has to be solved
  std::iota(rest.begin(), rest.end(), 0);
  const creep::CarriedChanges carried = [&](const creep::Equilibrium& begun) {
    std::vector<creep::ChangeTask> tasks;
    std::erase_if(rest, [&](std::size_t k) {
      if (follows_displacements(k, begun)) return false;
      equations(k, begun, nullptr, block(whole, k + 1), equations_[k]);
      tasks.push_back(task(k));
      return true;
    });
    return tasks;
  };
  const creep::Evaluation& at = base().evaluate_step(t, block(whole, 0), &carried);
  if (!rest.empty()) respond(rest, at, whole);
  return at;
}

void LinearDerivatives::rate(double t, std::span<const double> whole, std::span<double> rate) {
  const creep::Evaluation& at = evaluate_with_changes(t, whole);
  base().rate(t, block(whole, 0), block(rate, 0));
  const std::vector<creep::EquilibriumChange>& changes = changes_;
  const auto lap = watch_.lap(Part::material);
  const creep::BodyLaws& laws = base().laws();
  std::vector<double> with_more, with_less;
  std::vector<material::StressTangent> found;
  laws.for_each_creeping([&](std::size_t b, const creep::MaterialPoints& points) {
    const creep::PointsState state = laws.state(b, at, at.y);
    if (points.has_closed_form() && !at.has_tangents) {
      found.resize(points.size());
      points.tangents(state, found);
    }
    const std::vector<material::StressTangent>& tangents = at.has_tangents ? at.tangents[b] : found;
    for (std::size_t k = 0; k < values().size(); ++k) {
      const std::span<double> into = laws.layout().part(b, block(rate, k + 1));
      if (points.has_closed_form())
        points.derivative_by_tangents(state, tangents, changes[k].stress[b], into);
      else
        points.derivative(state, {changes[k].stress[b], laws.layout().part(b, block(whole, k + 1))}, into);
      if (!laws_differ(k, b, at)) continue;
      with_more.resize(into.size());
      with_less.resize(into.size());
      more(k).rate(b, at, with_more);
      less(k).rate(b, at, with_less);
      add_difference(with_more, with_less, into);
    }
  });
}

void LinearDerivatives::start_increment(double t, std::span<const double> whole, double stress_time, double duration,
                                        std::span<double> change) {
  base().start_increment(t, block(whole, 0), stress_time, duration, block(change, 0));
  const creep::Evaluation& at = base().evaluate_step(stress_time, block(whole, 0));
  const std::vector<creep::EquilibriumChange>& changes = respond(at, whole);
  std::vector<double> with_more(base().size()), with_less(base().size());
  for (std::size_t k = 0; k < values().size(); ++k) {
    const auto increments = [&](NearbyModel& model, std::vector<double>& into) {
      std::ranges::fill(into, 0.0);
      model.place(at, changes[k], block(whole, k + 1));
      model.laws().for_each_creeping([&](std::size_t b, const creep::MaterialPoints& points) {
        points.add_increment(t, duration, model.points(b), base().layout().part(b, std::span(into)));
      });
    };
    increments(more(k), with_more);
    increments(less(k), with_less);
    add_difference(with_more, with_less, block(change, k + 1));
  }
}

void LinearDerivatives::jacobian_times(double t, std::span<const double> whole, std::span<const double> v,
                                       std::span<double> product) {
  for (std::size_t i = 0; i < n_blocks(); ++i)
    base().jacobian_times(t, block(whole, 0), block(v, i), block(product, i));
}

/// The interferences of preloads follow so that the forces have their derivatives.
void LinearDerivatives::pass_breakpoint(double t, std::span<const double> whole) {
  std::vector<std::size_t> due;
  const std::vector<contact::Pair>& pairs = solver_.assembly().pairs();
  for (std::size_t p = 0; p < pairs.size(); ++p)
    if (const auto& preload = pairs[p].preload; preload && preload->time > preloaded_until_ && preload->time <= t)
      due.push_back(p);
  preloaded_until_ = t;
  if (due.empty()) return;
  const auto n = static_cast<Index>(due.size()), n_values = static_cast<Index>(values().size());
  const creep::Evaluation& at = base().evaluate_output(t, block(whole, 0));
  std::vector<creep::EquationChange> equations_of;
  for (std::size_t k = 0; k < values().size(); ++k)
    equations(k, at.equilibrium, &at, block(whole, k + 1), equations_of.emplace_back());
  Eigen::MatrixXd gaps(solver_.interface().n_rows(), n);
  for (Index q = 0; q < n; ++q) {
    creep::EquationChange& change = equations_of.emplace_back();
    gaps.col(q) = gap_of(pairs[due[static_cast<std::size_t>(q)]]);
    change.gap = gaps.col(q);
    change.work.setZero(static_cast<Index>(solver_.assembly().rigid_body_modes().size()));
    for (const mechanics::Body& body : solver_.assembly().bodies())
      change.forces.emplace_back(static_cast<std::size_t>(body.constraints().n_free()), 0.0);
    change.stress.resize(change.forces.size());
    change.strain.resize(change.forces.size());
  }
  std::vector<creep::EquilibriumChange> changes(equations_of.size());
  std::vector<creep::ChangeTask> tasks;
  for (std::size_t i = 0; i < changes.size(); ++i) tasks.push_back({&equations_of[i], &changes[i]});
  solver_.changes(at.equilibrium, tasks);
  Eigen::MatrixXd forces(n, n_values), missing(n, n_values), stiffness(n, n);
  for (Index k = 0; k < n_values; ++k) {
    const auto number = static_cast<std::size_t>(k);
    forces.col(k) = -gaps.transpose() * changes[number].multiplier;
    for (Index q = 0; q < n; ++q) {
      const std::size_t p = due[static_cast<std::size_t>(q)];
      missing(q, k) = run::central_difference(more(number).model().pairs()[p].preload->force,
                                              less(number).model().pairs()[p].preload->force) -
                      forces(q, k);
    }
  }
  for (Index q = 0; q < n; ++q)
    stiffness.col(q) = -gaps.transpose() * changes[static_cast<std::size_t>(n_values + q)].multiplier;
  const Eigen::MatrixXd found = linalg::least_squares(stiffness, missing);
  for (Index k = 0; k < n_values; ++k)
    for (Index q = 0; q < n; ++q)
      interference_[static_cast<std::size_t>(k)][due[static_cast<std::size_t>(q)]] += found(q, k);
}

bool LinearDerivatives::opens_or_closes(const creep::Equilibrium& at, const creep::EquilibriumChange& change) const {
  const contact::ContactProblem& problem = solver_.interface().problem();
  const std::vector<int>& immovable = solver_.interface().flexibility().immovable();
  if (problem.n_rows() == 0) return false;
  const double pressure = rounding * at.contact.multiplier.cwiseAbs().maxCoeff(),
               width = rounding * at.gaps.cwiseAbs().maxCoeff();
  return std::ranges::any_of(problem.nodes, [&](const contact::ContactNode& node) {
    const int row = node.first_row;
    if (node.set == contact::AdmissibleSet::space || std::ranges::binary_search(immovable, row)) return false;
    const bool is_closed = std::ranges::binary_search(at.contact.active, row);
    const double value = is_closed ? at.contact.multiplier[row] : at.gaps[row],
                 slope = is_closed ? change.multiplier[row] : change.gap[row];
    return relative_change * std::abs(slope) > std::max(value, 0.0) + (is_closed ? pressure : width);
  });
}

std::vector<Derivatives::OfProbes> LinearDerivatives::of_probes(double t, std::span<const double> whole) {
  // The results of the start come before the integration begins.
  const bool is_start = preloaded_until_ < 0;
  if (is_start) pass_breakpoint(t, whole);
  const creep::Evaluation& at = base().evaluate_output(t, block(whole, 0));
  for (std::size_t k = 0; k < values().size() && is_start; ++k)
    for (NearbyModel* const model : {&more(k), &less(k)})
      require_same_start(values()[k], model->starts_singular(at), base().singular_rate() != nullptr);
  const std::vector<creep::EquilibriumChange>& changes = respond(at, whole);
  std::vector<OfProbes> result(values().size());
  for (std::size_t k = 0; k < values().size(); ++k) {
    const auto values_of = [&](NearbyModel& model) {
      results::Snapshot snapshot(model.laws(), solver_.interface(), t,
                                 model.place_results(at, changes[k], block(whole, k + 1)));
      return results::probe_values(model.probes(), snapshot);
    };
    const std::vector<double> with_more = values_of(more(k)), with_less = values_of(less(k));
    for (std::size_t p = 0; p < with_more.size(); ++p)
      result[k].derivatives.push_back(run::central_difference(with_more[p], with_less[p]));
    result[k].is_one_sided = opens_or_closes(at.equilibrium, changes[k]);
  }
  return result;
}

void LinearDerivatives::save(creep::Memory& memory) const {
  memory.save("sensitivity.interference", interference_);
  memory.save("sensitivity.preloaded_until", preloaded_until_);
}

void LinearDerivatives::restore(const creep::Memory& memory) {
  memory.restore("sensitivity.interference", interference_);
  memory.restore("sensitivity.preloaded_until", preloaded_until_);
}

}  // namespace creepcontact::run
