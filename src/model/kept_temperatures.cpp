#include "kept_temperatures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/temperatures/kept_arrays.hpp"

namespace creepcontact::model {
namespace {

class HeatLines {
 public:
  void add(const std::string& item, const std::string& value) {
    std::string line = fmt::format("{}\t{}", item, value);
    std::ranges::replace(line, '\n', ' ');
    text += line + '\n';
  }
  void add(const std::string& item, const Checksum& sum) { add(item, fmt::format("checksum {:016x}", sum.value())); }
  std::string text;
};

void add_body(const heat::Conductor& body, HeatLines& lines) {
  Checksum sum;
  for (const Vector3& node : body.mesh->nodes) sum.add(node.data(), 3);
  for (const mesh::CellBlock& block : body.mesh->blocks) {
    sum.add(&block.type, 1);
    sum.add(block.connectivity.data(), block.connectivity.size());
  }
  const std::string of = fmt::format("of body '{}'", body.name);
  lines.add("mesh " + of, sum);
  const mesh::Section& section = body.mesh->section;
  lines.add("section " + of, fmt::format("{} {:.17g}", static_cast<int>(section.analysis), section.thickness));
  lines.add("conductivity " + of, texts(body.conductivity));
  if (body.axes)
    for (const auto& [axis, functions] : {std::pair{"axis 1 ", body.axes->first}, {"axis 2 ", body.axes->second}})
      lines.add(axis + of, texts({functions.begin(), functions.end()}));
  lines.add("heat capacity " + of, body.capacity.text());
  lines.add("density " + of, fmt::format("{:.17g}", body.density));
}

void add(Checksum& sum, const contact::ShapeValues& shapes) {
  for (const double value : shapes) sum.add(&value, 1);
}

void add_interface(const heat::Interface& interface, HeatLines& lines) {
  Checksum sum;
  for (const contact::FacingFaces& faces : interface.faces) {
    sum.add(faces.first_nodes.data(), faces.first_nodes.size());
    sum.add(faces.second_nodes.data(), faces.second_nodes.size());
    sum.add(&faces.size, 1);
    for (const contact::FacingFaces::Point& point : faces.points) {
      sum.add(point.position.data(), 3);
      sum.add(&point.area, 1);
      add(sum, point.first);
      add(sum, point.second);
    }
  }
  const std::string of = fmt::format("of contact '{}'", interface.name);
  lines.add("faces " + of, sum);
  lines.add("conductance " + of, fmt::format("{}{}, bodies {} {}", interface.is_perfect ? "perfect " : "",
                                             interface.conductance.text(), interface.first, interface.second));
}

std::unordered_map<std::string, std::string> entries(const std::string& fingerprint) {
  std::unordered_map<std::string, std::string> result;
  std::istringstream lines(fingerprint);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t end = std::min(line.find('\t'), line.size());
    result[line.substr(0, end)] = line.substr(std::min(end + 1, line.size()));
  }
  return result;
}

/// The first difference in words.
std::string difference(const std::string& before, const std::string& now) {
  const auto old = entries(before);
  std::istringstream lines(now);
  for (std::string line; std::getline(lines, line);) {
    const std::string item = line.substr(0, line.find('\t')), value = line.substr(item.size() + 1);
    const auto found = old.find(item);
    if (found == old.end()) return fmt::format("{} is new", item);
    if (found->second != value) return fmt::format("{} was {:.80} and is now {:.80}", item, found->second, value);
  }
  return "something is missing now";
}

using Arrays = std::vector<std::vector<double>>;

/// Times, kinks, number of steps and period, and at each time the values and the rates before and after it.
Arrays arrays_of(const heat::History& history) {
  Arrays result{history.times, history.kinks, {static_cast<double>(history.n_steps), history.period.value_or(0)}};
  for (const auto* all : {&history.values, &history.rates_before, &history.rates_after})
    result.insert(result.end(), all->begin(), all->end());
  return result;
}

heat::History history_of(Arrays arrays, std::size_t n_unknowns) {
  constexpr std::size_t first = 3;
  const auto require = [](bool holds) {
    if (!holds) throw ConfigError("its arrays are not those of temperatures");
  };
  require(arrays.size() >= first && arrays[2].size() == 2);
  heat::History result;
  result.times = std::move(arrays[0]);
  result.kinks = std::move(arrays[1]);
  result.n_steps = static_cast<long>(arrays[2][0]);
  if (const double period = arrays[2][1]; period > 0) result.period = period;
  const std::size_t n = result.times.size();
  require(n > 0 && result.times.front() == 0 && arrays.size() == first + 3 * n);
  require(std::ranges::adjacent_find(result.times, std::greater_equal<>()) == result.times.end());
  require(std::ranges::all_of(result.kinks, [&](double t) {
    return t > result.times.back() ? result.period.has_value() : std::ranges::binary_search(result.times, t);
  }));
  std::size_t next = first;
  for (auto* all : {&result.values, &result.rates_before, &result.rates_after})
    for (std::size_t k = 0; k < n; ++k, ++next) {
      require(arrays[next].size() == n_unknowns);
      all->push_back(std::move(arrays[next]));
    }
  return result;
}

}  // namespace

