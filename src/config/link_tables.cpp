/// [[cyclic]], [[rigid]] and [[equations]]

#include <set>

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

using Components = std::array<std::optional<Function>, 3>;

Value<Components> components(const std::string& what, const std::string& unit) {
  const auto component = [](std::size_t i) {
    return [i](auto& into) -> auto& {
      return into[i];
    };
  };
  const Value<Function> value = function({"t"});
  return written_inline(table<Components>({
      field<Components>("x", component(0), value, what + " x").in(unit),
      field<Components>("y", component(1), value, what + " y").in(unit),
      field<Components>("z", component(2), value, what + " z").in(unit),
  }));
}

/// The components of displacement and rotation together.
Value<Rigid> all_components() {
  const Value<Function> value = function({"t"});
  std::vector<Field<Rigid>> fields;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    fields.push_back(field<Rigid>(
                         axis, [i](auto& rigid) -> auto& { return rigid.displacement[i]; }, value,
                         "displacement of the origin along " + axis)
                         .in("length"));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    fields.push_back(field<Rigid>(
        "r" + axis, [i](auto& rigid) -> auto& { return rigid.rotation[i]; }, value,
        "small rotation in radians about " + axis));
  }
  return written_inline(table<Rigid>(fields));
}

/// Another way to write what other keys have; a file that is written has those.
Field<Rigid> only_read(Field<Rigid> key) {
  key.visit = [](const Field<Rigid>&, const Rigid&, Visitor&) {};
  return key;
}

/// Both in one table, which leaves the other keys alone.
Field<Rigid> motion_field() {
  const Value<Rigid> components = all_components();
  Field<Rigid> made = only_read(field<Rigid>(
                                    "motion", [](auto& rigid) -> auto& { return rigid; }, components,
                                    "`displacement` (x, y, z) and `rotation` (rx, ry, rz) in one table")
                                    .otherwise("those"));
  made.read = [read = components.read](const Item& item, Context& context, Rigid& into) {
    if (const std::optional<Rigid> found = read(item, context)) {
      into.displacement = found->displacement;
      into.rotation = found->rotation;
    }
  };
  return made;
}

}  // namespace

Value<Cyclic> cyclic_table() {
  const auto keys = table<Cyclic>({
      field<Cyclic>("between", &Cyclic::between, two_surfaces(),
                    "the two faces of the sector; the second is the first, turned about the axis by `angle`",
                    Presence::required),
      field<Cyclic>("axis", &Cyclic::axis, triple(number()), "direction of the axis, of any length"),
      field<Cyclic>("origin", &Cyclic::origin, triple(number()), "a point of the axis").in("length"),
      field<Cyclic>("angle", &Cyclic::angle, number({.min = 0, .max = 180, .open_min = true}),
                    "angle of the sector in degrees, counter-clockwise about the axis; 360 divided by a whole number",
                    Presence::required),
  });
  return converted<Cyclic>(keys, [](Cyclic found, const Item& item, Context& context) -> std::optional<Cyclic> {
    found.location = item.location;
    if (found.axis == std::array<double, 3>{})
      context.errors.add(item.child("axis").location, "[0, 0, 0]", "a direction");
    const double sectors = found.angle > 0 ? 360 / found.angle : 0;
    if (found.angle > 0 && std::abs(sectors - std::round(sectors)) > 1e-6 * sectors)
      context.errors.add(item.child("angle").location, fmt::format("{:.10g} sectors in a full circle", sectors),
                         "360 divided by a whole number");
    return found;
  });
}

/// [[rigid]] and [[coupling]]. @param on  what the key `on` means
Value<Rigid> motion_table(const std::string& on) {
  const Value<std::array<Function, 3>> vector = triple(function({"t"}));
  const auto keys = table<Rigid>({
      field<Rigid>("on", &Rigid::on, one_or_more("a physical surface, curve or point"), on, Presence::required),
      field<Rigid>("origin", &Rigid::origin, triple(number()),
                   "point that `displacement`, `force` and `moment` refer to")
          .in("length")
          .otherwise("the mean position of the nodes"),
      only_read(field<Rigid>("reference", &Rigid::origin, triple(number()), "another word for `origin`")
                    .in("length")
                    .otherwise("not given: see origin")),
      field<Rigid>("displacement", &Rigid::displacement, components("displacement of the origin along", "length"),
                   "prescribed displacement; components that are not given are free"),
      field<Rigid>("rotation", &Rigid::rotation, components("small rotation in radians about", ""),
                   "prescribed rotation; components that are not given are free"),
      motion_field(),
      field<Rigid>("force", &Rigid::force, vector, "resultant force at the origin").in("force"),
      field<Rigid>("moment", &Rigid::moment, vector, "resultant moment about the origin"),
  });
  return converted<Rigid>(keys, [](Rigid found, const Item& item, Context& context) -> std::optional<Rigid> {
    found.location = item.location;
    if (item.has("origin") && item.has("reference"))
      context.errors.add(item.child("reference").location, "'origin' is given, too", "one of origin, reference");
    for (const std::string& key : given_keys(item, {"displacement", "rotation"}))
      if (item.has("motion"))
        context.errors.add(item.child(key).location, "'motion' is given, too",
                           "either motion, or displacement and rotation");
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string axis(1, "xyz"[k]);
      if (found.displacement[k] && !found.force[k].is_zero())
        context.errors.add(item.child("force").location, fmt::format("the displacement along {} is prescribed", axis),
                           "either the displacement or the force");
      if (found.rotation[k] && !found.moment[k].is_zero())
        context.errors.add(item.child("moment").location, fmt::format("the rotation about {} is prescribed", axis),
                           "either the rotation or the moment");
    }
    return found;
  });
}

Value<Rigid> rigid_table() {
  return motion_table("surfaces that move as one rigid body; they may be of several bodies");
}

Value<Rigid> coupling_table() {
  return motion_table(
      "surfaces whose mean motion, weighted by areas, follows the reference point: a force or a moment there is "
      "distributed, and they deform freely");
}

Value<Equation> equation_table() {
  using Term = Equation::Term;
  const auto coefficient = [](std::size_t k) {
    return [k](auto& term) -> auto& {
      return term.coefficient[k];
    };
  };
  const auto term = converted<Term>(
      table<Term>({
          field<Term>("node", &Term::node, integer(1), "number of the node in the mesh file", Presence::required),
          field<Term>("x", coefficient(0), number(), "coefficient of its displacement along x"),
          field<Term>("y", coefficient(1), number(), "coefficient of its displacement along y"),
          field<Term>("z", coefficient(2), number(), "coefficient of its displacement along z"),
      }),
      [](Term found, const Item& item, Context& context) -> std::optional<Term> {
        if (found.coefficient == std::array<double, 3>{})
          context.errors.add(item.location, "no coefficient other than 0", "at least one of x, y, z");
        return found;
      });
  const auto keys = table<Equation>({
      field<Equation>("terms", &Equation::terms, written_inline(list(term)), "the terms of the sum, one per node",
                      Presence::required),
      field<Equation>("value", &Equation::value, function({"t"}), "what the sum is equal to").in("length"),
  });
  return converted<Equation>(keys, [](Equation found, const Item& item, Context& context) -> std::optional<Equation> {
    found.location = item.location;
    if (found.terms.empty()) context.errors.add(item.child("terms").location, "an empty list", "at least one term");
    std::set<int> nodes;
    for (const Equation::Term& one : found.terms)
      if (!nodes.insert(one.node).second)
        context.errors.add(item.child("terms").location, fmt::format("node {} has two terms", one.node),
                           "one term per node");
    return found;
  });
}

}  // namespace creepcontact::config
