#include "fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/config/configured.hpp"

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

/// Lines of item and value, separated by a tabulator.
class Lines {
 public:
  void add(const std::string& item, const std::string& value) {
    std::string line = fmt::format("{}\t{}", item, value);
    std::replace(line.begin(), line.end(), '\n', ' ');
    text_ += line + '\n';
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Whether the key belongs to a material that no body has.
bool is_of_unused_material(const std::string& key, const config::Config& config) {
  return std::ranges::any_of(config.materials, [&](const config::Material& material) {
    return key.starts_with(fmt::format("materials.{}.", material.name)) &&
           std::ranges::none_of(config.bodies,
                                [&](const config::Body& body) { return body.material.name == material.name; });
  });
}

/// Whether the key belongs to a method of contact that this model does not use.
bool is_of_unused_method(const std::string& key, const config::Config& config) {
  const std::string table = "contact_solver.";
  if (!key.starts_with(table)) return false;
  if (config.contacts.empty()) return true;
  const std::string name = key.substr(table.size());
  const settings::ContactSettings& used = config.contact_solver;
  if (used.method == settings::ContactMethod::active_set) return name != "method";
  return used.acceleration == settings::Acceleration::cg && (name.starts_with("alpha") || name == "damping");
}

struct Entry {
  std::string item, value;
};

std::vector<Entry> entries(const std::string& text) {
  std::vector<Entry> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    Entry& entry = result.emplace_back();
    std::getline(parts, entry.item, '\t');
    std::getline(parts, entry.value);
  }
  return result;
}

const Entry* find(const std::vector<Entry>& all, const Entry& wanted) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Entry& entry) { return entry.item == wanted.item; });
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
  for (const mechanics::Body& body : model.bodies())
    lines.add(fmt::format("mesh of body '{}'", body.name()), describe(body.mesh()));
  for (const config::ConfiguredValue& value : config::identifying_values(config))
    if (!is_of_unused_material(value.key, config) && !is_of_unused_method(value.key, config))
      lines.add(value.key, value.text);
  if (config.temperature && !config.temperature->files.empty())
    lines.add("temperature.file", model.temperature->text());  // by its content
  for (const mechanics::Body& body : model.bodies())
    if (const std::span<const double> strain = body.initial_strain(); !strain.empty()) {
      Checksum sum;  // what a file holds, or functions give
      sum.add(strain.data(), strain.size());
      lines.add(fmt::format("initial stress of body '{}'", body.name()), fmt::format("checksum {:016x}", sum.value()));
    }
  return lines.text();
}

std::vector<std::string> differences(const std::string& before, const std::string& now) {
  std::vector<std::string> result;
  const std::vector<Entry> old = entries(before), current = entries(now);
  for (const Entry& entry : old) {
    const Entry* const other = find(current, entry);
    if (!other)
      result.push_back(fmt::format("{} was {} and is now missing", entry.item, shortened(entry.value)));
    else if (other->value != entry.value)
      result.push_back(
          fmt::format("{} was {} and is now {}", entry.item, shortened(entry.value), shortened(other->value)));
  }
  for (const Entry& entry : current)
    if (!find(old, entry)) result.push_back(fmt::format("{} is new: {}", entry.item, shortened(entry.value)));
  if (result.empty() && before != now) result.emplace_back("the order of the bodies changed");
  return result;
}

}  // namespace creepcontact::run
