/// [[springs]]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

Value<SpringCurve> spring_curve_table() {
  return written_inline(table<SpringCurve>({
      field<SpringCurve>("closure", &SpringCurve::closure, list(number()),
                         "by how much its ends have come closer: increasing", Presence::required)
          .in("length"),
      field<SpringCurve>("force", &SpringCurve::force, list(number()),
                         "forces, increasing: from 0 on if it does not pull, else from a negative one on",
                         Presence::required)
          .in("force"),
  }));
}

Value<std::array<std::array<double, 3>, 2>> two_points() {
  const auto point = triple(number());
  const std::string type = "two points, each [x, y, z]";
  Value<std::array<std::array<double, 3>, 2>> value{
      .type = type, .read = {}, .brief = "list of two `[x, y, z]`", .json = [json = point.json] {
        return schema_of_list(json(), 2);
      }};
  value.read = [point, type](const Item& item,
                             Context& context) -> std::optional<std::array<std::array<double, 3>, 2>> {
    const toml::array* array = item.node->as_array();
    if (!array || array->size() != 2) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    const auto found = list(point).read(item, context);
    if (!found) return std::nullopt;
    return std::array{(*found)[0], (*found)[1]};
  };
  value.visit = [point](const std::array<std::array<double, 3>, 2>& both, Visitor& to) {
    list(point).visit({both[0], both[1]}, to);
  };
  return value;
}

void check_spring(const Spring& given, const Item& item, Context& context) {
  const int places = (given.between ? 1 : 0) + (given.at ? 1 : 0) + (given.on.given() ? 1 : 0);
  if (places != 1)
    context.errors.add(item.location, places == 0 ? "no place" : "several places",
                       "one of 'between' (two surfaces), 'at' (two points), 'on' (a surface, with ground = true)");
  else if (given.on.given() != given.ground)
    context.errors.add(item.location, given.ground ? "'ground' without 'on'" : "'on' without 'ground'",
                       "on = \"surface\" with ground = true, or between = [\"first\", \"second\"]");
  if (given.stiffness.has_value() == given.curve.has_value())
    context.errors.add(item.location, given.curve ? "both 'stiffness' and 'curve'" : "no stiffness",
                       "one of 'stiffness' and 'curve'");
  if (given.direction == std::array<double, 3>{} && item.has("direction"))
    context.errors.add(item.child("direction").location, "[0, 0, 0]", "a direction");
}

}  // namespace

Value<Spring> spring_table(const Vocabulary& vocabulary) {
  const auto keys = table<Spring>({
      field<Spring>("name", &Spring::name, name("a name"), "unique name, used in messages and by probes",
                    Presence::required),
      field<Spring>("between", &Spring::between, two_surfaces(),
                    "the two surfaces whose mean displacements it connects, ..."),
      field<Spring>("at", &Spring::at, two_points(), "... or two points: the nodes next to them, ...").in("length"),
      field<Spring>("on", &Spring::on, reference("a physical surface, curve or point"),
                    "... or, with `ground`, the group that it carries, by its mean displacement"),
      field<Spring>("ground", &Spring::ground, boolean(), "its first end does not move"),
      field<Spring>("direction", &Spring::direction, triple(number()),
                    "along which it acts, from its first end to its second one, of any length", Presence::required),
      field<Spring>("stiffness", &Spring::stiffness, number(greater(0)), "force per closure; it also pulls")
          .otherwise("required without `curve`")
          .in("force/length"),
      field<Spring>("curve", &Spring::curve, spring_curve_table(),
                    "force over closure, as of disc springs; the last slope goes on"),
      field<Spring>("preload", &Spring::preload, number(), "its force where nothing has moved, in the meshes as drawn")
          .in("force"),
      field<Spring>("creep", &Spring::creep, laws_elsewhere(vocabulary),
                    "creep laws that act together, of its closure under its force as stress")
          .otherwise("none"),
  });
  return converted<Spring>(keys, [](Spring given, const Item& item, Context& context) {
    given.location = item.location;
    check_spring(given, item, context);
    return std::optional(std::move(given));
  });
}

}  // namespace creepcontact::config
