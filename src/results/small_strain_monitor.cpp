#include "creepcontact/results/small_strain_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace creepcontact::results {
namespace {

constexpr double min_reported_strain = 0.05;
constexpr double min_reported_rotation = 10 * std::numbers::pi / 180;
constexpr double clearly_grown = 1.001;  // a new largest value: fewer are not told apart
const std::string strain_begin = "the strain is not small: ", rotation_begin = "the rotation is not small: ";

struct PointStrain {
  double value = 0;
  std::size_t point = 0;
};

/// The largest principal strain in magnitude; strains below the limit need not be exact.
PointStrain largest_strain(const mechanics::Body& body, const mechanics::BodyConditions& conditions,
                           const std::vector<double>& stress, const mechanics::CreepStrainView& creep, double limit) {
  const mechanics::ElasticState elastic = conditions.elastic();
  PointStrain largest;
  const bool is_plain = elastic.matrices.empty() && !elastic.has_thermal_strain();
  for (std::size_t p = 0; p < body.discretization().n_points(); ++p) {
    // The compliance of isotropic elasticity is at most 1/(2 mu) for nu >= 0, elsewhere 1/(3 lambda + 2 mu).
    if (is_plain) {
      const mechanics::Moduli& h = elastic.at(p);
      const double stiffness = std::min(2 * h.mu, 3 * h.lambda + 2 * h.mu), least = std::max(limit, largest.value);
      const double creep_square = creep.empty() ? 0 : creep.at(p).squaredNorm();
      // (a + b)^2 <= 2 (a^2 + b^2)
      if (2 * (tensor::view(stress, p).squaredNorm() + creep_square * stiffness * stiffness) <
          least * least * stiffness * stiffness)
        continue;
    }
    Tensor6 strain = elastic.elastic_strain(p, tensor::view(stress, p)) + elastic.thermal(p);
    if (!creep.empty()) strain += creep.at(p);
    if (!(strain.norm() > std::max(limit, largest.value))) continue;  // a bound of the principal ones
    const double value = tensor::principal_values(tensor::to_matrix(strain)).cwiseAbs().maxCoeff();
    if (value > largest.value) largest = {value, p};
  }
  return largest;
}

}  // namespace

SmallStrainMonitor::SmallStrainMonitor(const creep::CreepSystem& system) : system_(system) {
  for (const mechanics::Body& body : system.assembly().bodies()) rotations_.emplace_back(body);
}

template <typename Place>
void SmallStrainMonitor::take(Largest& largest, double limit, double value, std::size_t body, double time,
                              const Place& place) {
  const Team& team = system_.team();
  const double of_all = team.max(value);
  if (!(of_all > std::max(limit, clearly_grown * largest.value))) return;
  largest = {of_all, static_cast<double>(body), time, {}};
  const int owner = team.rank_of_max(value);
  if (team.rank() == owner) Eigen::Map<Vector3>(largest.place.data()) = place();
  team.broadcast(largest.place, owner);
}

void SmallStrainMonitor::observe(double time, const creep::Evaluation& at) {
  const std::vector<mechanics::Body>& bodies = system_.assembly().bodies();
  std::vector<mechanics::CreepStrainView> creep;
  system_.layout().views(at.y, creep);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const creep::BodyState& state = at.equilibrium.bodies[b];
    const PointStrain strain =
        largest_strain(bodies[b], at.equilibrium.conditions[b], state.stress, creep[b], min_reported_strain);
    take(strain_, min_reported_strain, strain.value, b, time,
         [&] { return bodies[b].discretization().point_coordinates()[strain.point]; });
    const mechanics::ElementRotation rotation = rotations_[b].largest(state.displacement, min_reported_rotation);
    take(rotation_, min_reported_rotation, rotation.angle, b, time, [&] { return rotation.position; });
  }
}

std::string SmallStrainMonitor::where(const Largest& largest) const {
  const auto& [x, y, z] = largest.place;
  return fmt::format("in body '{}' at ({:.6g}, {:.6g}, {:.6g}), t = {:.6g}",
                     system_.assembly().bodies()[static_cast<std::size_t>(largest.body)].name(), x, y, z, largest.time);
}

std::vector<std::string> SmallStrainMonitor::warnings() const {
  std::vector<std::string> texts;
  if (strain_.value > 0)
    texts.push_back(fmt::format(
        "{}it reaches {:.3g} % {}. The program takes displacements and strains as small; the error of this in stress "
        "and strain is of the order of the strain itself, which is below {:g} % where nothing is said. Check loads, "
        "units and constants, or take results as estimates where strains are large",
        strain_begin, 100 * strain_.value, where(strain_), 100 * min_reported_strain));
  if (rotation_.value > 0)
    texts.push_back(fmt::format(
        "{}it reaches {:.4g} degrees {}. The program takes rotations as small; a rotation by the angle a, in radians, "
        "makes an error of a^2/2 in the strain, here {:.2g} %, and turns no stress and no load. Nothing is said below "
        "{:g} degrees",
        rotation_begin, rotation_.value * 180 / std::numbers::pi, where(rotation_),
        50 * rotation_.value * rotation_.value, min_reported_rotation * 180 / std::numbers::pi));
  return texts;
}

bool SmallStrainMonitor::is_warning(const std::string& text) {
  return text.starts_with(strain_begin) || text.starts_with(rotation_begin);
}

void SmallStrainMonitor::save(creep::Memory& memory) const {
  memory.save("small_strain", *this, saved_members);
}

void SmallStrainMonitor::restore(const creep::Memory& memory) {
  memory.restore("small_strain", *this, saved_members);
}

}  // namespace creepcontact::results
