#include "fingerprint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <tuple>
#include <variant>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::run {
namespace {

std::string describe(const mesh::Mesh& mesh) {
  Checksum sum;
  for (const Vector3& node : mesh.nodes) sum.add(node.data(), 3);
  for (const mesh::CellBlock& block : mesh.blocks) {
    sum.add(&block.type, 1);
    sum.add(block.connectivity.data(), block.connectivity.size());
  }
  return fmt::format("{} nodes, checksum {:016x}", mesh.nodes.size(), sum.value());
}

/// Lines of section, item and value, separated by tabulators.
class Lines {
 public:
  void add(const char* section, std::string item, const std::string& value) {
    const int same = ++count_[std::string(section) + item];
    if (same > 1) item += fmt::format(" ({})", same);
    std::string line = fmt::format("{}\t{}\t{}", section, item, value);
    std::replace(line.begin(), line.end(), '\n', ' ');
    text_ += line + '\n';
  }
  void add(const char* section, const std::string& item, const Function& value) { add(section, item, value.text()); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::map<std::string, int> count_;
};

std::string triple(const std::array<Function, 3>& value) {
  return fmt::format("[{}, {}, {}]", value[0].text(), value[1].text(), value[2].text());
}

void add_material(const config::Material& material, Lines& lines) {
  const auto item = [&](const char* what) { return fmt::format("{} of '{}'", what, material.name); };
  lines.add("materials", item("young_modulus"), material.young_modulus);
  lines.add("materials", item("poisson_ratio"), material.poisson_ratio);
  lines.add("materials", item("thermal_expansion"), material.thermal_expansion);
  lines.add("materials", item("reference_temperature"), fmt::format("{}", material.reference_temperature));
  for (const config::CreepMechanism& mechanism : material.creep) {
    std::string law = mechanism.law;
    for (const config::CreepParameter& parameter : mechanism.parameters) {
      if (!parameter.given) continue;
      for (const Function& value : parameter.values) law += fmt::format(", {} = {}", parameter.key, value.text());
    }
    lines.add("materials", item("creep"), law);
  }
  if (material.rupture) {
    const config::Rupture& rupture = *material.rupture;
    lines.add("materials", item("rupture"),
              fmt::format("{}, C = {}, stress = {}, parameter = {}, absolute_zero = {}, time_unit = {}, measure {} {}",
                          rupture.rupture_time ? rupture.rupture_time->text() : "", rupture.larson_miller_constant,
                          rupture.stress, rupture.parameter, rupture.absolute_zero, rupture.time_unit,
                          static_cast<int>(rupture.stress_measure), rupture.alpha.value_or(0)));
  }
}

void add_support(const config::Support& support, Lines& lines) {
  const std::string place =
      fmt::format("on '{}'{}", support.on.name, support.body.given() ? " of '" + support.body.name + "'" : "");
  for (std::size_t k = 0; k < 3; ++k)
    if (support.displacement[k])
      lines.add("supports", fmt::format("displacement {} {}", "xyz"[k], place), *support.displacement[k]);
  if (support.normal) lines.add("supports", "normal displacement " + place, *support.normal);
}

struct LoadLines {
  const config::Load& load;
  Lines& lines;

