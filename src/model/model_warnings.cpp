#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "contact_edges.hpp"
#include "creepcontact/model/model.hpp"

namespace creepcontact::model {
namespace {

using Texts = std::vector<std::string>;

/// Output times and breakpoints, evenly chosen where there are many.
std::vector<double> sample_times(const config::Config& config, const Model& model) {
  constexpr std::size_t most = 50;
  std::vector<double> times = config.time.output;
  times.insert(times.end(), model.breakpoints.begin(), model.breakpoints.end());
  times.push_back(0);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<double> chosen;
  const std::size_t stride = (times.size() + most - 1) / most;
  for (std::size_t i = 0; i < times.size(); i += stride) chosen.push_back(times[i]);
  if (chosen.back() != times.back()) chosen.push_back(times.back());
  return chosen;
}

/// The strain along z that the temperature would give a body by itself, if its sections stay plane.
double free_axial_strain(const mechanics::Body& body, double t) {
  const mechanics::BodyConditions at = body.at(t);
  const mechanics::ElasticState elastic = at.elastic();
  if (!elastic.has_thermal_strain()) return 0;
  const std::span<const double> weights = body.discretization().weights();
  double sum = 0;
  for (std::size_t p = 0; p < weights.size(); ++p) sum += weights[p] * elastic.thermal(p)[2];
  return sum / std::reduce(weights.begin(), weights.end());
}

/// For each body the first of those that it is tied to, directly or through others.
std::vector<std::size_t> tied_groups(const Model& model) {
  std::vector<std::size_t> group(model.bodies().size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (const contact::Pair& pair : model.pairs()) {
    const bool is_equation = pair.ties_nodes() && pair.coupling.ties.empty();  // such as that of the axial strains
    if (is_equation || pair.coupling.type != contact::ContactType::tied || !pair.acts_always()) continue;
    const auto [low, high] = std::minmax({group[pair.slave_body], group[pair.master_body]});
    std::ranges::replace(group, high, low);
  }
  return group;
}

void warn_of_unlike_expansion(const config::Config& config, const Model& model, Texts& warnings) {
  const config::GeneralizedPlaneStrain& axial = config.generalized_plane_strain;
  if (config.analysis != settings::Analysis::generalized_plane_strain || axial.strain || axial.per_body) return;
  constexpr double unlike = 0.01, nothing = 1e-7;  // of the larger one; a strain
  struct Worst {
    double difference = 0, time = 0, low = 0, high = 0;
    std::size_t low_body = 0, high_body = 0;
  } worst;
  const std::vector<std::size_t> groups = tied_groups(model);
  for (const double t : sample_times(config, model)) {
    std::vector<double> strains;
    for (const mechanics::Body& body : model.bodies()) strains.push_back(free_axial_strain(body, t));
    for (std::size_t a = 0; a < strains.size(); ++a)
      for (std::size_t b = 0; b < strains.size(); ++b) {
        const double difference = strains[b] - strains[a], size = std::max(std::abs(strains[a]), std::abs(strains[b]));
        if (groups[a] != groups[b] && difference > std::max({nothing, unlike * size, worst.difference}))
          worst = {difference, t, strains[a], strains[b], a, b};
      }
  }
  if (worst.difference == 0) return;
  warnings.push_back(fmt::format(
      "generalised plane strain: all bodies have one axial strain, but their free expansion along z differs, at t = "
      "{:.6g} {:.4g} in body '{}' and {:.4g} in body '{}'. They pull each other along z, and this changes contact "
      "forces "
      "in the plane. If they slide on each other along z, set generalized_plane_strain.per_body = true; if they are "
      "fixed to each other, ignore this, or tie them",
      worst.time, worst.high, model.bodies()[worst.high_body].name(), worst.low,
      model.bodies()[worst.low_body].name()));
}

void warn_of_friction(const config::Config& config, const Model& model, Texts& warnings) {
  constexpr double usual = 1.5;
  for (const contact::Pair& pair : model.pairs()) {
    if (!pair.coupling.has_friction()) continue;
    double largest = 0;
    for (const double t : sample_times(config, model)) largest = std::max(largest, pair.friction.at(t).maxCoeff());
    if (largest > usual)
      warnings.push_back(
          fmt::format("contact '{}': the coefficient of friction is {:.4g}; above {:g} no pair of usual materials has "
                      "one. It is the ratio of shear and pressure, not a percentage; to join surfaces, use type = "
                      "\"tied\". If it is meant, ignore this",
                      pair.name, largest, usual));
  }
}

struct Modulus {
  std::string material, body;
  double value;
};

std::vector<Modulus> moduli(const Model& model) {
  std::vector<Modulus> result;
  for (const mechanics::Body& body : model.bodies()) {
    const material::Material& material = body.material();
    if (std::ranges::any_of(result, [&](const Modulus& m) { return m.material == material.name; })) continue;
    result.push_back({material.name, body.name(), material.young_modulus({.T = material.reference_temperature})});
  }
  return result;
}

/// Metals and ceramics have a modulus of 10 to 450 GPa: where one lies in this range as a number of GPa and another as
/// a number of MPa or Pa, units are mixed. Rubber, polymers or stiff tools combined with metals do not match this.
void warn_of_units(const Model& model, Texts& warnings) {
  constexpr double least = 10, most = 450, factor = 1e3, apart = 10;  // GPa; between units; of the factor
  struct Unit {
    const char* name;
    double size;  // of the numbers in it, relative to GPa
  };
  constexpr std::array units{Unit{"GPa", 1}, Unit{"MPa", factor}, Unit{"Pa", factor * factor * factor}};
  const std::vector<Modulus> all = moduli(model);
  for (const Modulus& small : all) {
    const auto is_in = [&](const Unit& unit, double value) {
      return value >= least * unit.size && value <= most * unit.size;
    };
    for (std::size_t i = 0; i < units.size(); ++i)
      for (std::size_t j = i + 1; j < units.size(); ++j) {
        const double between = units[j].size / units[i].size;
        const auto other = std::ranges::find_if(all, [&](const Modulus& large) {
          const double ratio = large.value / small.value;
          return is_in(units[i], small.value) && is_in(units[j], large.value) && ratio > between / apart &&
                 ratio < between * apart;
        });
        if (other == all.end()) continue;
        warnings.push_back(fmt::format(
            "Young's modulus of body '{}' (material '{}') is {:.6g} and that of body '{}' (material '{}') {:.6g}, "
            "which "
            "differ as {} and {} do. All of a model must be in the same units; if the moduli are meant, ignore this",
            small.body, small.material, small.value, other->body, other->material, other->value, units[i].name,
            units[j].name));
        return;
      }
  }
}

/// Angle about an axis that the nodes of a body cover: the circle less the largest gap between them.
double covered_angle(const mesh::Mesh& mesh, const config::Cyclic& cyclic) {
  const Vector3 origin(Eigen::Map<const Vector3>(cyclic.origin.data())),
      axis(Eigen::Map<const Vector3>(cyclic.axis.data()).normalized());
  const Vector3 first = axis.unitOrthogonal(), second = axis.cross(first);
  constexpr double on_axis = 1e-6;  // of the largest radius
  double radius = 0;
  const std::size_t n = mesh.n_cell_nodes();
  for (std::size_t i = 0; i < n; ++i) radius = std::max(radius, axis.cross(mesh.nodes[i] - origin).norm());
  std::vector<double> angles;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3 arm = mesh.nodes[i] - origin;
    if (axis.cross(arm).norm() > on_axis * radius) angles.push_back(std::atan2(arm.dot(second), arm.dot(first)));
  }
  if (angles.empty()) return 0;
  std::ranges::sort(angles);
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  return 2 * std::numbers::pi - gap;
}

void warn_of_missing_symmetry(const config::Config& config, const Model& model, Texts& warnings) {
  if (config.cyclic.empty()) return;
  constexpr double nearly = 1e-3;  // of the sector
  const config::Cyclic& cyclic = config.cyclic.front();
  const double sector = cyclic.angle * std::numbers::pi / 180;
  for (const mechanics::Body& body : model.bodies()) {
    if (!body.constraints().links().turned.empty()) continue;
    const bool is_joined = std::ranges::any_of(config.cyclic, [&](const config::Cyclic& of) {
      return std::ranges::any_of(of.between, [&](const config::Reference& surface) {
        const auto found = body.mesh().groups.find(surface.name);
        return found != body.mesh().groups.end() && !found->second.cells.empty();
      });
    });
    const double covered = covered_angle(body.mesh(), cyclic);
    if (is_joined || covered < (1 - nearly) * sector) continue;
    warnings.push_back(
        fmt::format("body '{}' covers {:.4g} degrees about the axis of the cyclic symmetry, a whole sector of {:.4g} "
                    "or more, but no "
                    "[[cyclic]] joins its cut surfaces: they are free, while other bodies go on into the next sector. "
                    "Add [[cyclic]] "
                    "for them; if they are free in the part, ignore this",
                    body.name(), covered * 180 / std::numbers::pi, cyclic.angle));
  }
}

void warn_of_narrow_surfaces(const Model& model, Texts& warnings) {
  constexpr int few = 2, wanted = 4;  // rows; elements
  for (const contact::Pair& pair : model.pairs()) {
    if (pair.ties_nodes() || pair.coupling.type == contact::ContactType::tied) continue;
    const mechanics::Body &slave = model.bodies()[pair.slave_body], &master = model.bodies()[pair.master_body];
    for (const bool of_slave : {true, false}) {
      const std::string &own = of_slave ? pair.slave_surface : pair.master_surface,
                        &other = of_slave ? pair.master_surface : pair.slave_surface;
      const std::optional<int> rows =
          rows_between_edges(of_slave ? slave : master, own, of_slave ? master : slave, other);
      if (!rows || *rows > few) continue;
      warnings.push_back(fmt::format(
          "contact '{}': surface '{}' is {} wide, and '{}' goes on beyond its edges, where the pressure "
          "concentrates: so few elements do not show its peak. At least {} elements across are needed, eight are "
          "better, finer towards the edges",
          pair.name, own, *rows == 1 ? "only one element" : "three elements at most", other, wanted));
    }
  }
}

}  // namespace

std::vector<std::string> model_warnings(const config::Config& config, const Model& model) {
  Texts warnings;
  warn_of_units(model, warnings);
  warn_of_friction(config, model, warnings);
  warn_of_unlike_expansion(config, model, warnings);
  warn_of_missing_symmetry(config, model, warnings);
  warn_of_narrow_surfaces(model, warnings);
  return warnings;
}

}  // namespace creepcontact::model
