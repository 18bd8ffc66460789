/// [[supports]] and [temperature]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

struct Displacement {
  std::array<std::optional<Function>, 3> components;
  std::optional<Function> normal;
};

Value<Displacement> displacement_table() {
  const Value<Function> value = function(place_and_time);
  const auto component = [](std::size_t i) {
    return [i](Displacement& into) -> std::optional<Function>& { return into.components[i]; };
  };
  const auto keys = table<Displacement>({
      field<Displacement>("x", component(0), value, "displacement along x"),
      field<Displacement>("y", component(1), value, "displacement along y"),
      field<Displacement>("z", component(2), value, "displacement along z"),
      field<Displacement>("normal", &Displacement::normal, value, "displacement along the outward normal"),
  });
  return converted<Displacement>(
      keys, [](Displacement found, const Item& item, Context& context) -> std::optional<Displacement> {
        if (item.node->as_table()->empty()) {
          context.errors.add(item.location, "an empty table", "at least one of x, y, z, normal");
        }
        return found;
      });
}

struct SupportKeys : Support {
  Displacement prescribed;
};

}  // namespace

Value<Support> support_table() {
  const auto keys = table<SupportKeys>({
      field<SupportKeys>("on", &SupportKeys::on, reference("a physical surface, curve or point"), "what is held",
                         Presence::required),
      field<SupportKeys>("body", &SupportKeys::body, reference("the name of a body"), "only the nodes of this body"),
      field<SupportKeys>("displacement", &SupportKeys::prescribed, displacement_table(), "prescribed displacement",
                         Presence::required),
  });
  return converted<Support>(keys, [](SupportKeys found, const Item& item, Context&) -> std::optional<Support> {
    found.displacement = std::move(found.prescribed.components);
    found.normal = std::move(found.prescribed.normal);
    found.location = item.location;
    return Support(std::move(found));
  });
}

Value<Temperature> temperature_table() {
  const auto keys = table<Temperature>({
      field<Temperature>("value", &Temperature::value, function(place_and_time), "temperature of all bodies",
                         Presence::required),
  });
  return converted<Temperature>(keys, [](Temperature found, const Item& item, Context&) -> std::optional<Temperature> {
    found.location = item.location;
    return found;
  });
}

}  // namespace creepcontact::config
