#include "gap_report.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace creepcontact::run {
namespace {

constexpr double of_the_body = 1e-3;
constexpr double of_the_distance = 0.05;  // error of a parabola instead of a circle, far from the contact
constexpr double nothing = 1e-9;          // of the surface's size: round-off of distances

double size_of(const mechanics::Body& body) {
  Eigen::AlignedBox3d box;
  for (const Vector3& x : body.mesh().nodes) box.extend(x);
  return box.diagonal().norm();
}

/// Least and largest distance in the mesh, round-off taken as zero.
std::pair<double, double> range(const contact::MortarCoupling& coupling) {
  Eigen::AlignedBox3d box;
  for (const Vector3& x : coupling.gap_points) box.extend(x);
  const auto [least, largest] = std::ranges::minmax(coupling.gap_distances);
  const double rounding = nothing * box.diagonal().norm();
  const auto rounded = [&](double x) { return std::abs(x) > rounding ? x : 0.0; };
  return {rounded(least), rounded(largest)};
}

std::string gasket_text(const contact::Pair& pair) {
  if (!pair.gasket) return "";
  const contact::GasketKind& kind = pair.gasket->kind();
  return fmt::format(", gasket '{}', {:.6g} thick", kind.name, kind.law.thickness());
}

std::string bare_gap_text(const config::Contact& contact, const contact::Pair& pair) {
  const auto [least, largest] = range(pair.coupling);
  const std::string mesh =
      least == largest ? fmt::format("{:.4g}", least) : fmt::format("{:.4g} to {:.4g}", least, largest);
  if (contact.preload) {
    const std::string kind = contact.type == config::ContactType::tied ? "tied, tension " : "preload ";
    return fmt::format("{}{:.6g} from t = {:.6g} on, distance in the mesh {}", kind, contact.preload->force,
                       contact.preload->time, mesh);
  }
  if (contact.type == config::ContactType::tied) {
    const std::size_t n = pair.coupling.ties.size();
    const std::string how = n == 0 ? "" : n == pair.coupling.nodes.size() ? ", node to node" : ", partly node to node";
    return "tied, distance in the mesh " + mesh + how;
  }
  if (contact.geometric_gap) return "gap from the mesh, " + mesh;
  const bool overlaps = contact.gap.is_constant() && contact.gap({}) < 0;
  return fmt::format("gap {}{}, distance in the mesh {}", contact.gap.text(), overlaps ? " (interference)" : "", mesh);
}

}  // namespace

std::string gap_text(const config::Contact& contact, const contact::Pair& pair) {
  return bare_gap_text(contact, pair) + gasket_text(pair);
}

std::optional<std::string> gap_warning(const model::Model& model, const contact::Pair& pair) {
  if (pair.geometric_gap) return std::nullopt;
  const mechanics::Body &slave = model.bodies()[pair.slave_body], &master = model.bodies()[pair.master_body];
  const mechanics::Body& smaller = size_of(slave) < size_of(master) ? slave : master;
  const double allowed = of_the_body * size_of(smaller);
  const bool tied = pair.coupling.type == contact::ContactType::tied;
  const double thickness = pair.gasket ? pair.gasket->kind().law.thickness() : 0;
  double worst = 0, worst_given = 0, worst_distance = 0;
  Vector3 position = Vector3::Zero();
  for (std::size_t i = 0; i < pair.coupling.gap_points.size(); ++i) {
    const Vector3& x = pair.coupling.gap_points[i];
    const double distance = pair.coupling.gap_distances[i];
    if (std::abs(distance) <= allowed) continue;
    double given = tied ? 0.0 : pair.gap({.x = x.x(), .y = x.y(), .z = x.z(), .t = 0});
    if (pair.gasket && std::abs(distance - given) > thickness / 2) given += thickness;  // drawn with room for it
    const double excess = std::abs(distance - given) - of_the_distance * std::abs(distance) - allowed;
    if (!(excess > worst)) continue;
    worst = excess, worst_given = given, worst_distance = distance, position = x;
  }
  if (!(worst > 0)) return std::nullopt;
  const std::string in_mesh = worst_distance < 0 ? fmt::format("overlap by {:.4g}", -worst_distance)
                                                 : fmt::format("are {:.4g} apart", worst_distance);
  const std::string where = fmt::format("at ({:.6g}, {:.6g}, {:.6g})", position.x(), position.y(), position.z());
  if (tied)
    return fmt::format(
        "contact '{}': {} the surfaces {} in the mesh, more than a thousandth of body '{}' ({:.4g}), but they are tied "
        "as if they touched; if this is not intended, correct the geometry",
        pair.name, where, in_mesh, smaller.name(), size_of(smaller));
  if (pair.preload)
    return fmt::format(
        "contact '{}': {} the surfaces {} in the mesh, more than a thousandth of body '{}' ({:.4g}), but the preload "
        "begins as if they touched; if this is not intended, correct the geometry",
        pair.name, where, in_mesh, smaller.name(), size_of(smaller));
  return fmt::format(
      "contact '{}': {} the surfaces {} in the mesh, but the gap given there is {:.4g}; they differ by more than a "
      "thousandth of body '{}' ({:.4g}). The given gap is used; gap = \"geometric\" uses that of the mesh",
      pair.name, where, in_mesh, worst_given, smaller.name(), size_of(smaller));
}

}  // namespace creepcontact::run
