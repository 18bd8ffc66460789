#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "../file_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/io/tables/summary.hpp"

namespace creepcontact::io {

namespace {

/// @throws nlohmann::json::exception if there is no whole number of this name: no other number fits one
std::int64_t count(const nlohmann::json& json, std::string_view name) {
  const nlohmann::json& value = json.at(std::string(name));
  return value.is_number_unsigned() ? value.get<std::int64_t>() : value.get_ref<const std::int64_t&>();
}

std::map<std::string, std::optional<double>> events_of(const nlohmann::json& summary) {
  std::map<std::string, std::optional<double>> result;
  const auto events = summary.find("events");
  if (events == summary.end() || !events->is_object()) return result;
  for (const auto& [name, time] : events->items()) {
    result[name];
    if (time.is_number()) result[name] = time.get<double>();
  }
  return result;
}

/// A number; 0 for anything else, such as null for one that was not finite.
double number(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number() ? found->get<double>() : 0;
}

std::optional<double> number_if_any(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

Summary::Largest place_of(const nlohmann::json& json, const char* value) {
  return {number(json, value), json.value("place", std::array<double, 3>{})};
}

/// @param extreme  the name of the value of each body
std::map<std::string, Summary::Largest> extremes_of(const nlohmann::json& summary, const char* name,
                                                    const char* extreme) {
  std::map<std::string, Summary::Largest> result;
  const auto found = summary.find(name);
  if (found != summary.end())
    for (const auto& [body, value] : found->items()) result[body] = place_of(value, extreme);
  return result;
}

void read_sensitivities(const nlohmann::json& json, Summary& summary) {
  const auto found = json.find("sensitivity");
  if (found == json.end() || !found->is_object()) return;
  for (const auto& [key, own] : found->items()) {
    if (!own.is_object()) continue;
    Summary::Sensitivity& one = summary.sensitivities.emplace_back();
    one.key = key;
    one.value = number(own, "value");
    one.change = number(own, "change");
    for (const auto& [name, to] : {std::pair("probes", &one.probes), std::pair("events", &one.events)})
      if (const auto derivatives = own.find(name); derivatives != own.end() && derivatives->is_object())
        for (const auto& [of, derivative] : derivatives->items())
          (*to)[of] = derivative.is_number() ? derivative.get<double>() : NAN;
  }
}

void read_criteria(const nlohmann::json& json, Summary& summary) {
  const auto found = json.find("criteria");
  if (found == json.end() || !found->is_object()) return;
  for (const auto& [name, from] : found->items()) {
    if (!from.is_object()) continue;
    Summary::Criterion& criterion = summary.criteria[name];
    if (const auto met = from.find("met"); met != from.end() && met->is_boolean()) criterion.met = met->get<bool>();
    criterion.is_minimum = from.value("kind", "max") == "min";
    criterion.found = number(from, "found");
    criterion.allowed = number(from, "allowed");
    // Beyond a limit of zero it is infinite, which JSON has no number for.
    criterion.utilisation = number_if_any(from, "utilisation").value_or(std::numeric_limits<double>::infinity());
    criterion.time = number(from, "time");
    criterion.body = from.value("body", "");
    if (from.contains("place")) criterion.position = from.at("place").get<std::array<double, 3>>();
    criterion.demand = from.value("demand", "");
    criterion.unit = from.value("unit", "");
  }
}

/// @param of  the end of the names of its numbers
Summary::Course course_of(const nlohmann::json& json, const std::string& of) {
  return {number(json, ("initial_" + of).c_str()), number(json, ("largest_" + of).c_str()),
          number(json, ("final_" + of).c_str()), number(json, ("t_largest_" + of).c_str())};
}

void read_bodies(const nlohmann::json& json, Summary& summary) {
  const auto bodies = json.find("bodies");
  if (bodies == json.end()) return;
  for (const auto& [name, body] : bodies->items()) {
    summary.bodies[name] = {count(body, "dofs"), count(body, "elements"), count(body, "integration_points"),
                            course_of(body, "von_mises")};
    if (body.contains("largest_yield_share")) summary.bodies[name].yield_share = course_of(body, "yield_share");
  }
}

void read_contacts(const nlohmann::json& json, Summary& summary) {
  const auto contacts = json.find("contacts");
  if (contacts == json.end()) return;
  for (const auto& [name, contact] : contacts->items())
    summary.contacts[name] = {course_of(contact, "normal_force"),
                              number_if_any(contact, "interference"),
                              number_if_any(contact, "dissipated_energy"),
                              number_if_any(contact, "largest_slip"),
                              number_if_any(contact, "opened"),
                              contact.contains("openings") ? count(contact, "openings") : 0};
}

void read_probes(const nlohmann::json& json, Summary& summary) {
  const auto probes = json.find("probes");
  if (probes == json.end()) return;
  for (const auto& [name, probe] : probes->items()) {
    SummaryProbe& read = summary.probes[name];
    read = {probe.value("quantity", ""), probe.value("label", ""), dimension_of(probe.value("dimension", "")),
            probe.value("integrated_over", "")};
    if (probe.contains("unit")) read.unit = probe.value("unit", "");
    read.expression = probe.value("expression", "");
    if (probe.contains("start"))
      read.course = {number(probe, "start"), number(probe, "end"),   number(probe, "min"),
                     number(probe, "max"),   number(probe, "t_min"), number(probe, "t_max")};
  }
}

void read_cycles(const nlohmann::json& json, Summary& summary) {
  const auto found = json.find("cycles");
  if (found == json.end()) return;
  Summary::Cycles cycles;
  cycles.completed = count(*found, "completed");
  cycles.computed = count(*found, "computed");
  cycles.jumps = count(*found, "jumps");
  cycles.rejected_jumps = count(*found, "rejected_jumps");
  cycles.longest_jump = count(*found, "longest_jump");
  if (found->contains("steady")) cycles.steady = count(*found, "steady");
  cycles.steady_within = number(*found, "steady_within");
  if (found->contains("last_change")) cycles.last_change = number(*found, "last_change");
  if (const auto limits = found->find("to_limit"); limits != found->end())
    for (const auto& [body, limit] : limits->items())
      cycles.to_limit[body] = limit.is_number() ? limit.get<double>() : std::numeric_limits<double>::infinity();
  summary.cycles = std::move(cycles);
}

void read_accuracy(const nlohmann::json& json, Summary& summary) {
  const auto found = json.find("accuracy");
  if (found == json.end()) return;
  summary.accuracy = {number(*found, "tolerance"), number(*found, "mean_step_error"),
                      number(*found, "largest_step_error"), number_if_any(*found, "equilibrium_residual")};
}

void read_heat(const nlohmann::json& json, Summary& summary) {
  const auto found = json.find("heat");
  if (found == json.end()) return;
  Summary::Heat heat;
  const auto read = [&](const char* key, std::vector<std::pair<std::string, double>>& into) {
    if (const auto flows = found->find(key); flows != found->end() && flows->is_object())
      for (const auto& [name, flow] : flows->items())
        into.emplace_back(name, flow.is_number() ? flow.get<double>() : 0);
  };
  read("flows", heat.flows);
  read("contacts", heat.contacts);
  heat.stored = number(*found, "stored");
  heat.rest = number(*found, "rest");
  if (const auto gain = number_if_any(*found, "loop_gain"))
    heat.loop_gain = Summary::Heat::Gain{*gain, number(*found, "loop_gain_time")};
  if (const auto losses = found->find("sudden_losses"); losses != found->end() && losses->is_array())
    for (const nlohmann::json& loss : *losses)
      heat.sudden_losses.push_back(
          {loss.value("contact", ""), number(loss, "time"), number(loss, "since"), number(loss, "force")});
  summary.heat = std::move(heat);
}

void read_wall_seconds(const nlohmann::json& json, Summary& summary) {
  summary.wall_seconds.total = json.at("total");
  for (std::size_t i = 0; i < run_parts.size(); ++i)
    summary.wall_seconds.parts[i] = number(json, std::string(run_parts[i].name).c_str());
}

}  // namespace

std::optional<Summary> parse_summary(std::string_view text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    Summary summary;
    const std::string status = json.at("status");
    using Status = Summary::Status;
    summary.status = status == "completed"  ? Status::completed
                     : status == "ruptured" ? Status::ruptured
                     : status == "failed"   ? Status::failed
                                            : Status::interrupted;
    summary.message = json.value("message", "");
    summary.version = json.at("version");
    summary.time_reached = json.at("time_reached");
    summary.last_output = number_if_any(json, "last_output");
    summary.plastic_error = number_if_any(json, "plastic_error");
    summary.gasket_error = number_if_any(json, "gasket_error");
    for (const RunCounters::Field& field : RunCounters::fields) summary.*field.value = count(json, field.name);
    summary.events = events_of(json);
    read_criteria(json, summary);
    read_sensitivities(json, summary);
    summary.warnings = json.value("warnings", std::vector<std::string>());
    read_wall_seconds(json.at("wall_seconds"), summary);
    summary.title = json.value("title", "");
    summary.units = json.value("units", "");
    summary.integrator = json.value("integrator", "");
    summary.method = json.value("method", "");
    read_bodies(json, summary);
    read_contacts(json, summary);
    read_probes(json, summary);
    read_accuracy(json, summary);
    if (const auto found = json.find("plastic_strain"); found != json.end())
      for (const auto& [body, value] : found->items())
        summary.plastic_strain[body] = {place_of(value, "largest"), number(value, "volume_share")};
    summary.damage = extremes_of(json, "damage", "largest");
    summary.life_fraction = extremes_of(json, "life_fraction", "largest");
    summary.remaining_life = extremes_of(json, "remaining_life", "smallest");
    summary.sources = json.value("sources", std::map<std::string, std::vector<std::string>>());
    summary.fatigue_fraction = extremes_of(json, "fatigue_fraction", "largest");
    summary.creep_fatigue = extremes_of(json, "creep_fatigue", "largest");
    read_cycles(json, summary);
    if (const auto rupture = json.find("rupture"); rupture != json.end())
      summary.rupture = {number(*rupture, "time"), rupture->value("body", ""), place_of(*rupture, "damage")};
    read_heat(json, summary);
    summary.friction_kappa = number_if_any(json, "friction_kappa");
    summary.peak_memory_mb = number(json, "peak_memory_mb");
    return summary;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::optional<Summary> read_summary(const std::filesystem::path& path) {
  try {
    return parse_summary(file_text<ConfigError>(path));
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

SummaryHeading parse_summary_heading(std::string_view content, const std::string& name) {
  const auto json = nlohmann::json::parse(content, nullptr, false);
  if (!json.is_object()) throw ConfigError(fmt::format("'{}' is not a JSON object", name));
  const auto text = [](const nlohmann::json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  SummaryHeading heading{text(json, "title"), text(json, "units"), text(json, "status"), {}, {}};
  for (const auto& [event, time] : events_of(json))
    if (time) heading.events[event] = *time;
  if (const auto probes = json.find("probes"); probes != json.end() && probes->is_object())
    for (const auto& [key, probe] : probes->items())
      if (probe.is_object()) {
        heading.probes[key] = {text(probe, "quantity"), text(probe, "label"), dimension_of(text(probe, "dimension")),
                               text(probe, "integrated_over")};
        if (probe.contains("unit")) heading.probes[key].unit = text(probe, "unit");
        heading.probes[key].expression = text(probe, "expression");
      }
  return heading;
}

SummaryHeading read_summary_heading(const std::filesystem::path& path) {
  return parse_summary_heading(file_text<ConfigError>(path), path.string());
}

}  // namespace creepcontact::io
