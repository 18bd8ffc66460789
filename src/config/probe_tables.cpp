/// [[probes]] and [[events]]

#include <fmt/ranges.h>

#include <stdexcept>

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

Value<std::string> quantity_name(const std::vector<Quantity>& quantities) {
  std::vector<std::string> names;
  names.reserve(quantities.size());
  for (const Quantity& quantity : quantities) names.push_back(quantity.name);
  const std::string type = "a quantity; see `creepcontact list quantities`";
  Value<std::string> value = text();
  value.type = type;
  value.words = words_of(names);
  value.json = [names] { return schema_of_words(names); };
  value.read = [=](const Item& item, Context& context) -> std::optional<std::string> {
    auto found = name(type).read(item, context);
    if (!found || std::find(names.begin(), names.end(), *found) != names.end()) return found;
    context.errors.add_unknown(item.location, fmt::format("unknown quantity '{}'", *found), *found, names, type);
    return std::nullopt;
  };
  return value;
}

/// Heads a column of history.csv.
Value<std::string> column_name() {
  const std::string type = "a name without comma, quotation mark or line break, other than 'time'";
  return converted<std::string>(
      name(type), [type](std::string found, const Item& item, Context& context) -> std::optional<std::string> {
        if (found != "time" && found.find_first_of(",\"\r\n") == std::string::npos) return found;
        context.errors.add(item.location, fmt::format("'{}'", found), type);
        return std::nullopt;
      });
}

/// A condition on the position: true where it is not 0.
Value<Function> part() {
  const std::string type = "a condition on x, y, z, as in \"x*x + z*z < 40^2 && y > 0\"";
  return converted<Function>(
      name(type),
      [type](const std::string& found, const Item& item, Context& context) -> std::optional<Function> {
        try {
          Function condition = Function::expression(found, {"x", "y", "z"});
          if (!condition.is_constant()) return condition;
          context.errors.add(item.location, fmt::format("'{}' is the same everywhere", found), type);
        } catch (const std::invalid_argument& error) {
          context.errors.add(item.location, error.what(), type);
        }
        return std::nullopt;
      },
      [](const Function& condition) -> const std::string& { return condition.text(); });
}

Value<SectionPlane> section_plane() {
  return written_inline(converted<SectionPlane>(
      table<SectionPlane>({
          field<SectionPlane>("origin", &SectionPlane::origin, triple(number()), "a point of the plane",
                              Presence::required)
              .in("length"),
          field<SectionPlane>("normal", &SectionPlane::normal, triple(number()),
                              "its normal, of any length: the force is that of the material on this side on the rest",
                              Presence::required),
      }),
      [](SectionPlane plane, const Item& item, Context& context) -> std::optional<SectionPlane> {
        const Item normal = item.child("normal");
        if (normal.node && normal.node->is_array() && plane.normal == std::array<double, 3>{}) {
          // a wrong one has been reported, and is zero too
          const toml::array& numbers = *normal.node->as_array();
          const bool is_zero = std::ranges::all_of(
              numbers, [](const toml::node& one) { return one.value<double>().value_or(1.0) == 0; });
          if (is_zero && numbers.size() == 3) context.errors.add(normal.location, "[0, 0, 0]", "a direction");
        }
        return plane;
      }));
}

void check_place(const Item& item, Context& context) {
  const bool on = item.has("on"), at = item.has("at"), body = item.has("body");
  if (on && at) {
    context.errors.add(item.location, "both 'on' and 'at'", "'on', 'at', or 'body' alone");
  } else if (!on && !at && !body) {
    context.errors.add(item.location, "no place: none of 'on', 'at' and 'body'", "'on', 'at', or 'body'");
  }
  if (!at || on) return;
  for (const std::string& key : given_keys(item, {"reduce", "where"}))
    context.errors.add(item.child(key).location, "has no meaning at a point", "with 'on' or 'body' alone");
}

void check_axis(const Probe& probe, const Quantity& quantity, const std::vector<Quantity>& all, const Item& item,
                Context& context) {
  if (item.has("axis") && probe.axis == std::array<double, 3>{})
    context.errors.add(item.child("axis").location, "[0, 0, 0]", "a direction");
  if (quantity.cylindrical) return;
  std::vector<std::string> names;
  for (const Quantity& one : all)
    if (one.cylindrical) names.push_back(one.name);
  for (const std::string& key : given_keys(item, {"axis", "origin"})) {
    if (quantity.moment && key == "origin") continue;
    context.errors.add(item.child(key).location,
                       fmt::format("has no meaning for '{}', which is not a cylindrical component", quantity.name),
                       fmt::format("with {}", fmt::join(names, ", ")));
  }
}

void check_quantity(Probe& probe, const Quantity& quantity, const Item& item, Context& context) {
  if (quantity.surface_only && (item.has("at") || !item.has("on"))) {
    context.errors.add(item.child("quantity").location, fmt::format("'{}' at a point or in a body", quantity.name),
                       fmt::format("'{}' on a surface: 'on'", quantity.name));
  }
  if (quantity.body_only && (item.has("at") || item.has("on"))) {
    context.errors.add(item.child("quantity").location, fmt::format("'{}' at a point or over a group", quantity.name),
                       fmt::format("'{}' of a body: 'body' alone", quantity.name));
  }
  if (quantity.body_only && item.has("reduce"))
    context.errors.add(item.child("reduce").location, fmt::format("'{}' is one value per body", quantity.name),
                       "without 'reduce'");
  if (quantity.body_only && item.has("where"))
    context.errors.add(item.child("where").location, fmt::format("'{}' is one value per body", quantity.name),
                       "without 'where'");
  if (quantity.section && !item.has("section"))
    context.errors.add(item.location, fmt::format("'{}' without 'section'", quantity.name),
                       "the plane: section = { origin = [x, y, z], normal = [x, y, z] }");
  if (!quantity.section && item.has("section"))
    context.errors.add(item.child("section").location, fmt::format("has no meaning for '{}'", quantity.name),
                       "with section_force_x|y|z and section_moment_x|y|z");
  if (!quantity.sum_only) return;
  if (item.has("reduce") && probe.reduce != Reduce::sum) {
    context.errors.add(item.child("reduce").location, describe(*item.child("reduce").node),
                       fmt::format("\"sum\" with '{}'", quantity.name));
  }
  probe.reduce = Reduce::sum;
}

