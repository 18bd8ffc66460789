#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/summary.hpp"

namespace creepcontact::io {

std::optional<Summary> read_summary(const std::filesystem::path& path) {
  std::ifstream stream(path);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
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
    summary.steps = json.at("steps");
    summary.elastic_solves = json.at("elastic_solves");
    summary.schwarz_iterations = json.at("schwarz_iterations");
    summary.rejected_steps = json.at("rejected_steps");
    summary.convergence_failures = json.at("convergence_failures");
    summary.wall_seconds.total = json.at("wall_seconds").at("total");
    return summary;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

SummaryHeading read_summary_heading(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw ConfigError(fmt::format("cannot read '{}'", path.string()));
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object()) throw ConfigError(fmt::format("'{}' is no JSON object", path.string()));
  const auto text = [](const nlohmann::json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  SummaryHeading heading{text(json, "title"), text(json, "units"), text(json, "status"), {}};
  if (const auto probes = json.find("probes"); probes != json.end() && probes->is_object())
    for (const auto& [name, probe] : probes->items())
      if (probe.is_object()) heading.probes[name] = {text(probe, "quantity"), text(probe, "integrated_over")};
  return heading;
}

}  // namespace creepcontact::io
