#include "creepcontact/io/summary.hpp"

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
    result[name] = {{"dofs", body.dofs}, {"elements", body.elements}, {"integration_points", body.integration_points}};
  }
  return result;
}

Json largest(const std::map<std::string, Summary::Largest>& values) {
  Json result = Json::object();
  for (const auto& [body, value] : values) result[body] = {{"largest", value.value}, {"place", value.place}};
  return result;
}

/// Each only if there is something to tell.
void add_life(const Summary& summary, Json& json) {
  if (!summary.damage.empty()) json["damage"] = largest(summary.damage);
  if (!summary.life_fraction.empty()) json["life_fraction"] = largest(summary.life_fraction);
  if (const auto& rupture = summary.rupture)
    json["rupture"] = {{"time", rupture->time},
                       {"body", rupture->body},
                       {"place", rupture->damage.place},
                       {"damage", rupture->damage.value}};
  for (const auto& [name, contact] : summary.contacts)
    json["contacts"][name] = {
        {"largest_normal_force", contact.largest_force},
        {"final_normal_force", contact.final_force},
        {"remaining_fraction", contact.largest_force > 0 ? contact.final_force / contact.largest_force : 0}};
}

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  Json json{{"title", summary.title}, {"units", summary.units}, {"version", summary.version}};
  for (const auto& [name, probe] : summary.probes) {
    json["probes"][name] = {{"quantity", probe.quantity}};
    if (!probe.integrated_over.empty()) json["probes"][name]["integrated_over"] = probe.integrated_over;
  }
  json["status"] = text(summary.status);
  if (!summary.message.empty()) json["message"] = summary.message;
  json["time_reached"] = summary.time_reached;
  json["integrator"] = summary.integrator;
  if (!summary.method.empty()) json["method"] = summary.method;
  json["steps"] = summary.steps;
  json["rejected_steps"] = summary.rejected_steps;
  json["convergence_failures"] = summary.convergence_failures;
  json["rhs_evaluations"] = summary.rhs_evaluations;
  json["jacobian_products"] = summary.jacobian_products;
  json["elastic_solves"] = summary.elastic_solves;
  json["contact_solves"] = summary.contact_solves;
  json["schwarz_iterations"] = summary.schwarz_iterations;
  json["factorizations"] = summary.factorizations;
  json["bodies"] = bodies(summary);
  add_life(summary, json);
  const auto& seconds = summary.wall_seconds;
  json["wall_seconds"] = {{"total", seconds.total},       {"factorize", seconds.factorize}, {"solve", seconds.solve},
                          {"material", seconds.material}, {"contact", seconds.contact},     {"output", seconds.output}};
  json["peak_memory_mb"] = summary.peak_memory_mb;
  // Text that is no UTF-8 (a title in another encoding) must not cost the summary.
  platform::replace_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace creepcontact::io
