#include "nearby_model.hpp"

#include <algorithm>

#include "creepcontact/numerics/long_vectors.hpp"

namespace creepcontact::run {
namespace {

/// into = from + factor change
void add(std::span<const double> from, double factor, std::span<const double> change, std::vector<double>& into) {
  into.resize(from.size());
  numerics::for_each_piece(from.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) into[i] = from[i] + factor * change[i];
  });
}

}  // namespace

NearbyModel::NearbyModel(const config::Config& config, double sign, Kept& kept, const std::vector<double>& min_strain)
    : change_(sign * relative_change),
      model_(model::build_model(config, &kept.meshes)),
      probes_(results::make_probes(config, model_)),
      laws_(model_.assembly, min_strain),
      rows_(model_.bodies(), model_.pairs(), model_.assembly.rigid_body_modes()) {
  at_.laws.resize(model_.bodies().size());
  at_.equilibrium.bodies.resize(model_.bodies().size());
}

const std::vector<mechanics::BodyConditions>& NearbyModel::conditions(const creep::Equilibrium& at) {
  model_.assembly.update(at.time, at_.equilibrium.conditions);
  return at_.equilibrium.conditions;
}

const mechanics::BodyConditions& NearbyModel::conditions(std::size_t body, const creep::Equilibrium& at) {
  return conditions(at)[body];
}

const creep::LawParameters& NearbyModel::law_parameters(std::size_t body, const creep::Equilibrium& at) {
  laws_.points()[body].update(conditions(body, at), at_.laws[body]);
  return at_.laws[body];
}

contact::InterfaceLoad NearbyModel::load(const creep::Equilibrium& at) {
  const std::vector<mechanics::BodyConditions>& here = conditions(at);
  contact::InterfaceLoad load = rows_.initial_load(here.front().time, here);
  for (std::size_t b = 0; b < here.size(); ++b) rows_.add_resultant(b, here[b], load);
  return load;
}

bool NearbyModel::stresses_differ(std::size_t body, const creep::Equilibrium& at) {
  const mechanics::BodyConditions &own = conditions(body, at), &of_run = at.conditions[body];
  const auto inner = [](const mechanics::BodyConditions& of) { return of.elastic().inner_force; };
  const auto same_moduli = [](const material::Moduli& a, const material::Moduli& b) {
    return a.lambda == b.lambda && a.mu == b.mu;
  };
  return !std::ranges::equal(own.moduli, of_run.moduli, same_moduli) || own.matrices != of_run.matrices ||
         own.thermal_strain != of_run.thermal_strain || own.thermal_tensors != of_run.thermal_tensors ||
         own.prescribed != of_run.prescribed || !std::ranges::equal(inner(own), inner(of_run));
}

/// That of the run, with the prescribed displacements of this model.
std::vector<double> NearbyModel::displacement(std::size_t body, const creep::Evaluation& at) {
  std::vector<double> u = at.equilibrium.bodies[body].displacement;
  const std::vector<double>&own = conditions(body, at.equilibrium).prescribed,
        &of_run = at.equilibrium.conditions[body].prescribed;
  for (std::size_t i = 0; i < own.size(); ++i) u[i] += own[i] - of_run[i];
  return u;
}

void NearbyModel::stress(std::size_t body, const creep::Evaluation& at, const mechanics::CreepStrainView& strain_change,
                         std::vector<double>& into) {
  const mechanics::Discretization& discretization = model_.bodies()[body].discretization();
  std::vector<double> state;
  mechanics::CreepStrainView strain;
  if (!strain_change.empty()) {
    add(laws_.layout().part(body, std::span<const double>(at.y)), change_, strain_change.data, state);
    strain = {state, strain_change.stride};
  }
  into.resize(6 * discretization.n_points());
  discretization.stress(displacement(body, at), conditions(body, at.equilibrium).elastic(), strain, into);
}

void NearbyModel::rate(std::size_t body, const creep::Evaluation& at, std::span<double> rate) {
  laws_.points()[body].rate({law_parameters(body, at.equilibrium),
                             {},
                             at.equilibrium.bodies[body].stress,
                             laws_.layout().part(body, std::span<const double>(at.y))},
                            rate, {});
}

bool NearbyModel::starts_singular(const creep::Evaluation& at) {
  bool is_singular = false;
  laws_.for_each_creeping([&](std::size_t b, const creep::MaterialPoints& points) {
    const creep::PointsState state{law_parameters(b, at.equilibrium),
                                   {},
                                   at.equilibrium.bodies[b].stress,
                                   laws_.layout().part(b, std::span<const double>(at.y))};
    is_singular = is_singular || points.start_exponent(at.time, state) < 1;
  });
  return is_singular;
}

void NearbyModel::place(const creep::Evaluation& at, const creep::EquilibriumChange& change,
                        std::span<const double> state_change) {
  add(at.y, change_, state_change, at_.y);
  for (std::size_t b = 0; b < change.stress.size(); ++b) {
    laws_.points()[b].update(conditions(b, at.equilibrium), at_.laws[b]);
    add(at.equilibrium.bodies[b].stress, change_, change.stress[b], at_.equilibrium.bodies[b].stress);
  }
}

creep::PointsState NearbyModel::points(std::size_t body) const {
  return {at_.laws[body],
          {},
          at_.equilibrium.bodies[body].stress,
          laws_.layout().part(body, std::span<const double>(at_.y))};
}

const creep::Evaluation& NearbyModel::place_results(const creep::Evaluation& at, const creep::EquilibriumChange& change,
                                                    std::span<const double> state_change) {
  place(at, change, state_change);
  at_.time = at.time;
  creep::Equilibrium& own = at_.equilibrium;
  const creep::Equilibrium& of_run = at.equilibrium;
  own.time = of_run.time;
  for (std::size_t b = 0; b < own.bodies.size(); ++b)
    add(displacement(b, at), change_, change.displacement[b], own.bodies[b].displacement);
  own.contact = of_run.contact;
  own.gaps = of_run.gaps;
  own.interference = of_run.interference;
  if (own.gaps.size() > 0) {
    own.contact.multiplier += change_ * change.multiplier;
    own.contact.rigid += change_ * change.rigid;
    own.gaps += change_ * change.gap;
  }
  at_.valid = true;
  return at_;
}

}  // namespace creepcontact::run
