#include "creepcontact/creep/tangent_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/ode/system.hpp"
#include "fixed_contact_solve.hpp"
#include "gasket_creep.hpp"

namespace creepcontact::creep {
namespace {

/// The contact of fixed_contact_solve(), near one state.
struct TangentContact {
  contact::TangentInterface& interface;
  const contact::ContactState& at;
  const Eigen::VectorXd& opening;  ///< of gaskets, at constant pressure

  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const {
    interface.add_trace(body, y, gap);
  }
  contact::ContactState close(const Eigen::VectorXd& gap) const {
    try {
      return interface.close(at, gap + opening);
    } catch (const SolverError& error) {
      throw RecoverableError(error.what());
    }
  }
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const {
    interface.add_multipliers(body, multiplier, y);
  }
};

}  // namespace

TangentSystem::TangentSystem(const EquilibriumSolver& solver, const std::vector<MaterialPoints>& points,
                             const GasketCreep& gaskets, const StateLayout& layout, Stopwatch& watch)
    : solver_(solver), gaskets_(gaskets), layout_(layout), watch_(watch), sides_(points.size()) {
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    const mechanics::Body& body = solver.assembly().bodies()[b];
    if (points[b].empty()) continue;
    Side& side = sides_[b];
    side.material.emplace(points[b]);
    side.stress.resize(6 * body.discretization().n_points());
    side.strain.resize(side.stress.size());
    side.displacement.resize(body.constraints().n_full());
    side.no_displacement.resize(side.displacement.size());
    side.free.resize(body.constraints().n_free());
  }
}

void TangentSystem::factorize(std::size_t b) {
  Side& side = sides_[b];
  const mechanics::FactoredBody& elastic = solver_.interface().factored(b);
  const auto lap = watch_.lap(Part::factorize);
  if (!side.factor) side.factor = elastic.solver().same_pattern();
  ++factorizations_;
  try {
    side.factor->factorize(elastic.stiffness(side.material->moduli()));
  } catch (const linalg::SingularMatrix& error) {
    throw RecoverableError(
        fmt::format("body '{}': the tangent stiffness is not positive definite (reciprocal condition {:.2g})",
                    elastic.body().name(), error.rcond));
  }
}

void TangentSystem::prepare(double gamma, std::span<const PointsState> at, std::vector<Eigen::MatrixXd> of_gaskets,
                            double stiffness_scale) {
  interface_.reset();
  gamma_ = gamma;
  of_gaskets_ = std::move(of_gaskets);
  stiffness_scale_ = stiffness_scale;
  std::vector<const linalg::StiffnessSolver*> factors(sides_.size());
  for (std::size_t b = 0; b < sides_.size(); ++b) {
    if (!sides_[b].material) continue;
    {
      const auto lap = watch_.lap(Part::material);
      sides_[b].material->prepare(gamma, at[b]);
    }
    factorize(b);
    factors[b] = sides_[b].factor.get();
  }
  const auto lap = watch_.lap(Part::factorize);
  interface_ = std::make_unique<contact::TangentInterface>(solver_.interface(), factors, 1 / stiffness_scale);
}

template <typename Work>
void TangentSystem::for_each_side(const Work& work) {
  for (std::size_t b = 0; b < sides_.size(); ++b)
    if (sides_[b].material) work(b, sides_[b], solver_.assembly().bodies()[b]);
}

void TangentSystem::solve(const contact::ContactState& contact, std::span<const double> r, std::span<double> z) {
  // Nothing but contact strains an elastic body, and its displacement is not asked for: it takes no part.
  std::vector<FactoredSide> sides(sides_.size());
  {
    const auto lap = watch_.lap(Part::material);
    for_each_side([&](std::size_t b, Side& side, const mechanics::Body& body) {
      side.material->initial_stress(layout_.part(b, r), side.stress);
      std::fill(side.displacement.begin(), side.displacement.end(), 0.0);
      body.discretization().add_initial_stress_force(side.material->moduli(), side.stress, side.displacement);
      body.constraints().restrict_to_free(side.displacement, side.free);
      // Initial strains are in equilibrium with themselves: only the forces of the fixing dofs are taken out.
      body.clear_fixing_dofs(side.free);
      sides[b] = {side.factor.get(), side.free};
    });
  }
  const GasketCreep::Eliminated gaskets = gaskets_.eliminated(of_gaskets_, gamma_, r, interface_->n_rows());
  contact::ContactState near = contact;
  if (near.compliance.size() > 0) near.compliance = near.compliance / stiffness_scale_ + gaskets.compliance;
  TangentContact rows{*interface_, near, gaskets.opening};
  const contact::ContactState change = fixed_contact_solve(sides, interface_->n_rows(), rows, watch_);
  const auto lap = watch_.lap(Part::material);
  for_each_side([&](std::size_t b, Side& side, const mechanics::Body& body) {
    body.constraints().expand(side.free, side.no_displacement, side.displacement);
    solver_.interface().rows().add_rigid_motion(b, change.rigid, side.displacement);
    body.discretization().tangent_strain(side.displacement, side.material->moduli(), side.stress, side.strain);
    side.material->solution(layout_.part(b, r), side.strain, layout_.part(b, z));
  });
  gaskets_.solution(of_gaskets_, gamma_, r, change.multiplier, z);
  ++solves_;
}

}  // namespace creepcontact::creep
