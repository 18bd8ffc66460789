#include "changed_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/config/configured.hpp"
#include "creepcontact/config/dotted_key.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/writer.hpp"
#include "creepcontact/run/vocabulary.hpp"

namespace creepcontact::run {
namespace {

/// All keys with the texts of their values.
std::vector<config::ConfiguredValue> values_of(const config::Config& config) {
  std::vector<config::ConfiguredValue> all = config::all_values(config);
  for (const config::ConfiguredFunction& function : config::functions(config))  // those within lists too
    all.push_back({function.key, function.value.text()});
  return all;
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

using Parts = std::vector<std::string>;

/// Why there are no derivatives with this key; empty: there are. @param key  its parts_of()
std::string obstacle(const Parts& key) {
  constexpr std::array without_derivative{"time",   "output", "contact_solver", "linear_solver", "report",
                                          "probes", "events", "criteria",       "surfaces",      "sensitivity"};
  if (key.front() == "mesh")
    return "derivatives are not taken with respect to what the mesh is made of; compare runs of a study with [[axes]]";
  if (std::ranges::find(without_derivative, key.front()) != without_derivative.end())
    return "no result has a derivative with respect to it; allowed: what describes the model";
  return "";
}

/// Why this run has no derivatives; empty: it has some.
std::string obstacle(const config::Config& config) {
  if (config.time.cycle || config.time.jump_cycles)
    return "derivatives are not yet taken through cycles (time.cycle); give the loads as functions of t";
  if (config.has_coupled_heat())
    return "derivatives are not yet taken where the conductance of contacts depends on their pressure; give "
           "conductances that do not";
  if (config.is_heat_alone()) return "derivatives are not yet taken of heat alone";
  if (config.probes.empty()) return "there is nothing to differentiate; give [[probes]]";
  return "";
}

config::Config with_value(const config::Config& config, const std::string& text, const std::string& key, double value) {
  config::Config changed = config::parse(text, config.file, vocabulary(), {fmt::format("{}={}", key, value)});
  changed.mesh.trust_geometry = config.mesh.trust_geometry;
  changed.sensitivity = {};
  return changed;
}

}  // namespace

std::vector<ChangedValue> changed_values(const config::Config& config) {
  const config::Sensitivity& wanted = config.sensitivity;
  if (wanted.keys.empty()) return {};
  std::vector<std::string> errors;
  const auto add_error = [&](const config::Reference& at, const std::string& text) {
    const std::string place = at.location.prefix();
    errors.push_back((place.empty() ? fmt::format("{}: sensitivity.keys: ", config.file.string()) : place) + text);
  };
  if (const std::string why = obstacle(config); !why.empty()) add_error(wanted.keys.front(), why);
  const std::vector<config::ConfiguredValue> values = values_of(config);
  std::vector<Parts> parts;
  parts.reserve(values.size());
  for (const config::ConfiguredValue& one : values) parts.push_back(config::parts_of(one.key));
  const std::string text = config::to_toml(config, vocabulary());
  std::vector<ChangedValue> result;
  for (std::size_t k = 0; k < wanted.keys.size(); ++k) {
    const config::Reference& reference = wanted.keys[k];
    const Parts wanted_parts = config::parts_of(reference.name);
    if (const std::string why = obstacle(wanted_parts); !why.empty()) {
      add_error(reference, fmt::format("'{}': {}", reference.name, why));
      continue;
    }
    const auto found = values.begin() + (std::ranges::find(parts, wanted_parts) - parts.begin());
    if (found == values.end()) {
      const auto whole =
          std::ranges::find_if(parts, [&](const Parts& outer) { return config::is_within(wanted_parts, outer); });
      if (whole != parts.end()) {
        const std::string& key = values[static_cast<std::size_t>(whole - parts.begin())].key;
        add_error(reference,
                  fmt::format("'{}' is part of the value of '{}'; derivatives are taken with respect to keys "
                              "whose value is a number",
                              reference.name, key));
        continue;
      }
      std::vector<std::string> names;
      for (std::size_t i = 0; i < values.size(); ++i)
        if (number_in(values[i].text) && obstacle(parts[i]).empty()) names.push_back(values[i].key);
      add_error(reference, fmt::format("this configuration has no value '{}'{}", reference.name,
                                       did_you_mean(reference.name, names)));
      continue;
    }
    const std::string& key = found->key;
    const std::optional<double> value = number_in(found->text);
    if (!value) {
      add_error(reference, fmt::format("the value of '{}' is {}; allowed: a key whose value is a number",
                                       reference.name, found->text));
      continue;
    }
    ChangedValue one{
        .key = key, .value = *value, .change = wanted.changes.empty() ? std::abs(*value) : wanted.changes[k]};
    if (one.change == 0) {
      add_error(reference,
                fmt::format("the value of '{}' is 0, which does not tell what a small change is; give typical "
                            "changes of all keys as sensitivity.changes",
                            reference.name));
      continue;
    }
    try {
      one.more = with_value(config, text, key, *value + relative_change * one.change);
      one.less = with_value(config, text, key, *value - relative_change * one.change);
    } catch (const ConfigError& error) {
      add_error(reference, fmt::format("'{}' cannot be changed both up and down: {}", reference.name, error.what()));
      continue;
    }
    result.push_back(std::move(one));
  }
  if (!errors.empty()) throw ConfigError(fmt::format("{}", fmt::join(errors, "\n")));
  return result;
}

}  // namespace creepcontact::run
