#include "creepcontact/results/outcome.hpp"

#include <algorithm>
#include <cmath>

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/results/contact_values.hpp"

namespace creepcontact::results {
namespace {

constexpr double never = std::numeric_limits<double>::quiet_NaN();
constexpr double no_force = 1e-9;  // of the largest: round-off

/// Tied contacts without preload have no normal force of interest.
bool has_normal_force(const contact::Pair& pair) {
  return pair.coupling.type != contact::ContactType::tied || pair.preload;
}

double largest_von_mises(const std::vector<double>& stress) {
  double largest = 0;
  for (std::size_t i = 0; i < stress.size(); i += 6)
    largest = std::max(largest, tensor::von_mises(tensor::ConstMap(&stress[i])));
  return largest;
}

void add(double value, bool is_first, io::Summary::Course& course) {
  if (is_first) course.start = value;
  course.largest = is_first ? value : std::max(course.largest, value);
  course.end = value;
}

std::vector<double> packed(const std::vector<io::Summary::Course>& courses) {
  std::vector<double> values;
  for (const io::Summary::Course& course : courses)
    values.insert(values.end(), {course.start, course.largest, course.end});
  return values;
}

bool unpack(const creep::Memory& memory, const std::string& name, std::vector<io::Summary::Course>& courses) {
  const auto found = memory.find(name);
  if (found == memory.end() || found->second.size() != 3 * courses.size()) return false;
  for (std::size_t i = 0; i < courses.size(); ++i)
    courses[i] = {found->second[3 * i], found->second[3 * i + 1], found->second[3 * i + 2]};
  return true;
}

}  // namespace

Outcome::Outcome(const creep::Assembly& assembly)
    : assembly_(assembly),
      forces_(assembly.pairs().size()),
      opened_(assembly.pairs().size(), never),
      stresses_(assembly.bodies().size()),
      dissipated_(assembly.pairs().size(), never),
      slip_(assembly.pairs().size(), never),
      interference_(assembly.pairs().size(), never),
      slid_far_(assembly.pairs().size(), 0) {}

void Outcome::see_friction(double time, const creep::Equilibrium& at, std::size_t p) {
  const contact::Pair& pair = assembly_.pairs()[p];
  const contact::MortarCoupling& coupling = pair.coupling;
  const mesh::Mesh& slave = assembly_.bodies()[pair.slave_body].mesh();
  dissipated_[p] = at.friction.dissipated[p];
  slip_[p] = at.friction.path.segment(pair.first_node, std::ssize(coupling.nodes)).maxCoeff();
  for (std::size_t i = 0; i < coupling.nodes.size() && slid_far_[p] == 0; ++i) {
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
  }
}

void Outcome::output(double time, const creep::Equilibrium& at) {
  const bool is_first = !started_;
  started_ = true;
  for (std::size_t p = 0; p < forces_.size(); ++p) {
    const contact::Pair& pair = assembly_.pairs()[p];
    if (!has_normal_force(pair)) continue;
    if (pair.preload) interference_[p] = at.interference[p];
    add(normal_force(pair, at.contact.multiplier), is_first, forces_[p]);
    const bool is_open = forces_[p].end <= no_force * forces_[p].largest;
    if (!is_open)
      opened_[p] = never;
    else if (forces_[p].largest > 0 && std::isnan(opened_[p]))
      opened_[p] = time;
    if (pair.coupling.has_friction()) see_friction(time, at, p);
  }
  for (std::size_t b = 0; b < stresses_.size(); ++b)
    add(assembly_.team().max(largest_von_mises(at.bodies[b].stress)), is_first, stresses_[b]);
}

void Outcome::warn_of_open_contacts() const {
  for (std::size_t p = 0; p < forces_.size(); ++p) {
    const contact::Pair& pair = assembly_.pairs()[p];
    if (!has_normal_force(pair) || forces_[p].largest > 0) continue;
    log::warning("contact '{}' was open at every output time and carried no load (a negative gap is an interference)",
                 pair.name);
  }
}

void Outcome::fill(io::Summary& summary) const {
  for (std::size_t b = 0; b < stresses_.size(); ++b)
    summary.bodies[assembly_.bodies()[b].name()].von_mises = stresses_[b];
  for (std::size_t p = 0; p < forces_.size(); ++p) {
    const contact::Pair& pair = assembly_.pairs()[p];
    if (!has_normal_force(pair)) continue;
    io::Summary::Contact& contact = summary.contacts[pair.name];
    contact.normal_force = forces_[p];
    if (!std::isnan(interference_[p])) contact.interference = interference_[p];
    if (!std::isnan(dissipated_[p])) contact.dissipated_energy = dissipated_[p];
    if (!std::isnan(slip_[p])) contact.largest_slip = slip_[p];
    if (!std::isnan(opened_[p])) contact.opened = opened_[p];
  }
}

void Outcome::save(creep::Memory& memory) const {
  memory["outcome.forces"] = packed(forces_);
  memory["outcome.opened"] = opened_;
  memory["outcome.stresses"] = packed(stresses_);
}

void Outcome::restore(const creep::Memory& memory) {
  const auto opened = memory.find("outcome.opened");
  if (opened == memory.end() || opened->second.size() != opened_.size()) return;
  started_ = unpack(memory, "outcome.forces", forces_) && unpack(memory, "outcome.stresses", stresses_);
  if (started_) opened_ = opened->second;
}

}  // namespace creepcontact::results
