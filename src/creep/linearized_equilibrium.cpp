/// The equilibrium linearised at fixed contact: products with the Jacobian.

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/index.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "fixed_contact_solve.hpp"
#include "plastic_tangent.hpp"
#include "vector_views.hpp"

namespace creepcontact::creep {
namespace {

constexpr double jacobian_error = 1e-3;  // where the solver is not direct, in the energy norm

/// The contact of fixed_contact_solve(), near one state.
struct ClosedRows {
  contact::CondensedInterface& interface;
  const std::function<contact::ContactState(const Eigen::VectorXd& gap)> change;
  const Eigen::VectorXd opening;  ///< of gaskets, at constant pressure; empty: none
  FreeDisplacements reached;      ///< by an iteration, to which what is solved for adds; empty: none

  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const {
    interface.flexibility().add_trace(body, y, gap);
  }
  contact::ContactState close(Eigen::VectorXd gap) const {
    if (opening.size() > 0) gap += opening;
    for (std::size_t b = 0; b < reached.size(); ++b) interface.rows().add_gaps(b, reached[b], gap);
    // Initial strains are in equilibrium with themselves: no resultants.
    return change(gap);
  }
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const {
    interface.flexibility().add_multipliers(body, multiplier, y);
  }
};

}  // namespace

Eigen::VectorXd EquilibriumSolver::linearized(const Equilibrium& at, CreepStrains creep_change,
                                              std::vector<std::vector<double>>& stress, Eigen::VectorXd* gap) {
  Eigen::VectorXd multiplier = linearized_elastic(at, creep_change, stress, gap);
  if (!at.plastic.flows) return multiplier;
  const PlasticTangent tangent(assembly_, at);
  if (tangent.is_elastic()) return multiplier;
  tangent.add_flow(stress, [&](CreepStrains strain, std::vector<std::vector<double>>& change) {
    linearized_elastic(at, strain, change);
  });
  return multiplier;
}

Eigen::VectorXd EquilibriumSolver::linearized_elastic(const Equilibrium& at, CreepStrains creep_change,
                                                      std::vector<std::vector<double>>& stress, Eigen::VectorXd* gap) {
  const std::size_t n_bodies = work_.size();
  std::vector<FactoredSide> sides;
  {
    const auto lap = watch_.lap(Part::material);
    for (std::size_t b = 0; b < n_bodies; ++b) {
      mechanics::FactoredBody& factored = interface_.factored(b);
      factored.body().initial_strain_force(factored.elastic(), creep_change[b], work_[b].free);
      factored.body().clear_fixing_dofs(work_[b].free);
      sides.push_back({&factored.solver(), work_[b].free});
    }
  }
  ClosedRows rows{interface_,
                  [&](const Eigen::VectorXd& of_gap) { return contact_change(at.contact, of_gap); },
                  interface_.rows().creep_gaps(creep_change.closures()),
                  {}};
  Eigen::VectorXd multiplier;
  stress.resize(n_bodies);
  // A fixed number of them: all of it stays linear in the creep strains.
  const int corrections = solver_error_ > 0 ? static_cast<int>(std::log(jacobian_error) / std::log(solver_error_)) : 0;
  for (int correction = 0;; ++correction) {
    contact::ContactState change = fixed_contact_solve(sides, interface_.n_rows(), rows, watch_);
    ++counters_.elastic_solves;
    const auto lap = watch_.lap(Part::material);
    for (std::size_t b = 0; b < n_bodies; ++b) {
      const mechanics::FactoredBody& factored = interface_.factored(b);
      const mechanics::Body& body = factored.body();
      std::vector<double>& free = work_[b].free;
      if (correction > 0) vector(free) += vector(rows.reached[b]);
      body.constraints().expand(free, work_[b].no_displacement, work_[b].displacement);
      interface_.rows().add_rigid_motion(b, change.rigid, work_[b].displacement);
      stress[b].resize(6 * body.discretization().n_points());
      body.discretization().stress(work_[b].displacement, factored.elastic(), creep_change[b], stress[b]);
    }
    if (gap != nullptr) {
      *gap = interface_.problem().rigid * change.rigid;
      for (std::size_t b = 0; b < n_bodies; ++b) interface_.rows().add_gaps(b, work_[b].free, *gap);
    }
    multiplier = std::move(change.multiplier);
    if (correction == corrections) break;
    rows.reached.resize(n_bodies);
    for (std::size_t b = 0; b < n_bodies; ++b) {
      rows.reached[b] = work_[b].free;
      interface_.factored(b).residual({}, stress[b], rows.reached[b], work_[b].free);
      assembly_.bodies()[b].clear_fixing_dofs(work_[b].free);
    }
  }
  if (at.stiffness_scale != 1)
    for (std::vector<double>& of_body : stress)
      for (double& component : of_body) component *= at.stiffness_scale;
  return at.stiffness_scale * multiplier;
}

bool EquilibriumSolver::is_piecewise_linear() const {
  const bool yields = std::ranges::any_of(
      assembly_.bodies(), [](const mechanics::Body& body) { return body.material().plasticity != nullptr; });
  return !iterates() && !yields && !interface_.problem().has_friction() && !interface_.problem().has_gaskets();
}

std::vector<linalg::SeveralSubstitutions> EquilibriumSolver::passes_of(std::span<const ChangeTask> tasks) {
  std::vector<linalg::SeveralSubstitutions> passes;
  for (std::size_t b = 0; b < work_.size(); ++b) {
    passes.push_back({&interface_.factored(b).solver(), {}});
    for (const ChangeTask& task : tasks) {
      std::vector<double>& forces = task.equations->forces[b];
      passes.back().vectors.push_back({forces, forces});
    }
  }
  return passes;
}

void EquilibriumSolver::clear_fixing_dofs(std::span<const ChangeTask> tasks) const {
  for (const ChangeTask& task : tasks)
    for (std::size_t b = 0; b < work_.size(); ++b) assembly_.bodies()[b].clear_fixing_dofs(task.equations->forces[b]);
}

void EquilibriumSolver::close_changes(const std::vector<int>& active, std::span<const ChangeTask> tasks) {
  const auto lap = watch_.lap(Part::contact);
  for (const auto& [equations, change] : tasks) {
    contact::ContactLoad load{equations->gap, assembly_.rigid_body_modes().held().transpose() * equations->work};
    for (std::size_t b = 0; b < work_.size(); ++b)
      interface_.flexibility().add_trace(b, equations->forces[b], load.gap);
    contact::ContactState contact;
    if (interface_.n_rows() > 0) contact = active_set_.solve(active, load).state;
    for (std::size_t b = 0; b < work_.size(); ++b)
      interface_.flexibility().add_multipliers(b, contact.multiplier, equations->forces[b]);
    change->multiplier = std::move(contact.multiplier);
    change->rigid = std::move(contact.rigid);
  }
}

void EquilibriumSolver::finish_changes(std::span<const ChangeTask> tasks) {
  const auto lap = watch_.lap(Part::material);
  for (const auto& [equations, change] : tasks) {
    change->displacement.resize(work_.size());
    change->stress.resize(work_.size());
    change->gap = equations->gap;
    if (change->rigid.size() > 0) change->gap += interface_.problem().rigid * change->rigid;
    for (std::size_t b = 0; b < work_.size(); ++b) {
      const mechanics::FactoredBody& factored = interface_.factored(b);
      const mechanics::Body& body = factored.body();
      interface_.rows().add_gaps(b, equations->forces[b], change->gap);
      change->displacement[b].resize(work_[b].no_displacement.size());
      body.constraints().expand(equations->forces[b], work_[b].no_displacement, change->displacement[b]);
      interface_.rows().add_rigid_motion(b, change->rigid, change->displacement[b]);
      change->stress[b].resize(6 * body.discretization().n_points());
      body.discretization().stress(change->displacement[b], factored.elastic(), equations->strain[b],
                                   change->stress[b]);
      if (!equations->stress[b].empty()) vector(change->stress[b]) += vector(equations->stress[b]);
    }
  }
  counters_.elastic_solves += std::ssize(tasks);
}

void EquilibriumSolver::changes(const Equilibrium& at, std::span<const ChangeTask> tasks) {
  clear_fixing_dofs(tasks);
  const auto pass = [&](linalg::PassDirection direction) {
    const auto lap = watch_.lap(Part::solve);
    linalg::pass_several(direction, passes_of(tasks));
  };
  pass(linalg::PassDirection::forward);
  close_changes(at.contact.active, tasks);
  pass(linalg::PassDirection::backward);
  finish_changes(tasks);
}

}  // namespace creepcontact::creep
