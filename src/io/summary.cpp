#include "creepcontact/io/summary.hpp"

#include <nlohmann/json.hpp>

#include "creepcontact/io/replace_file.hpp"

namespace creepcontact::io {
namespace {

using Json = nlohmann::ordered_json;

const char* text(Summary::Status status) {
  switch (status) {
    case Summary::Status::completed:
      return "completed";
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

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  Json json{{"title", summary.title}, {"units", summary.units}, {"version", summary.version}};
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
  const auto& seconds = summary.wall_seconds;
  json["wall_seconds"] = {{"total", seconds.total},       {"factorize", seconds.factorize}, {"solve", seconds.solve},
                          {"material", seconds.material}, {"contact", seconds.contact},     {"output", seconds.output}};
  json["peak_memory_mb"] = summary.peak_memory_mb;
  // Text that is no UTF-8 (a title in another encoding) must not cost the summary.
  replace_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace creepcontact::io
