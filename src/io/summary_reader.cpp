#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/summary.hpp"
#include "file_text.hpp"

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
    for (const RunCounters::Field& field : RunCounters::fields) summary.*field.value = count(json, field.name);
    summary.events = events_of(json);
    summary.wall_seconds.total = json.at("wall_seconds").at("total");
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
        heading.probes[key] = {text(probe, "quantity"), text(probe, "label"), text(probe, "dimension"),
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
