#include "configured_values.hpp"

#include <algorithm>

#include "creepcontact/config/config.hpp"
#include "item.hpp"
#include "tables.hpp"

namespace creepcontact::config {

void PathVisitor::key(const Key& key, Walk value) {
  const std::size_t length = path_.size();
  if (!path_.empty()) path_ += '.';
  path_ += key.name;
  value(*this);
  path_.resize(length);
}

void PathVisitor::element(std::size_t index, Walk value) {
  const std::size_t length = path_.size();
  path_ += fmt::format("[{}]", index);
  value(*this);
  path_.resize(length);
}

void FunctionCollector::function(const Function& value, const std::vector<std::string>& variables) {
  functions.push_back({path_, value, variables});
}

void ValueCollector::key(const Key& key, Walk value) {
  if (identifying_ && key.info != nullptr && !key.info->identifies_model) return;
  if (key.info == nullptr || key.has_keys || key.info->form != Form::value) return PathVisitor::key(key, value);
  if (identifying_ && key.info->default_value.empty() && key.is_default()) return;
  InlineText line;
  value(line);
  values.push_back({join_key(path_, key.name), line.text});
}

void ValueCollector::function(const Function& value, const std::vector<std::string>& /*variables*/) {
  values.push_back({path_, toml_of(value)});
}

bool ConfiguredFunction::may_depend_on(const std::string& variable) const {
  return std::ranges::find(variables, variable) != variables.end();
}

bool ConfiguredFunction::is_of_position_and_time() const {
  return std::ranges::all_of(variables, [](const std::string& variable) {
    return variable == "x" || variable == "y" || variable == "z" || variable == "t";
  });
}

bool ConfiguredFunction::acts_by_temperature_alone() const {
  return key.starts_with("heat.") || key.ends_with(".conductance") || key.ends_with(".heat_capacity") ||
         key.find(".conductivity") != std::string::npos;
}

namespace {

/// The declarations of the keys; which constants a law has is known to the structs.
const Value<Config>& declared() {
  static const Value<Config> table = config_table({});
  return table;
}

}  // namespace

std::vector<ConfiguredFunction> functions(const Config& config) {
  std::vector<ConfiguredFunction> all = functions_of(declared(), config);
  std::erase_if(all, [](const ConfiguredFunction& function) { return function.key.starts_with("criteria["); });
  return all;
}

bool heat_changes_in_time(const Config& config) {
  return std::ranges::any_of(functions(config), [](const ConfiguredFunction& function) {
    return function.acts_by_temperature_alone() && function.value.depends_on_time();
  });
}

std::vector<ConfiguredValue> identifying_values(const Config& config) {
  return values_of(declared(), config, true);
}

std::vector<ConfiguredValue> all_values(const Config& config) {
  return values_of(declared(), config, false);
}

}  // namespace creepcontact::config
