#include "creepcontact/io/msh/mesher_protocol.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "creepcontact/base/error.hpp"
#include "geo_scan.hpp"

namespace creepcontact::io {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CadCut, axis, at, keeps_larger)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CadRequest::Size, faces, solids, size)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CadRequest, unit, metres, cuts, surfaces_only, size, per_circle, sizes, surfaces)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CadFacts::Solid, number, name, faces)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CadFacts::Face, number, area)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CadFacts, solids, faces, n_loose)

namespace {

/// File names and names of parts may have any bytes.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace

std::string CadFacts::text() const {
  return dumped(*this);
}

CadFacts CadFacts::from(std::string_view text) {
  try {
    return Json::parse(text).get<CadFacts>();
  } catch (const Json::exception& error) {
    throw ModelError(fmt::format("creepcontact-mesher told nothing useful of the CAD model: {}", error.what()));
  }
}

std::vector<std::string> MesherRequest::arguments() const {
  Json json{{"dimension", dimension},   {"order", order},
            {"parameters", parameters}, {"memory_limit_mb", memory_limit_mb},
            {"trusted", trusted},       {"needs_confinement", needs_confinement}};
  if (cad) json["cad"] = *cad;
  return {file.string(), dumped(json)};
}

MesherRequest MesherRequest::from(const std::vector<std::string>& arguments) {
  const std::string remedy = "creepcontact-mesher is started by creepcontact, which meshes geometries with it";
  if (arguments.size() != 2) throw ConfigError(remedy);
  MesherRequest request;
  request.file = arguments[0];
  try {
    const Json json = Json::parse(arguments[1]);
    json.at("dimension").get_to(request.dimension);
    json.at("order").get_to(request.order);
    json.at("parameters").get_to(request.parameters);
    json.at("memory_limit_mb").get_to(request.memory_limit_mb);
    json.at("trusted").get_to(request.trusted);
    json.at("needs_confinement").get_to(request.needs_confinement);
    if (json.contains("cad")) request.cad = json["cad"].get<CadRequest>();
  } catch (const Json::exception& error) {
    throw ConfigError(fmt::format("{}: {}", remedy, error.what()));
  }
  for (const auto& [name, value] : request.parameters)
    if (!is_identifier(name)) throw ConfigError(fmt::format("'{}' is not the name of a constant", name));
  return request;
}

}  // namespace creepcontact::io
