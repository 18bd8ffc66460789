#include "creepcontact/results/contact_values.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/closed_nodes.hpp"

namespace creepcontact::results {
namespace {

constexpr double at_the_limit = 1 - 1e-6;  // of mu times the pressure

}  // namespace

PairValues::PairValues(const contact::Pair& pair, const creep::Equilibrium& at,
                       std::span<const heat::NodeOfInterface> heat)
    : pair_(pair), at_(at), heat_(heat) {
  if (!pair.gasket) return;
  temperatures_ = pair.gasket->temperatures(at.time);
  growth_ = pair.gasket->growth(at.time);
}

double PairValues::open_gap(std::size_t node) const {
  if (contact::is_closed(pair_, node, at_.contact)) return 0;  // without the rounding of the solution
  const double gap = at_.gaps[pair_.first_row + pair_.coupling.row(node)] / pair_.coupling.area[node];
  if (!pair_.gasket) return gap;
  const double largest = at_.largest_closure[pair_.first_node + static_cast<Index>(node)];
  return gap + pair_.gasket->kind().law.curve(largest, temperatures_[node]).begin();
}

Eigen::VectorXd PairValues::open_gaps() const {
  Eigen::VectorXd gaps(std::ssize(pair_.coupling.nodes));
  for (Index i = 0; i < gaps.size(); ++i) {
    const auto node = static_cast<std::size_t>(i);
    gaps[i] = pair_.coupling.area[node] * open_gap(node);
  }
  return gaps;
}

ContactValues PairValues::operator[](std::size_t node) const {
  using contact::ContactStatus;
  const contact::MortarCoupling& coupling = pair_.coupling;
  const auto multiplier = at_.contact.multiplier.segment(pair_.first_row, coupling.n_rows());
  const bool tied = coupling.type == contact::ContactType::tied;
  ContactValues result;
  result.pressure = coupling.pressure(node, multiplier);
  const Vector3 shear = coupling.shear(node, multiplier);
  result.traction = -(result.pressure * coupling.nodes[node].normal + shear);
  result.shear = shear.norm();
  const auto number = pair_.first_node + static_cast<Index>(node);
  if (!tied) result.gap = open_gap(node);
  if (!heat_.empty()) {
    result.temperature_jump = heat_[static_cast<std::size_t>(number)].jump;
    result.conductance = heat_[static_cast<std::size_t>(number)].conductance;
  }
  if (pair_.gasket) {
    result.creep_closure = at_.creep_closure.empty() ? 0 : at_.creep_closure[static_cast<std::size_t>(number)];
    result.closure =
        result.creep_closure - at_.gaps[pair_.first_row + coupling.row(node)] / coupling.area[node] + growth_[node];
    result.largest_closure = at_.largest_closure[number];
  }
  ContactStatus status = contact::is_closed(pair_, node, at_.contact) ? ContactStatus::slip : ContactStatus::open;
  if (tied) status = ContactStatus::stick;
  if (coupling.has_friction()) {
    const contact::NodeLinearization& law = at_.contact.nodes[static_cast<std::size_t>(number)];
    status = law.status;
    // At an accepted state nothing has slid since the last one: there the traction decides.
    if (status != ContactStatus::open)
      status =
          result.shear >= at_the_limit * law.friction * result.pressure ? ContactStatus::slip : ContactStatus::stick;
    result.slip = at_.friction.path[number];
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
