#include "creepcontact/results/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/mechanics/point_extreme.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "creepcontact/results/contact_width.hpp"

namespace creepcontact::results {
namespace {

constexpr double never = std::numeric_limits<double>::quiet_NaN();
constexpr double lost = 1e-9;                  // of the largest force: a contact that carries no more is open
constexpr double min_relative_stress = 1e-12;  // of the largest stress of all bodies: round-off
constexpr double grown = 1.1;                  // force, relative to that at which the width of a contact was last taken

/// Tied contacts without preload have no normal force of interest.
bool has_normal_force(const contact::Pair& pair) {
  return pair.coupling.type != contact::ContactType::tied || pair.preload;
}

double largest_von_mises(const std::vector<double>& stress) {
  double largest = 0;
  for (std::size_t i = 0; i < stress.size(); i += 6)
    largest = std::max(largest, tensor::squared_von_mises(tensor::ConstMap(&stress[i])));
  return std::sqrt(largest);
}

void enlarge(double time, double value, io::Summary::Course& course) {
  if (!(value > course.largest)) return;
  course.largest = value;
  course.t_largest = time;
}

void output(double time, double value, bool is_first, io::Summary::Course& course) {
  if (is_first) course = {.start = value, .largest = value, .end = value, .t_largest = time};
  enlarge(time, value, course);
  course.end = value;
}

/// The course with values below `rounding` set to zero.
io::Summary::Course rounded(io::Summary::Course course, double rounding) {
  for (double* value : {&course.start, &course.largest, &course.end})
    if (std::abs(*value) <= rounding) *value = 0;
  return course;
}

}  // namespace

std::optional<double> largest_yield_share(const mechanics::Body& body, const mechanics::BodyConditions& at,
                                          const std::vector<double>& stress) {
  const std::optional<Function>& strength = body.material().yield_strength;
  if (!strength) return std::nullopt;
  const bool varies = strength->depends_on_temperature() && !at.temperature.empty();
  const double uniform = (*strength)({.T = body.material().reference_temperature});
  double largest = 0;
  for (std::size_t p = 0; 6 * p < stress.size(); ++p)
    largest = std::max(largest, tensor::von_mises(tensor::view(stress, p)) /
                                    (varies ? (*strength)({.T = at.temperature[p]}) : uniform));
  return largest;
}

namespace {

/// @param accumulated  plastic strain at the points of this process; empty: none
StepValues::Flow flow_of(const mechanics::Body& body, const std::vector<double>& accumulated, const Team& team) {
  StepValues::Flow flow;
  if (!team.any(!accumulated.empty())) return flow;
  const mechanics::Discretization& discretization = body.discretization();
  std::array<double, 2> volumes{};  // that has yielded, and all
  for (std::size_t p = 0; p < discretization.n_points(); ++p) {
    volumes[1] += discretization.weights()[p];
    if (!accumulated.empty() && accumulated[p] > 0) volumes[0] += discretization.weights()[p];
  }
  team.sum(volumes);
  const auto [largest, x, y, z] = mechanics::point_extreme(body, accumulated, 1, team);
  return {largest, {x, y, z}, volumes[0] / volumes[1]};
}

}  // namespace

Outcome::Outcome(const creep::Assembly& assembly)
    : assembly_(assembly),
      forces_(assembly.pairs().size()),
      widths_(assembly.pairs().size(), {0, 0, 0}),
      openings_(assembly.pairs().size(), {never, never, 0}),
      stresses_(assembly.bodies().size()),
      shares_(assembly.bodies().size()),
      dissipated_(assembly.pairs().size(), never),
      slip_(assembly.pairs().size(), never),
      interference_(assembly.pairs().size(), never),
      slid_far_(assembly.pairs().size(), 0),
      beyond_(assembly.pairs().size(), 0) {
  for (const mechanics::Body& body : assembly.bodies()) moduli_.push_back(scale_modulus(body));
  for (const contact::Pair& pair : assembly.pairs()) rounding_.push_back(round_off_force(assembly, pair));
}

StepValues Outcome::values(const creep::Assembly& assembly, double time, const creep::Equilibrium& at,
                           const Team& team) {
  StepValues values;
  values.time = time;
  for (const contact::Pair& pair : assembly.pairs())
    values.forces.push_back(has_normal_force(pair) ? normal_force(pair, at.contact.multiplier) : 0);
  for (std::size_t b = 0; b < at.bodies.size(); ++b) {
    values.von_mises.push_back(largest_von_mises(at.bodies[b].stress));
    values.yield_share.push_back(
        largest_yield_share(assembly.bodies()[b], at.conditions[b], at.bodies[b].stress).value_or(0));
  }
  team.max(values.von_mises);
  team.max(values.yield_share);
  for (std::size_t b = 0; b < at.plastic.bodies.size(); ++b)
    values.flow.push_back(flow_of(assembly.bodies()[b], at.plastic.bodies[b].accumulated, team));
  return values;
}

double Outcome::no_force(std::size_t p) const {
  return std::max(lost * forces_[p].largest, rounding_[p]);
}

void Outcome::follow(double time, std::size_t p, double force) {
  Opening& opening = openings_[p];
  if (force > no_force(p)) {
    opening.carried = time;
    opening.since = never;
  } else if (!std::isnan(opening.carried) && std::isnan(opening.since)) {
    opening.since = time;
    ++opening.count;
  }
}

void Outcome::observe_closure(double time, const creep::Equilibrium& at, std::size_t p) {
  const contact::Pair& pair = assembly_.pairs()[p];
  const contact::GasketKind& kind = pair.gasket->kind();
  const auto n = std::ssize(pair.coupling.nodes);
  const double largest = at.contact.closure.segment(pair.first_node, n).maxCoeff(), last = kind.law.last_closure();
  if (!(largest > last)) return;
  beyond_[p] = 1;
  log::warning(
      "{} '{}': its closure is {:.6g} at t = {:.6g}, beyond the last point of its curve, {:.6g}; from there on the "
      "last slope goes on",
      pair.ties_nodes() ? "spring" : "gasket", kind.name, largest, time, last);
}

void Outcome::observe_contacts(double time, const creep::Equilibrium& at) {
  for (std::size_t p = 0; p < assembly_.pairs().size(); ++p) {
    const contact::Pair& pair = assembly_.pairs()[p];
    if (pair.coupling.has_friction() && slid_far_[p] == 0) observe_slip(time, at, p);
    if (pair.gasket && beyond_[p] == 0) observe_closure(time, at, p);
    if (pair.coupling.type == contact::ContactType::tied) continue;
    const double force = normal_force(pair, at.contact.multiplier);
    if (!(force > std::max(grown * widths_[p].force, rounding_[p]))) continue;
    widths_[p] = {static_cast<double>(elements_across(assembly_, pair, at).value_or(0)), time, force};
  }
}

std::vector<std::string> Outcome::narrow_contacts() const {
  std::vector<std::string> lines;
  for (std::size_t p = 0; p < widths_.size(); ++p) {
    if (widths_[p].elements == 0 || forces_[p].end > no_force(p)) continue;
    const std::string when = fmt::format("at t = {:.6g}, where it carries most,", widths_[p].time);
    if (std::string text = narrow_contact_text(assembly_.pairs()[p], static_cast<int>(widths_[p].elements), when);
        !text.empty())
      lines.push_back(std::move(text));
  }
  return lines;
}

void Outcome::observe_slip(double time, const creep::Equilibrium& at, std::size_t p) {
  const contact::Pair& pair = assembly_.pairs()[p];
  const contact::MortarCoupling& coupling = pair.coupling;
  const mesh::Mesh& slave = assembly_.bodies()[pair.slave_body].mesh();
  for (std::size_t i = 0; i < coupling.nodes.size(); ++i) {
    const double area = coupling.area[i];
    const Index first = pair.first_row + coupling.row(i) + 1;
    const double slid = at.friction.slip.segment(first, coupling.rows_per_node() - 1).norm() / area;
    const double depth = slave.section.depth(slave.nodes[coupling.nodes[i].node]);
    const double size = slave.section.dimension() == 3 ? std::sqrt(area) : area / depth;
    const bool is_closed =
        at.contact.nodes[static_cast<std::size_t>(pair.first_node) + i].status != contact::ContactStatus::open;
    if (!is_closed || slid <= size) continue;
    slid_far_[p] = 1;
    log::warning(
        "contact '{}': at t = {:.6g} the surfaces have slid by {:.4g}, more than an element ({:.4g}); contact is "
        "between "
        "nodes and faces where they are in the mesh, so results are doubtful from here on",
        pair.name, time, slid, size);
    return;
  }
}

void Outcome::output(double time, const creep::Equilibrium& at) {
  const bool is_first = !started_;
  started_ = true;
  last_output_ = time;
  const StepValues now = values(assembly_, time, at, assembly_.team());
  for (std::size_t p = 0; p < forces_.size(); ++p) {
    const contact::Pair& pair = assembly_.pairs()[p];
    if (!has_normal_force(pair)) continue;
    if (pair.preload) interference_[p] = at.interference[p];
    results::output(time, now.forces[p], is_first, forces_[p]);
    follow(time, p, now.forces[p]);
    if (!pair.coupling.has_friction()) continue;
    dissipated_[p] = at.friction.dissipated[p];
    slip_[p] = at.friction.path.segment(pair.first_node, std::ssize(pair.coupling.nodes)).maxCoeff();
  }
  observe_contacts(time, at);
  for (std::size_t b = 0; b < stresses_.size(); ++b) results::output(time, now.von_mises[b], is_first, stresses_[b]);
  for (std::size_t b = 0; b < shares_.size(); ++b) results::output(time, now.yield_share[b], is_first, shares_[b]);
  flow_ = now.flow;
}

void Outcome::observe(const StepValues& now) {
  if (!started_) return;
  for (std::size_t p = 0; p < forces_.size(); ++p) {
    if (!has_normal_force(assembly_.pairs()[p])) continue;
    enlarge(now.time, now.forces[p], forces_[p]);
    follow(now.time, p, now.forces[p]);
  }
  for (std::size_t b = 0; b < stresses_.size(); ++b) enlarge(now.time, now.von_mises[b], stresses_[b]);
  for (std::size_t b = 0; b < shares_.size(); ++b) enlarge(now.time, now.yield_share[b], shares_[b]);
  flow_ = now.flow;
}

void Outcome::warn_of_open_contacts() const {
  for (std::size_t p = 0; p < forces_.size(); ++p) {
    const contact::Pair& pair = assembly_.pairs()[p];
    if (!has_normal_force(pair) || forces_[p].largest > rounding_[p]) continue;
    log::warning(
        "contact '{}' carried no load at any time step or output time: it was open, or its surfaces touched without "
        "force (a negative gap is an interference)",
        pair.name);
  }
}

void Outcome::fill(io::Summary& summary, std::optional<double> cycle) const {
  if (started_) summary.last_output = last_output_;
  double largest = 0;
  for (const io::Summary::Course& stress : stresses_) largest = std::max(largest, stress.largest);
  for (std::size_t b = 0; b < stresses_.size(); ++b)
    summary.bodies[assembly_.bodies()[b].name()].von_mises =
        rounded(stresses_[b], std::max(min_relative_stress * largest, round_off_strain * moduli_[b]));
  for (std::size_t b = 0; b < shares_.size(); ++b)
    if (const mechanics::Body& body = assembly_.bodies()[b]; body.material().yield_strength)
      summary.bodies[body.name()].yield_share = shares_[b];
  for (std::size_t b = 0; b < flow_.size(); ++b)
    if (const StepValues::Flow& flow = flow_[b]; flow.largest > 0)
      summary.plastic_strain[assembly_.bodies()[b].name()] = {{flow.largest, flow.place}, flow.volume};
  for (std::size_t p = 0; p < forces_.size(); ++p) {
    const contact::Pair& pair = assembly_.pairs()[p];
    if (!has_normal_force(pair)) continue;
    io::Summary::Contact& contact = summary.contacts[pair.name];
    contact.normal_force = rounded(forces_[p], no_force(p));
    if (!std::isnan(interference_[p])) contact.interference = interference_[p];
    if (!std::isnan(dissipated_[p])) contact.dissipated_energy = dissipated_[p];
    if (!std::isnan(slip_[p])) contact.largest_slip = slip_[p];
    const Opening& opening = openings_[p];
    contact.openings = static_cast<std::int64_t>(opening.count);
    if (std::isnan(opening.since)) continue;
    // Open for now: the next cycle closes it, as the last one has done.
    const bool is_periodic = cycle && opening.count > 1 && opening.carried >= summary.time_reached - *cycle;
    if (!is_periodic) contact.opened = opening.since;
  }
}

void Outcome::save(creep::Memory& memory) const {
  memory.save("outcome", *this, saved_members);
}

void Outcome::restore(const creep::Memory& memory) {
  memory.restore("outcome", *this, saved_members);
}

}  // namespace creepcontact::results
