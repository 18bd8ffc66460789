/// [[loads]]: one kind each, and the place that this kind acts on

#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

#include "creepcontact/base/overload.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

/// What a configuration says of one kind of load.
template <class Kind>
struct KindKey {
  std::string name;
  std::vector<std::string> places;  ///< keys, one of which it needs
  Value<Kind> value;
  std::string description;
  std::string dimension = {};
};

/// A kind that is written as its value alone.
template <class Kind, class T>
Value<Kind> only_value(const Value<T>& value) {
  return converted<Kind>(
      value,
      [](T found, const Item&, Context&) {
        Kind kind;
        kind.value = std::move(found);
        return std::optional(std::move(kind));
      },
      [](const Kind& kind) -> const T& { return kind.value; });
}

Value<std::array<Function, 3>> vector() {
  return triple(function(position_and_time));
}

KindKey<Pressure> key_of(std::type_identity<Pressure>) {
  return {"pressure",
          {"on"},
          only_value<Pressure>(function(position_and_time)),
          "with `on`: normal force per area, positive if it pushes against the body",
          "stress"};
}

KindKey<Traction> key_of(std::type_identity<Traction>) {
  return {"traction", {"on"}, only_value<Traction>(vector()), "with `on`: force per area", "stress"};
}

KindKey<PointForce> key_of(std::type_identity<PointForce>) {
  return {"force", {"at", "node"}, only_value<PointForce>(vector()), "with `at` or `node`: force at the node", "force"};
}

KindKey<BodyForce> key_of(std::type_identity<BodyForce>) {
  return {"body_force", {"body"}, only_value<BodyForce>(vector()), "with `body`: force per volume", "force/volume"};
}

KindKey<Rotation> key_of(std::type_identity<Rotation>) {
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
  const auto checked =
      converted<Rotation>(keys, [](Rotation found, const Item& item, Context& context) -> std::optional<Rotation> {
        if (found.axis == std::array<double, 3>{})
          context.errors.add(item.child("axis").location, "[0, 0, 0]", "a direction");
        return found;
      });
  return {"rotation", {"body"}, checked, "with `body`: centrifugal force"};
}

template <class Variant>
struct OptionalEach;
template <class... Kinds>
struct OptionalEach<std::variant<Kinds...>> {
  using Type = std::tuple<std::optional<Kinds>...>;
};
using GivenKinds = OptionalEach<decltype(Load::kind)>::Type;

struct LoadKeys {
  Reference on, body;
  std::optional<std::array<double, 3>> at;
  std::optional<double> tolerance;
  std::optional<int> node;
  GivenKinds kinds;  ///< one of them
};

/// Where a kind of load acts.
struct KindPlaces {
  std::string name;
  std::vector<std::string> places;
};

/// Calls `work` with the key of every kind, in the order of the variant.
template <class Work>
void for_each_kind(const Work& work) {
  const auto all = []<class... Kinds>(std::type_identity<std::variant<Kinds...>>, const Work& call) {
    (call(key_of(std::type_identity<Kinds>())), ...);
  };
  all(std::type_identity<decltype(Load::kind)>(), work);
}

std::vector<KindPlaces> places_of_kinds() {
  std::vector<KindPlaces> all;
  for_each_kind([&](const auto& key) { all.push_back({key.name, key.places}); });
  return all;
}

/// Checks the place of a load. "body" together with another place restricts the load to that body.
void check_place(const Item& item, const KindPlaces& kind, Context& context) {
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

/// Places that belong to one kind alone.
void take_place(decltype(Load::kind)& kind, const LoadKeys& keys) {
  std::visit(Overload{[](Pressure&) {}, [](Traction&) {},
                      [&](PointForce& force) {
                        force.at = keys.at;
                        force.tolerance = keys.tolerance;
                        force.node = keys.node.value_or(0);
                      },
                      [](BodyForce&) {}, [](Rotation&) {}},
             kind);
}

std::optional<Load> make_load(LoadKeys keys, const std::vector<KindPlaces>& kinds, const Item& item, Context& context) {
  std::vector<std::string> names;
  for (const KindPlaces& kind : kinds) names.push_back(kind.name);
  const std::vector<std::string> given = given_keys(item, names);
  if (given.size() != 1) {
    context.errors.add(item.location,
                       given.empty() ? "no load" : fmt::format("several loads: {}", fmt::join(given, ", ")),
                       fmt::format("exactly one of {}", fmt::join(names, ", ")));
    return std::nullopt;
  }
  check_place(item, *std::ranges::find(kinds, given.front(), &KindPlaces::name), context);
  Load load{keys.on, keys.body, {}, item.location};
  const auto take = [&](auto& kind) {
    if (kind) load.kind = std::move(*kind);
  };
  std::apply([&](auto&... kind) { (take(kind), ...); }, keys.kinds);
  take_place(load.kind, keys);
  return load;
}

LoadKeys keys_of_load(const Load& load) {
  LoadKeys keys{load.on, load.body, {}, {}, {}, {}};
  std::visit([&]<class Kind>(const Kind& kind) { std::get<std::optional<Kind>>(keys.kinds) = kind; }, load.kind);
  if (const auto& force = std::get<std::optional<PointForce>>(keys.kinds)) {
    keys.at = force->at;
    keys.tolerance = force->tolerance;
    if (!force->at) keys.node = force->node;
  }
  return keys;
}

}  // namespace

Value<Load> load_table() {
  std::vector<Field<LoadKeys>> fields{
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
  };
  for_each_kind([&]<class Kind>(const KindKey<Kind>& key) {
    const auto member = [](auto& keys) -> auto& {
      return std::get<std::optional<Kind>>(keys.kinds);
    };
    fields.push_back(field<LoadKeys>(key.name, member, key.value, key.description).in(key.dimension));
  });
  return converted<Load>(
      table<LoadKeys>(fields),
      [kinds = places_of_kinds()](LoadKeys keys, const Item& item, Context& context) {
        return make_load(std::move(keys), kinds, item, context);
      },
      keys_of_load);
}

}  // namespace creepcontact::config
