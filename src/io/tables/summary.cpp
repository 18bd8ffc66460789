#include "creepcontact/io/tables/summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::io {
namespace {

using Json = nlohmann::ordered_json;

const char* text(Summary::Status status) {
  switch (status) {
    case Summary::Status::completed:
      return "completed";
    case Summary::Status::ruptured:
      return "ruptured";
    case Summary::Status::failed:
      return "failed";
    default:
      return "interrupted";
  }
}

Json bodies(const Summary& summary) {
  Json result = Json::object();
  for (const auto& [name, body] : summary.bodies) {
    result[name] = {{"dofs", body.dofs},
                    {"elements", body.elements},
                    {"integration_points", body.integration_points},
                    {"initial_von_mises", body.von_mises.start},
                    {"largest_von_mises", body.von_mises.largest},
                    {"final_von_mises", body.von_mises.end}};
    if (body.von_mises.t_largest > 0) result[name]["t_largest_von_mises"] = body.von_mises.t_largest;
    if (!body.yield_share) continue;
    result[name]["initial_yield_share"] = body.yield_share->start;
    result[name]["largest_yield_share"] = body.yield_share->largest;
    result[name]["final_yield_share"] = body.yield_share->end;
    result[name]["t_largest_yield_share"] = body.yield_share->t_largest;
  }
  return result;
}

Json largest(const std::map<std::string, Summary::Largest>& values) {
  Json result = Json::object();
  for (const auto& [body, value] : values) result[body] = {{"largest", value.value}, {"place", value.position}};
  return result;
}

/// Each only if there is something to tell.
void add_life(const Summary& summary, Json& json) {
  for (const auto& [body, of] : summary.plastic_strain)
    json["plastic_strain"][body] = {
        {"largest", of.strain.value}, {"place", of.strain.position}, {"volume_share", of.volume}};
  if (!summary.damage.empty()) json["damage"] = largest(summary.damage);
  if (!summary.life_fraction.empty()) json["life_fraction"] = largest(summary.life_fraction);
  for (const auto& [body, life] : summary.remaining_life)
    json["remaining_life"][body] = {{"smallest", life.value}, {"place", life.position}};
  if (!summary.fatigue_fraction.empty()) json["fatigue_fraction"] = largest(summary.fatigue_fraction);
  if (!summary.creep_fatigue.empty()) json["creep_fatigue"] = largest(summary.creep_fatigue);
  if (const auto& rupture = summary.rupture)
    json["rupture"] = {{"time", rupture->time},
                       {"body", rupture->body},
                       {"place", rupture->damage.position},
                       {"damage", rupture->damage.value}};
  for (const auto& [name, contact] : summary.contacts) {
    Json& json_contact = json["contacts"][name];
    json_contact = {{"initial_normal_force", contact.normal_force.start},
                    {"largest_normal_force", contact.normal_force.largest},
                    {"final_normal_force", contact.normal_force.end},
                    {"remaining_fraction", contact.normal_force.remaining()}};
    if (contact.normal_force.t_largest > 0) json_contact["t_largest_normal_force"] = contact.normal_force.t_largest;
    if (contact.interference) json_contact["interference"] = *contact.interference;
    if (contact.dissipated_energy) json_contact["dissipated_energy"] = *contact.dissipated_energy;
    if (contact.largest_slip) json_contact["largest_slip"] = *contact.largest_slip;
    if (contact.opened) json_contact["opened"] = *contact.opened;
    if (contact.openings > 0) json_contact["openings"] = contact.openings;
  }
}

/// A number that is not finite becomes null.
Json cycles_json(const Summary::Cycles& cycles) {
  Json json{{"completed", cycles.completed},
            {"computed", cycles.computed},
            {"jumps", cycles.jumps},
            {"rejected_jumps", cycles.rejected_jumps},
            {"longest_jump", cycles.longest_jump}};
  if (cycles.steady) {
    json["steady"] = *cycles.steady;
    json["steady_within"] = cycles.steady_within;
  }
  if (cycles.last_change) json["last_change"] = *cycles.last_change;
  for (const auto& [body, limit] : cycles.to_limit) json["to_limit"][body] = limit;
  return json;
}

Json probe_json(const SummaryProbe& probe) {
  Json json{{"quantity", probe.quantity},
            {"label", probe.label},
            {"dimension", probe.dimension == Dimension::none ? "" : name_of(probe.dimension)}};
  if (!probe.integrated_over.empty()) json["integrated_over"] = probe.integrated_over;
  if (!probe.expression.empty()) json["expression"] = probe.expression;
  if (probe.unit) json["unit"] = *probe.unit;
  if (const auto& course = probe.course) {  // a value that is not finite becomes null
    json["start"] = course->start;
    json["end"] = course->end;
    json["min"] = course->min;
    json["max"] = course->max;
    json["t_min"] = course->t_min;
    json["t_max"] = course->t_max;
  }
  return json;
}

Json accuracy_json(const Summary::Accuracy& accuracy) {
  Json json{{"tolerance", accuracy.tolerance}};
  if (accuracy.largest_step_error > 0) {
    json["mean_step_error"] = accuracy.mean_step_error;
    json["largest_step_error"] = accuracy.largest_step_error;
  }
  if (accuracy.equilibrium_residual) json["equilibrium_residual"] = *accuracy.equilibrium_residual;
  return json;
}

Json heat_json(const Summary::Heat& heat) {
  Json json{{"flows", Json::object()}, {"contacts", Json::object()}, {"stored", heat.stored}, {"rest", heat.rest}};
  for (const auto& [name, flow] : heat.flows) json["flows"][name] = flow;
  for (const auto& [name, flow] : heat.contacts) json["contacts"][name] = flow;
  if (heat.loop_gain) {
    json["loop_gain"] = heat.loop_gain->value;
    json["loop_gain_time"] = heat.loop_gain->time;
  }
  for (const Summary::Heat::SuddenLoss& loss : heat.sudden_losses)
    json["sudden_losses"].push_back(
        {{"contact", loss.contact}, {"time", loss.time}, {"since", loss.since}, {"force", loss.force}});
  return json;
}

}  // namespace

