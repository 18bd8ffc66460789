/// [[loads]]: one kind each, and the place that this kind acts on

#include <fmt/ranges.h>

#include <algorithm>

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

using Functions3 = std::array<Function, 3>;

struct LoadKeys {
  Reference on, body;
  std::optional<std::array<double, 3>> at;
  std::optional<double> tolerance;
  std::optional<int> node;
  std::optional<Function> pressure;
  std::optional<Functions3> traction, force, body_force;
  std::optional<Rotation> rotation;
};

/// Where a kind of load acts.
struct Kind {
  std::string name;
  std::vector<std::string> places;  ///< keys, one of which it needs
};
const std::vector<Kind> kinds{{"pressure", {"on"}},
                              {"traction", {"on"}},
                              {"force", {"at", "node"}},
                              {"body_force", {"body"}},
                              {"rotation", {"body"}}};

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  names.reserve(kinds.size());
  for (const Kind& kind : kinds) names.push_back(kind.name);
  return names;
}

/// "body" beside another place restricts the load to that body.
void check_place(const Item& item, const Kind& kind, Context& context) {
  const std::string needed = fmt::format("'{}'", fmt::join(kind.places, "' or '"));
  const std::vector<std::string> own = given_keys(item, kind.places);
  if (own.size() != 1)
    context.errors.add(item.location,
                       own.empty() ? fmt::format("'{}' without {}", kind.name, needed)
                                   : fmt::format("'{}' with '{}'", kind.name, fmt::join(own, "' and '")),
                       fmt::format("'{}' with {}", kind.name, needed));
  for (const std::string& key : given_keys(item, {"on", "at", "node"}))
    if (std::ranges::find(kind.places, key) == kind.places.end())
      context.errors.add(item.child(key).location, fmt::format("'{}' with '{}'", kind.name, key),
                         fmt::format("'{}' with {}", kind.name, needed));
  if (item.has("tolerance") && !item.has("at"))
    context.errors.add(item.child("tolerance").location, "has no meaning here", "with 'at' only");
}

std::optional<Load> make_load(LoadKeys keys, const Item& item, Context& context) {
  const std::vector<std::string> given = given_keys(item, kind_names());
  if (given.size() != 1) {
    context.errors.add(item.location,
                       given.empty() ? "no load" : fmt::format("several loads: {}", fmt::join(given, ", ")),
                       fmt::format("exactly one of {}", fmt::join(kind_names(), ", ")));
    return std::nullopt;
  }
  for (const Kind& kind : kinds) {
    if (kind.name == given.front()) check_place(item, kind, context);
  }
  Load load{std::move(keys.on), std::move(keys.body), {}, item.location};
  if (keys.pressure) load.kind = Pressure{*keys.pressure};
  if (keys.traction) load.kind = Traction{*keys.traction};
  if (keys.force) load.kind = PointForce{keys.at, keys.tolerance, keys.node.value_or(0), *keys.force};
  if (keys.body_force) load.kind = BodyForce{*keys.body_force};
  if (keys.rotation) load.kind = *keys.rotation;
  return load;
}

Value<Rotation> rotation_table() {
  const auto keys = written_inline(table<Rotation>({
      field<Rotation>("axis", &Rotation::axis, triple(number()), "direction of the axis, of any length"),
      field<Rotation>("origin", &Rotation::origin, triple(number()), "a point of the axis").in("length"),
      field<Rotation>("angular_velocity", &Rotation::angular_velocity, function({"t"}),
                      "in radians per unit of time; the unit of time is the one in which mass x length / time^2 gives "
                      "the unit of force: rad/s with tonne, mm and N, whatever the unit of `t`",
                      Presence::required)
          .in("1/time"),
      field<Rotation>("density", &Rotation::density, function(position_and_time, at_least(0)), "mass per volume",
                      Presence::required)
          .in("mass/volume"),
  }));
  return converted<Rotation>(keys, [](Rotation found, const Item& item, Context& context) -> std::optional<Rotation> {
    if (found.axis == std::array<double, 3>{}) {
      context.errors.add(item.child("axis").location, "[0, 0, 0]", "a direction");
    }
    return found;
  });
}

}  // namespace

Value<Load> load_table() {
  const Value<Functions3> vector = triple(function(position_and_time));
  const auto keys = table<LoadKeys>({
      field<LoadKeys>(
          "on", &LoadKeys::on, reference("a physical surface"),
          "surface on which `pressure` or `traction` acts: on every body with this surface, or only on `body`"),
      field<LoadKeys>("at", &LoadKeys::at, triple(number()),
                      "point at which `force` acts; it is applied to the nearest mesh node")
          .in("length"),
      field<LoadKeys>("tolerance", &LoadKeys::tolerance, number(greater(0)),
                      "largest allowed distance from `at` to that node")
          .changeable()
          .in("length")
          .otherwise("1e-6 of the model's size"),
      field<LoadKeys>("node", &LoadKeys::node, integer(1), "or: number in the mesh file of the node at which it acts"),
      field<LoadKeys>("body", &LoadKeys::body, reference("the name of a body"),
                      "body on which `body_force` or `rotation` acts; with `on`, `at` or `node`: load only this body"),
      field<LoadKeys>("pressure", &LoadKeys::pressure, function(position_and_time),
                      "with `on`: normal force per area, positive if it pushes against the body")
          .in("stress"),
      field<LoadKeys>("traction", &LoadKeys::traction, vector, "with `on`: force per area").in("stress"),
      field<LoadKeys>("force", &LoadKeys::force, vector, "with `at` or `node`: force at the node").in("force"),
      field<LoadKeys>("body_force", &LoadKeys::body_force, vector, "with `body`: force per volume").in("force/volume"),
      field<LoadKeys>("rotation", &LoadKeys::rotation, rotation_table(), "with `body`: centrifugal force"),
  });
  return converted<Load>(keys, make_load);
}

}  // namespace creepcontact::config
