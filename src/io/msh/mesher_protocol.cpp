#include "creepcontact/io/msh/mesher_protocol.hpp"

#include <fmt/format.h>

#include <charconv>

#include "creepcontact/base/error.hpp"
#include "geo_scan.hpp"

namespace creepcontact::io {
namespace {

template <typename T>
T number(const std::string& text) {
  T value{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size())
    throw ConfigError(fmt::format("'{}' is not a number; creepcontact-mesher is started by creepcontact", text));
  return value;
}

}  // namespace

std::vector<std::string> MesherRequest::arguments() const {
  std::vector<std::string> words{file.string(),         std::to_string(dimension),
                                 std::to_string(order), std::to_string(memory_limit_mb),
                                 trusted ? "1" : "0",   needs_confinement ? "1" : "0"};
  for (const auto& [name, value] : parameters) {
    words.push_back(name);
    words.push_back(fmt::format("{}", value));
  }
  return words;
}

MesherRequest MesherRequest::from(const std::vector<std::string>& arguments) {
  constexpr std::size_t fixed = 6;
  if (arguments.size() < fixed || (arguments.size() - fixed) % 2 != 0)
    throw ConfigError("creepcontact-mesher is started by creepcontact, which meshes .geo files with it");
  MesherRequest request;
  request.file = arguments[0];
  request.dimension = number<int>(arguments[1]);
  request.order = number<int>(arguments[2]);
  request.memory_limit_mb = number<int>(arguments[3]);
  request.trusted = number<int>(arguments[4]) != 0;
  request.needs_confinement = number<int>(arguments[5]) != 0;
  for (std::size_t i = fixed; i < arguments.size(); i += 2) {
    if (!is_identifier(arguments[i]))
      throw ConfigError(fmt::format("'{}' is not the name of a constant", arguments[i]));
    request.parameters[arguments[i]] = number<double>(arguments[i + 1]);
  }
  return request;
}

}  // namespace creepcontact::io