/// Keys that a probe of other probes does not have.
void check_expression(const Item& item, Context& context) {
  for (const std::string& key :
       given_keys(item, {"quantity", "on", "at", "body", "where", "reduce", "axis", "origin", "section"}))
    context.errors.add(item.child(key).location, "has no meaning with 'expression'",
                       "the probes that the expression names; or this probe without 'expression'");
}

}  // namespace

Value<Probe> probe_table(const Vocabulary& vocabulary) {
  const auto reduce = choice<Reduce>("reduction");
  const auto is = [all = vocabulary.quantities](auto property) {
    return [all, property](const Probe& probe) {
      const auto found = std::ranges::find(all, probe.quantity, &Quantity::name);
      return found != all.end() && property(*found);
    };
  };
  const auto keys = table<Probe>({
      field<Probe>("name", &Probe::name, column_name(), "heading of its column in `history.csv`; unique",
                   Presence::required),
      field<Probe>("quantity", &Probe::quantity, quantity_name(vocabulary.quantities),
                   "quantity to record; required without `expression`"),
      field<Probe>("on", &Probe::on, reference("a physical surface, curve or point"), "record over this group, ..."),
      field<Probe>("at", &Probe::at, triple(number()), "... or at this point of the undeformed body, ...").in("length"),
      field<Probe>("body", &Probe::body, reference("the name of a body"),
                   "... or, without `on` and `at`, over this whole body; with `on` or `at`: only in this body"),
      field<Probe>("where", &Probe::where, part(),
                   "only the part of the group or body where this condition on x, y, z of the undeformed body holds, "
                   "such as `\"x*x + z*z < 40^2 && y > 0\"`"),
      field<Probe>("reduce", &Probe::reduce, reduce,
                   "how the values over a group or body become one: `\"mean\"` is weighted by area or volume, "
                   "`\"sum\"` is the integral; areas and forces allow only `\"sum\"`")
          .only_if(is([](const Quantity& quantity) { return !quantity.body_only; })),
      field<Probe>(
          "axis", &Probe::axis, triple(number()),
          "direction of the axis of cylindrical components (`stress_r`, `stress_theta`, `stress_rtheta`), of any "
          "length; in an axisymmetric model always y")
          .only_if(is([](const Quantity& quantity) { return quantity.cylindrical; })),
      field<Probe>(
          "origin", &Probe::origin, triple(number()),
          "a point of that axis; with `contact_moment_x|y|z` and `section_moment_x|y|z` the point that moments "
          "refer to, by default the `origin` of the `section`")
          .in("length")
          .needed_if([](const Probe& probe) { return probe.section.has_value(); })
          .only_if(is([](const Quantity& quantity) { return quantity.cylindrical || quantity.moment; })),
      field<Probe>("section", &Probe::section, section_plane(),
                   "the plane of `section_force_x|y|z` and `section_moment_x|y|z`, through the body `body`"),
      field<Probe>("expression", &Probe::expression, reference("an expression of names of probes and t"),
                   "instead of a quantity: a value computed from other probes, by their names, and t"),
      field<Probe>("scale", &Probe::scale, number(), "factor on the value"),
      field<Probe>("unit", &Probe::unit, text(), "unit of the value, shown in tables and plots")
          .otherwise("that of the quantity, as `units` names it; none with `scale` or `expression`"),
  });
  return converted<Probe>(keys, [=](Probe probe, const Item& item, Context& context) -> std::optional<Probe> {
    probe.location = item.location;
    if (item.has("expression")) {
      check_expression(item, context);
      return probe;
    }
    if (!item.has("quantity")) {
      Location where = item.location;
      where.key = join_key(where.key, "quantity");
      context.errors.add(where, "missing",
                         "a quantity (see `creepcontact list quantities`), or 'expression' instead of it");
    }
    check_place(item, context);
    if (probe.section && !item.has("origin")) probe.origin = probe.section->origin;
    for (const Quantity& quantity : vocabulary.quantities) {
      if (quantity.name != probe.quantity) continue;
      check_quantity(probe, quantity, item, context);
      check_axis(probe, quantity, vocabulary.quantities, item, context);
    }
    return probe;
  });
}

Value<Event> event_table() {
  const auto keys = table<Event>({
      field<Event>("name", &Event::name, name("a name"), "its name in `summary.json` and in plots; unique",
                   Presence::required),
      field<Event>("when", &Event::when, reference("a condition on names of probes and t"),
                   "the event is the first time at which this condition on names of probes and t holds, such as "
                   "`\"seal < 20 || t > 1000\"`",
                   Presence::required),
      field<Event>("stop", &Event::stop, boolean(), "the run ends there, with a last output").changeable(),
  });
  return converted<Event>(keys, [](Event event, const Item& item, Context&) -> std::optional<Event> {
    event.location = item.location;
    return event;
  });
}

}  // namespace creepcontact::config
