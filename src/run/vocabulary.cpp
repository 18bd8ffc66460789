#include "creepcontact/run/vocabulary.hpp"

#include <algorithm>

#include "creepcontact/material/creep_fatigue.hpp"
#include "creepcontact/material/life_fraction.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/ode/integrator.hpp"
#include "creepcontact/platform/companions.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::run {
namespace {

/// Makes the law, to see what it says.
config::LawValidation validate(const material::LawInfo& info, const material::ParameterValues& values) {
  try {
    const auto law = info.make(values);
    const auto& parameters = law->parameters();
    const bool by_temperature = std::any_of(parameters.begin(), parameters.end(),
                                            [](const Function& value) { return value.depends_on_temperature(); });
    return {.mistake = {}, .depends_on_temperature = by_temperature};
  } catch (const material::ParameterError& error) {
    return {.mistake = config::LawError{error.key(), error.found(), error.allowed()}};
  }
}

std::optional<config::LawError> validate_larson_miller(const std::vector<double>& stress,
                                                       const std::vector<double>& parameter) {
  try {
    material::larson_miller({.stress = stress, .parameter = parameter});
    return std::nullopt;
  } catch (const material::ParameterError& error) {
    return config::LawError{error.key(), error.found(), error.allowed()};
  }
}

std::optional<config::LawError> validate_fatigue(const std::vector<double>& strain_range,
                                                 const std::vector<double>& cycles,
                                                 const std::vector<std::vector<double>>& interaction) {
  try {
    if (!strain_range.empty()) material::fatigue_table(strain_range, cycles);
    std::vector<material::InteractionDiagram::Point> points;
    for (const std::vector<double>& point : interaction) points.push_back({point.at(0), point.at(1)});
    material::InteractionDiagram{points};
    return std::nullopt;
  } catch (const material::ParameterError& error) {
    return config::LawError{error.key(), error.found(), error.allowed()};
  }
}

}  // namespace

config::Vocabulary vocabulary() {
  config::Vocabulary result;
  result.materials = platform::find_shared("materials");
  for (const material::LawInfo& law : material::creep_laws()) {
    config::Law entry{.name = law.name, .keys = {}, .formula = law.formula};
    for (const material::ParameterInfo& parameter : law.parameters) {
      config::LawKey key;
      key.name = parameter.key;
      key.description = parameter.description;
      key.minimum = parameter.minimum;
      key.strict = parameter.strict;
      key.list = parameter.list;
      key.variables = parameter.variables;
      key.required = !parameter.fallback;
      key.fallback = parameter.fallback.value_or(std::vector<Function>{});
      key.maximum = parameter.maximum;
      key.words = parameter.words;
      key.dimension = parameter.dimension;
      entry.keys.push_back(key);
    }
    entry.validate = [&law](const material::ParameterValues& values) { return validate(law, values); };
    result.laws.push_back(std::move(entry));
  }
  result.validate_larson_miller = validate_larson_miller;
  result.validate_fatigue = validate_fatigue;
  for (const ode::IntegratorInfo& info : ode::integrators()) {
    result.integrators.push_back(info.name);
    if (!info.tables.empty()) result.tables[info.name] = info.tables;
  }
  for (const results::Quantity& quantity : results::quantities()) {
    const results::OutputVariable& variable = *quantity.variable;
    config::Quantity entry;
    entry.name = quantity.name;
    entry.section = variable.is<results::OnPlane>();
    entry.body_only = variable.is<results::OnCrossSection>() || entry.section;
    entry.surface_only = !variable.is_field() && !entry.body_only;
    entry.sum_only = variable.is_sum();
    entry.moment = variable.about_origin;
    entry.cylindrical = variable.cylindrical;
    result.quantities.push_back(entry);
  }
  return result;
}

}  // namespace creepcontact::run