std::string heat_fingerprint(const heat::Definition& definition, const std::string& rest) {
  HeatLines lines;
  lines.add("version", CREEPCONTACT_VERSION);
  for (const heat::Conductor& body : definition.bodies) add_body(body, lines);
  for (std::size_t i = 0; i < definition.flows.size(); ++i) {
    const heat::SurfaceFlow& flow = definition.flows[i];
    Checksum sum;
    for (const mesh::Face& face : flow.faces) sum.add(face.nodes.data(), face.nodes.size());
    const std::string of = fmt::format("of the {} ({})", flow.name, i + 1);
    lines.add("surface " + of, sum);
    lines.add(flow.kind == heat::SurfaceFlow::Kind::flux ? "value " + of : "coefficient " + of, flow.factor.text());
    lines.add("temperature beyond " + of, flow.beyond.text());
  }
  for (std::size_t i = 0; i < definition.sources.size(); ++i)
    lines.add(fmt::format("value of the {} ({})", definition.sources[i].name, i + 1),
              definition.sources[i].value.text());
  for (std::size_t i = 0; i < definition.point_flows.size(); ++i) {
    const heat::PointFlow& flow = definition.point_flows[i];
    std::string nodes;
    for (const heat::BodyNode& node : flow.nodes) nodes += fmt::format(" {}:{}", node.body, node.node);
    lines.add(fmt::format("{} ({})", flow.name, i + 1), fmt::format("{}, nodes{}", flow.value.text(), nodes));
  }
  for (std::size_t i = 0; i < definition.given.size(); ++i) {
    const heat::GivenTemperature& given = definition.given[i];
    Checksum sum;
    sum.add(given.nodes.data(), given.nodes.size());
    lines.add(fmt::format("nodes of the {} ({})", given.name, i + 1), sum);
    lines.add(fmt::format("value of the {} ({})", given.name, i + 1), given.value.text());
  }
  for (const heat::Interface& interface : definition.interfaces) add_interface(interface, lines);
  Checksum equal;
  for (const auto& [a, b] : definition.equal) {
    for (const heat::BodyNode& node : {a, b}) {
      equal.add(&node.body, 1);
      equal.add(&node.node, 1);
    }
  }
  lines.add("nodes of one temperature", equal);
  lines.add("time_unit", fmt::format("{:.17g}", definition.time_unit));
  lines.add("absolute_zero", fmt::format("{:.17g}", definition.absolute_zero));
  return lines.text + rest;
}

std::optional<heat::History> read_kept(const std::filesystem::path& path, const std::string& fingerprint,
                                       std::size_t n_unknowns) {
  if (!path_exists(path)) return std::nullopt;
  try {
    io::KeptArrays kept = io::read_kept_arrays(path);
    if (kept.fingerprint != fingerprint) throw ConfigError(difference(kept.fingerprint, fingerprint));
    heat::History history = history_of(std::move(kept.arrays), n_unknowns);
    log::info("heat: the temperatures are those of '{}'", path.string());
    return history;
  } catch (const io::OtherFile& error) {
    throw ModelError(
        fmt::format("keep: '{}' would be replaced, but {}; give another name", path.string(), error.what()));
  } catch (const ConfigError& error) {
    log::info("heat: '{}' is of no use and will be replaced: {}", path.string(), error.what());
    return std::nullopt;
  }
}

void write_kept(const std::filesystem::path& path, const std::string& fingerprint, const heat::History& history) {
  try {
    io::write_kept_arrays(path, {fingerprint, arrays_of(history)});
  } catch (const Error& error) {
    log::warning("heat: the temperatures are not kept: {}", error.what());
  }
}

}  // namespace creepcontact::model