  std::string item(const char* kind) const {
    std::string text = kind;
    if (load.on.given()) text += fmt::format(" on '{}'", load.on.name);
    if (load.body.given()) text += fmt::format(" of '{}'", load.body.name);
    return text;
  }
  void operator()(const config::Pressure& pressure) const { lines.add("loads", item("pressure"), pressure.value); }
  void operator()(const config::Traction& traction) const {
    lines.add("loads", item("traction"), triple(traction.value));
  }
  void operator()(const config::BodyForce& force) const { lines.add("loads", item("body_force"), triple(force.value)); }
  void operator()(const config::PointForce& force) const {
    const auto& at = force.at;
    lines.add("loads", fmt::format("{} at [{}, {}, {}]", item("force"), at[0], at[1], at[2]), triple(force.value));
  }
  void operator()(const config::Rotation& rotation) const {
    const auto& [axis, origin] = std::tie(rotation.axis, rotation.origin);
    lines.add("loads", item("rotation"),
              fmt::format("axis [{}, {}, {}], origin [{}, {}, {}], angular_velocity {}, density {}", axis[0], axis[1],
                          axis[2], origin[0], origin[1], origin[2], rotation.angular_velocity.text(),
                          rotation.density.text()));
  }
};

void add_contact(const config::Contact& contact, Lines& lines) {
  const auto item = [&](const char* what) { return fmt::format("{} of '{}'", what, contact.name); };
  lines.add("contacts", item("surfaces"), fmt::format("{}, {}", contact.between[0].name, contact.between[1].name));
  lines.add("contacts", item("type"), contact.type == config::ContactType::tied ? "tied" : "unilateral");
  lines.add("contacts", item("slave"),
            contact.slave < 0 ? "auto" : contact.between[static_cast<std::size_t>(contact.slave)].name);
  lines.add("contacts", item("gap"), contact.geometric_gap ? "geometric" : contact.gap.text());
}

void add_contact_solver(const config::ContactSolver& solver, Lines& lines) {
  constexpr std::array accelerations{"none", "aitken", "anderson", "cg"};
  const bool schwarz = solver.method == config::ContactMethod::schwarz;
  lines.add("contact_solver", "method", schwarz ? "schwarz" : "active_set");
  if (!schwarz) return;
  lines.add("contact_solver", "acceleration", accelerations[static_cast<std::size_t>(solver.acceleration)]);
  if (solver.acceleration == config::Acceleration::cg) return;  // which knows neither of these
  lines.add("contact_solver", "damping", fmt::format("{}", solver.damping));
  std::string alpha = solver.alpha.all ? fmt::format("{}", *solver.alpha.all) : "diagonal";
  for (const auto& [body, value] : solver.alpha.of_body) alpha += fmt::format(", {} = {}", body.name, value);
  lines.add("contact_solver", "alpha", alpha);
}

/// Columns of history.csv would mean two things else.
void add_probe(const config::Probe& probe, Lines& lines) {
  constexpr std::array reductions{"mean", "max", "min", "sum"};
  std::string value = probe.quantity;
  if (probe.on.given()) value += fmt::format(" on '{}'", probe.on.name);
  if (probe.at) value += fmt::format(" at [{}, {}, {}]", (*probe.at)[0], (*probe.at)[1], (*probe.at)[2]);
  if (probe.body.given()) value += fmt::format(" of '{}'", probe.body.name);
  if (results::quantity(probe.quantity).cylindrical)
    value += fmt::format(" about the axis [{}, {}, {}] through [{}, {}, {}]", probe.axis[0], probe.axis[1],
                         probe.axis[2], probe.origin[0], probe.origin[1], probe.origin[2]);
  if (!probe.at) value += fmt::format(", {}", reductions[static_cast<std::size_t>(probe.reduce)]);
  lines.add("probes", fmt::format("'{}'", probe.name), value);
}

struct Entry {
  std::string section, item, value;
};

std::vector<Entry> entries(const std::string& text) {
  std::vector<Entry> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    Entry& entry = result.emplace_back();
    std::getline(parts, entry.section, '\t');
    std::getline(parts, entry.item, '\t');
    std::getline(parts, entry.value);
  }
  return result;
}

const Entry* find(const std::vector<Entry>& all, const Entry& wanted) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& entry) {
    return entry.section == wanted.section && entry.item == wanted.item;
  });
  return found == all.end() ? nullptr : &*found;
}

/// Tables may be long.
std::string shortened(const std::string& value) {
  constexpr std::size_t most = 80;
  return value.size() <= most ? value : value.substr(0, most) + "...";
}

}  // namespace

std::string fingerprint(const config::Config& config, const model::Model& model) {
  Lines lines;
  for (std::size_t b = 0; b < config.bodies.size(); ++b) {
    const config::Body& body = config.bodies[b];
    lines.add("mesh", fmt::format("that of body '{}'", body.name), describe(model.bodies()[b].mesh()));
    lines.add("bodies", fmt::format("material of '{}'", body.name), body.material.name);
  }
  if (config.mesh.share_nodes == config::SharedNodes::tie) lines.add("mesh", "share_nodes", "tie");
  for (const config::Material& material : config.materials)
    if (std::any_of(config.bodies.begin(), config.bodies.end(),
                    [&](const config::Body& body) { return body.material.name == material.name; }))
      add_material(material, lines);
  for (const config::Support& support : config.supports) add_support(support, lines);
  for (const config::Load& load : config.loads) std::visit(LoadLines{load, lines}, load.kind);
  if (model.temperature) lines.add("temperature", "value", model.temperature->text());
  for (const config::Contact& contact : config.contacts) add_contact(contact, lines);
  if (!config.contacts.empty()) add_contact_solver(config.contact_solver, lines);
  for (const config::Probe& probe : config.probes) add_probe(probe, lines);
  return lines.text();
}

std::vector<std::string> differences(const std::string& before, const std::string& now) {
  std::vector<std::string> result;
  const std::vector<Entry> old = entries(before), current = entries(now);
  for (const Entry& entry : old) {
    const Entry* const other = find(current, entry);
    if (!other)
      result.push_back(
          fmt::format("{} changed: {} was '{}' and is gone", entry.section, entry.item, shortened(entry.value)));
    else if (other->value != entry.value)
      result.push_back(fmt::format("{} changed: {} was '{}' and is '{}'", entry.section, entry.item,
                                   shortened(entry.value), shortened(other->value)));
  }
  for (const Entry& entry : current)
    if (!find(old, entry))
      result.push_back(fmt::format("{} changed: {} is new, '{}'", entry.section, entry.item, shortened(entry.value)));
  if (result.empty() && before != now) result.emplace_back("their order changed");
  return result;
}

}  // namespace creepcontact::run