double Summary::Heat::largest() const {
  double result = std::abs(stored);
  for (const auto& [name, flow] : flows) result = std::max(result, std::abs(flow));
  return result;
}

std::string summary_text(const Summary& summary) {
  Json json{{"title", summary.title}, {"units", summary.units}, {"version", summary.version}};
  for (const auto& [name, file] : summary.libraries) json["libraries"][name] = file;
  for (const auto& [material, sources] : summary.sources) json["sources"][material] = sources;
  for (const auto& [name, probe] : summary.probes) json["probes"][name] = probe_json(probe);
  for (const auto& [name, criterion] : summary.criteria) {
    Json& own = json["criteria"][name];
    own = {{"met", criterion.met ? Json(*criterion.met) : Json(nullptr)},
           {"demand", criterion.demand},
           {"kind", criterion.is_minimum ? "min" : "max"},
           {"unit", criterion.unit}};
    if (!criterion.met) continue;
    own.update({{"found", criterion.found},
                {"allowed", criterion.allowed},
                {"utilisation", criterion.utilisation},
                {"time", criterion.time}});
    if (!criterion.body.empty()) own["body"] = criterion.body;
    if (criterion.position) own["place"] = *criterion.position;
  }
  for (const auto& [name, time] : summary.events) json["events"][name] = time ? Json(*time) : Json(nullptr);
  for (const Summary::Sensitivity& one : summary.sensitivities) {
    Json& own = json["sensitivity"][one.key];
    own = {{"value", one.value}, {"change", one.change}, {"probes", Json::object()}};
    for (const auto& [name, derivative] : one.probes) own["probes"][name] = derivative;
    for (const auto& [name, derivative] : one.events) own["events"][name] = derivative;
  }
  json["status"] = text(summary.status);
  if (!summary.message.empty()) json["message"] = summary.message;
  json["time_reached"] = summary.time_reached;
  if (summary.last_output) json["last_output"] = *summary.last_output;
  if (summary.plastic_error) json["plastic_error"] = *summary.plastic_error;
  if (summary.gasket_error) json["gasket_error"] = *summary.gasket_error;
  json["integrator"] = summary.integrator;
  if (!summary.method.empty()) json["method"] = summary.method;
  for (const RunCounters::Field& field : RunCounters::fields) json[std::string(field.name)] = summary.*field.value;
  json["bodies"] = bodies(summary);
  add_life(summary, json);
  if (summary.cycles) json["cycles"] = cycles_json(*summary.cycles);
  if (summary.heat) json["heat"] = heat_json(*summary.heat);
  if (summary.friction_kappa) json["friction_kappa"] = *summary.friction_kappa;
  const auto& seconds = summary.wall_seconds;
  json["wall_seconds"]["total"] = seconds.total;
  for (std::size_t i = 0; i < run_parts.size(); ++i)
    json["wall_seconds"][std::string(run_parts[i].name)] = seconds.parts[i];
  json["peak_memory_mb"] = summary.peak_memory_mb;
  json["accuracy"] = accuracy_json(summary.accuracy);
  if (!summary.warnings.empty()) json["warnings"] = summary.warnings;
  // Text that is not UTF-8 (a title in another encoding) must not prevent the summary.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  platform::replace_file(
      path, summary_text(summary),
      summary.status == Summary::Status::interrupted ? platform::Durable::when_synced : platform::Durable::at_once);
}

}  // namespace creepcontact::io
