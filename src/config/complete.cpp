#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "creepcontact/base/overload.hpp"
#include "creepcontact/config/writer.hpp"
#include "section_checks.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

constexpr std::array<double, 3> z_axis{0, 0, 1};

/// Sets the number of a constant that is given as a word, or the word if the number is given.
void complete_word(const LawKey& key, CreepParameter& parameter) {
  if (key.words.empty()) return;
  if (parameter.values.empty()) {
    const auto number = std::ranges::find(key.words, parameter.word) - key.words.begin();
    parameter.values = {static_cast<double>(number)};
  }
  const double number = parameter.values.front()({});
  if (!(number >= 0 && number < static_cast<double>(key.words.size())))
    throw std::invalid_argument(fmt::format("'{}' is not one of the words that '{}' takes", parameter.word, key.name));
  parameter.word = key.words[static_cast<std::size_t>(number)];
}

void complete_law(CreepMechanism& mechanism, const std::vector<Law>& laws) {
  const auto law = std::ranges::find(laws, mechanism.law, &Law::name);
  if (law == laws.end()) throw std::invalid_argument(fmt::format("there is no creep law '{}'", mechanism.law));
  std::vector<CreepParameter> given = std::exchange(mechanism.parameters, {});
  for (const LawKey& key : law->keys) {
    const auto found = std::ranges::find(given, key.name, &CreepParameter::key);
    if (found == given.end()) {
      if (!key.required) mechanism.parameters.push_back(default_parameter(key, mechanism.location));
      continue;
    }
    describe_parameter(key, *found);
    complete_word(key, *found);
    mechanism.parameters.push_back(std::move(*found));
    given.erase(found);
  }
  if (!given.empty())
    throw std::invalid_argument(fmt::format("the creep law '{}' has no constant '{}'", law->name, given.front().key));
  if (!law->validate || mechanism.parameters.size() != law->keys.size()) return;
  std::vector<std::vector<Function>> values;
  for (const CreepParameter& parameter : mechanism.parameters) values.push_back(parameter.values);
  mechanism.depends_on_temperature = law->validate(values).depends_on_temperature;
}

/// The laws that have no ranges of their own get those of the material.
void translate_data_range(Material& material, std::vector<std::string>& remarks) {
  if (!material.data_range) return;
  const DataRange old = *std::exchange(material.data_range, std::nullopt);
  const auto take = [](const std::optional<Interval>& from, std::optional<Interval>& to) {
    if (!to) to = from;
  };
  for (CreepMechanism& mechanism : material.creep) {
    take(old.stress, mechanism.stress_range);
    take(old.temperature, mechanism.temperature_range);
    take(old.time, mechanism.time_range);
  }
  remarks.push_back(fmt::format(
      "[materials.{0}.data_range] is taken for stress_range, temperature_range and time_range of {1}; give them in "
      "[[materials.{0}.creep]] instead",
      material.name, material.creep.empty() ? "its creep laws, of which it has none" : "its creep laws"));
}

void report_units(Material& material, std::vector<std::string>& remarks) {
  const auto report = [&](std::string& units, const std::string& table) {
    if (units.empty()) return;
    remarks.push_back(
        fmt::format("{}: its numbers are in the units '{}', but the key `units` of the model names none that "
                    "are understood: they are used unchanged",
                    table, units));
    units.clear();
  };
  report(material.units, fmt::format("[materials.{}]", material.name));
  for (CreepMechanism& mechanism : material.creep)
    report(mechanism.units, fmt::format("[[materials.{}.creep]]", material.name));
}

/// Fields are written with the other results of their time.
void complete_times(Config& config) {
  std::vector<double>& times = config.time.output;
  times.insert(times.end(), {0.0, config.time.end});
  if (config.output.field_times) std::ranges::copy(*config.output.field_times, std::back_inserter(times));
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

void complete_axes(Config& config) {
  if (config.analysis != settings::Analysis::axisymmetric) return;
  const auto turn = [](std::array<double, 3>& axis) {
    if (axis == z_axis) axis = y_axis;
  };
  for (Probe& probe : config.probes) turn(probe.axis);
  for (Load& load : config.loads)
    std::visit(Overload{[](Pressure&) {}, [](Traction&) {}, [](PointForce&) {}, [](BodyForce&) {},
                        [&](Rotation& rotation) { turn(rotation.axis); }},
               load.kind);
}

}  // namespace

void complete(Config& config, const Vocabulary& vocabulary) {
  for (Material& material : config.materials) {
    for (CreepMechanism& mechanism : material.creep) complete_law(mechanism, vocabulary.laws);
    translate_data_range(material, config.remarks);
    report_units(material, config.remarks);
  }
  for (Gasket& gasket : config.gaskets)
    for (CreepMechanism& mechanism : gasket.creep) complete_law(mechanism, vocabulary.laws);
  for (Spring& spring : config.springs)
    for (CreepMechanism& mechanism : spring.creep) complete_law(mechanism, vocabulary.laws);
  for (Contact& contact : config.contacts)
    if (contact.name.empty()) contact.name = default_name(contact);
  for (Probe& probe : config.probes) {
    const auto quantity = std::ranges::find(vocabulary.quantities, probe.quantity, &Quantity::name);
    if (quantity != vocabulary.quantities.end() && quantity->sum_only) probe.reduce = Reduce::sum;
  }
  complete_axes(config);
  complete_times(config);
  if (config.output.directory.empty())
    config.output.directory = config.file.parent_path() / "results" / config.file.stem();
}

Config completed(Config config, const Vocabulary& vocabulary) {
  complete(config, vocabulary);
  return config;
}

}  // namespace creepcontact::config
