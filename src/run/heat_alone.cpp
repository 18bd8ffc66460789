#include "heat_alone.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "creepcontact/base/log.hpp"
#include "creepcontact/results/probe_expression.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::run {

config::Config with_what_is_computed(config::Config config) {
  if (!config.is_heat_alone()) return config;
  config.time.cycle.reset();  // of creep, life and loads
  const std::vector<config::Probe>& probes = config.probes;
  std::vector<char> is_known;
  is_known.reserve(probes.size());
  for (const config::Probe& probe : probes)
    is_known.push_back(probe.expression.given() || results::quantity(probe.quantity).variable->is_of_heat ? 1 : 0);
  const auto uses_unknown = [&](const std::string& text) {
    return std::ranges::any_of(results::ProbeExpression::used(text, probes),
                               [&](std::size_t other) { return is_known[other] == 0; });
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < probes.size(); ++i)
      if (is_known[i] != 0 && probes[i].expression.given() && uses_unknown(probes[i].expression.name)) {
        is_known[i] = 0;
        changed = true;
      }
  }
  std::vector<std::string> left_out;
  std::erase_if(config.events, [&](const config::Event& event) {
    if (!uses_unknown(event.when.name)) return false;
    left_out.push_back(event.name);
    return true;
  });
  std::vector<config::Probe> kept;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (is_known[i] != 0)
      kept.push_back(probes[i]);
    else
      left_out.push_back(probes[i].name);
  }
  config.probes = std::move(kept);
  if (!left_out.empty())
    log::info("only the heat is computed: left out are the probes and events {}", fmt::join(left_out, ", "));
  return config;
}

}  // namespace creepcontact::run
