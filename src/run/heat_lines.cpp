#include "heat_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/model/temperature.hpp"

namespace creepcontact::run {

io::Summary::Heat recorded(const heat::Definition& definition, const heat::Balance& balance, double scale) {
  constexpr double rounding = 1e-12;
  io::Summary::Heat heat;
  const auto take = [&](const auto& named, const std::vector<double>& values,
                        std::vector<std::pair<std::string, double>>& into) {
    for (std::size_t i = 0; i < values.size(); ++i) into.emplace_back(named[i].name, values[i]);
  };
  take(definition.flows, balance.flows, heat.flows);
  take(definition.sources, balance.sources, heat.flows);
  take(definition.point_flows, balance.points, heat.flows);
  take(definition.given, balance.given, heat.flows);
  take(definition.interfaces, balance.interfaces, heat.contacts);
  heat.stored = balance.stored;
  heat.rest = balance.rest();
  if (heat.largest() > rounding * scale) return heat;
  for (auto* all : {&heat.flows, &heat.contacts})
    for (auto& [name, flow] : *all) flow = 0;
  heat.stored = heat.rest = 0;
  return heat;
}

io::Summary::Heat recorded(results::HeatFlows& flows, results::Snapshot& snapshot) {
  return recorded(flows.definition(), flows.at(snapshot), flows.scale(snapshot));
}

std::string balance_lines(const io::Summary::Heat& heat) {
  std::string text;
  const auto line = [&](const std::string& name, double flow) {
    text += fmt::format("    {:<50}{:>14.6g}\n", name, flow);
  };
  for (const auto& [name, flow] : heat.flows) line(name, flow);
  for (const auto& [name, flow] : heat.contacts) line(fmt::format("across contact '{}'", name), flow);
  line("stored in the bodies", heat.stored);
  if (const double largest = heat.largest(); largest > 0)
    text += fmt::format("    balance: {:.1g} of the largest flow is missing\n", std::abs(heat.rest) / largest);
  return text;
}

std::string heat_check(const config::Config& config, const model::Model& model) {
  const heat::Definition* definition = model.assembly.conduction();
  if (definition == nullptr) return "";
  std::string text;
  for (const heat::FilmFigures& film : model.heat->films)
    text += fmt::format(
        "{}: coefficient up to {:.4g}, elements {:.3g} deep, element Biot number {:.2g} (coefficient times depth over "
        "conductivity)\n",
        definition->flows[film.flow].name, film.coefficient, film.element_size, film.biot);
  if (config.has_coupled_heat())
    return text +
           "heat: the conductance of contacts depends on their pressure or gap; see --start for the heat that flows\n";
  heat::Conduction problem(*definition);
  const auto range = model::temperature_range(config, model);
  std::vector<double> T(problem.size(), range ? range->low : 0.0), no_rate(T.size(), 0.0);
  try {
    problem.steady(config.time.end, T);
  } catch (const Error& error) {
    return text + fmt::format("no steady state with what acts at t = {:.6g}: {}\n", config.time.end, error.what());
  }
  const auto [low, high] = std::ranges::minmax(T);
  return text +
         fmt::format(
             "steady state with what acts at t = {:.6g}: {:.6g} to {:.6g}; heat that flows, per time of its data\n",
             config.time.end, low, high) +
         balance_lines(recorded(*definition, problem.balance(config.time.end, T, no_rate),
                                problem.flow_scale(config.time.end, T)));
}

}  // namespace creepcontact::run
