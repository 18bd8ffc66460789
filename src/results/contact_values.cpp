#include "creepcontact/results/contact_values.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/closed_nodes.hpp"

namespace creepcontact::results {
namespace {

constexpr double at_the_limit = 1 - 1e-6;  // of mu times the pressure

double open_gap(const contact::Pair& pair, std::size_t node, const creep::Equilibrium& at) {
  const double gap = at.gaps[pair.first_row + pair.coupling.row(node)] / pair.coupling.area[node];
  if (!pair.gasket) return gap;
  if (contact::is_closed(pair, node, at.contact)) return 0;
  const double largest = at.largest_closure[pair.first_node + static_cast<Index>(node)];
  return gap + pair.gasket->kind().law.curve(largest, pair.gasket->temperatures(at.time)[node]).begin();
}

}  // namespace

Eigen::VectorXd open_gaps(const contact::Pair& pair, const creep::Equilibrium& at) {
  Eigen::VectorXd gaps(std::ssize(pair.coupling.nodes));
  for (Index i = 0; i < gaps.size(); ++i) {
    const auto node = static_cast<std::size_t>(i);
    gaps[i] = pair.coupling.area[node] * open_gap(pair, node, at);
  }
  return gaps;
}

ContactValues contact_values(const contact::Pair& pair, std::size_t node, const creep::Equilibrium& at) {
  using contact::ContactStatus;
  const contact::MortarCoupling& coupling = pair.coupling;
  const auto multiplier = at.contact.multiplier.segment(pair.first_row, coupling.n_rows());
  const bool tied = coupling.type == contact::ContactType::tied;
  ContactValues result;
  result.pressure = coupling.pressure(node, multiplier);
  const Vector3 shear = coupling.shear(node, multiplier);
  result.traction = -(result.pressure * coupling.nodes[node].normal + shear);
  result.shear = shear.norm();
  const auto number = pair.first_node + static_cast<Index>(node);
  if (!tied) result.gap = open_gap(pair, node, at);
  if (pair.gasket) {
    result.creep_closure = at.creep_closure.empty() ? 0 : at.creep_closure[static_cast<std::size_t>(number)];
    result.closure = result.creep_closure - at.gaps[pair.first_row + coupling.row(node)] / coupling.area[node] +
                     pair.gasket->growth(at.time)[node];
    result.largest_closure = at.largest_closure[number];
  }
  ContactStatus status = contact::is_closed(pair, node, at.contact) ? ContactStatus::slip : ContactStatus::open;
  if (tied) status = ContactStatus::stick;
  if (coupling.has_friction()) {
    const contact::NodeLinearization& law = at.contact.nodes[static_cast<std::size_t>(number)];
    status = law.status;
    // At an accepted state nothing has slid since the last one: there the traction decides.
    if (status != ContactStatus::open)
      status =
          result.shear >= at_the_limit * law.friction * result.pressure ? ContactStatus::slip : ContactStatus::stick;
    result.slip = at.friction.path[number];
  }
  result.status = static_cast<double>(status);
  return result;
}

double normal_force(const contact::Pair& pair, const Eigen::VectorXd& multipliers) {
  const Eigen::VectorXd own = multipliers.segment(pair.first_row, pair.coupling.n_rows());
  if (pair.preload) return -pair.interference_gap().dot(own);
  double force = 0;
  const bool is_tied = pair.coupling.type == contact::ContactType::tied && pair.coupling.rows_per_node() == 3;
  for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i)
    force += is_tied ? pair.coupling.nodes[i].normal.dot(pair.coupling.nodal_force(i, own))
                     : pair.coupling.area[i] * pair.coupling.pressure(i, own);
  return force;
}

double scale_modulus(const mechanics::Body& body) {
  const material::Material& material = body.material();
  const double modulus = material.young_modulus({.T = material.reference_temperature});
  return std::isfinite(modulus) ? modulus : 0;
}

double round_off_force(const creep::Assembly& assembly, const contact::Pair& pair) {
  const std::vector<mechanics::Body>& bodies = assembly.bodies();
  return round_off_strain * std::min(scale_modulus(bodies[pair.slave_body]), scale_modulus(bodies[pair.master_body])) *
         std::reduce(pair.coupling.area.begin(), pair.coupling.area.end());
}

}  // namespace creepcontact::results
