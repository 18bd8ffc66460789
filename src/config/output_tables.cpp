/// [output] and [[probes]]

#include <fmt/ranges.h>

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

/// `fields`: whether field files are written, and at which times.
struct FieldFiles {
  bool written = true;
  std::optional<std::vector<double>> times;
};

Value<FieldFiles> field_files() {
  const auto either = boolean();
  const auto times = list(converted<double>(number(at_least(0)), [](double time, const Item& item, Context& context) {
    if (context.end > 0 && time > context.end)
      context.errors.add(item.location, fmt::format("number {} is beyond time.end", time),
                         Range{.min = 0, .max = context.end}.describe("times"));
    return std::optional(time);
  }));
  Value<FieldFiles> value{.type = "true, false or a list of times",
                          .read = {},
                          .brief = "`true`, `false` or a list of times",
                          .words = either.words,
                          .json = [=] {
                            return schema_of_any({either.json(), times.json()});
                          }};
  value.read = [=, type = value.type](const Item& item, Context& context) -> std::optional<FieldFiles> {
    if (const auto* written = item.node->as_boolean()) return FieldFiles{written->get(), {}};
    if (!item.node->is_array()) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    auto found = times.read(item, context);
    if (!found) return std::nullopt;
    std::sort(found->begin(), found->end());
    found->erase(std::unique(found->begin(), found->end()), found->end());
    const bool any = !found->empty();
    return FieldFiles{any, std::move(*found)};
  };
  value.show = [=](const FieldFiles& shown) { return either.show(shown.written); };
  return value;
}

enum class Separator { comma, semicolon, tab };
constexpr auto names_of(Separator) {
  return std::to_array<settings::EnumName<Separator>>(
      {{",", Separator::comma}, {";", Separator::semicolon}, {"tab", Separator::tab}});
}

enum class Decimal { point, comma };
constexpr auto names_of(Decimal) {
  return std::to_array<settings::EnumName<Decimal>>({{".", Decimal::point}, {",", Decimal::comma}});
}

struct OutputKeys : Output {
  FieldFiles field_files;
  Separator separator = Separator::comma;
  Decimal decimal = Decimal::point;
};

std::optional<Output> make_output(OutputKeys keys, const Item& item, Context& context) {
  keys.fields = keys.field_files.written;
  keys.field_times = std::move(keys.field_files.times);
  if (keys.decimal == Decimal::comma && !item.has("separator")) keys.separator = Separator::semicolon;
  if (keys.decimal == Decimal::comma && keys.separator == Separator::comma)
    context.errors.add(item.child("decimal").location, "a decimal comma between cells separated by commas",
                       "with separator = \";\" or \"tab\"");
  keys.csv.separator = keys.separator == Separator::comma ? ',' : keys.separator == Separator::semicolon ? ';' : '\t';
  keys.csv.decimal = keys.decimal == Decimal::comma ? ',' : '.';
  return Output(std::move(keys));
}

void check_place(const Item& item, Context& context) {
  const bool on = item.has("on"), at = item.has("at"), body = item.has("body");
  if (on && at) {
    context.errors.add(item.location, "both 'on' and 'at'", "'on', 'at', or 'body' alone");
  } else if (!on && !at && !body) {
    context.errors.add(item.location, "no place: none of 'on', 'at' and 'body'", "'on', 'at', or 'body'");
  }
  if (at && !on && item.has("reduce")) {
    context.errors.add(item.child("reduce").location, "has no meaning at a point", "with 'on' or 'body' alone");
  }
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
  if (!quantity.sum_only) return;
  if (item.has("reduce") && probe.reduce != Reduce::sum) {
    context.errors.add(item.child("reduce").location, describe(*item.child("reduce").node),
                       fmt::format("\"sum\" with '{}'", quantity.name));
  }
  probe.reduce = Reduce::sum;
}

}  // namespace

Value<Output> output_table() {
  const auto keys = table<OutputKeys>({
      field<OutputKeys>("directory", &OutputKeys::directory, path(), "directory of the results")
          .otherwise("`results/<name of the configuration>`"),
      field<OutputKeys>("fields", &OutputKeys::field_files, field_files(),
                        "write `fields.pvd`, `contact.pvd` and their `.vtu` files: at all output times, at none, or at "
                        "these times alone, which are then output times too")
          .in("time"),
      field<OutputKeys>("revolve", &OutputKeys::revolve, integer(3, 360),
                        "axisymmetric models: write the full solid too, of so many segments, as `revolved.pvd`")
          .otherwise("the section alone"),
      field<OutputKeys>(
          "unit_names", &OutputKeys::unit_names, boolean(),
          "add units to the names of the arrays in the field files, as in `stress [MPa]`, where `units` gives them"),
      field<OutputKeys>("separator", &OutputKeys::separator, choice<Separator>("separator"),
                        "what separates the cells of `history.csv`, `steps.csv` and the log of contact iterations")
          .otherwise("`\",\"`, or `\";\"` with a decimal comma"),
      field<OutputKeys>("decimal", &OutputKeys::decimal, choice<Decimal>("decimal sign"),
                        "decimal sign of their numbers"),
      field<OutputKeys>("checkpoint_seconds", &OutputKeys::checkpoint_seconds, number(at_least(0)),
                        "wall time between checkpoints for `--resume`; 0: one after every step")
          .in("seconds"),
  });
  return converted<Output>(keys, [](OutputKeys read, const Item& item, Context& context) {
    return make_output(std::move(read), item, context);
  });
}

Value<Probe> probe_table(const Vocabulary& vocabulary) {
  const auto reduce = choice<Reduce>("reduction");
  const auto keys = table<Probe>({
      field<Probe>("name", &Probe::name, column_name(), "heading of its column in `history.csv`; unique",
                   Presence::required),
      field<Probe>("quantity", &Probe::quantity, quantity_name(vocabulary.quantities), "quantity to record",
                   Presence::required),
      field<Probe>("on", &Probe::on, reference("a physical surface, curve or point"), "record over this group, ..."),
      field<Probe>("at", &Probe::at, triple(number()), "... or at this point of the undeformed body, ...").in("length"),
      field<Probe>("body", &Probe::body, reference("the name of a body"),
                   "... or, without `on` and `at`, over this whole body; with `on` or `at`: only in this body"),
      field<Probe>("reduce", &Probe::reduce, reduce,
                   "how the values over a group or body become one: `\"mean\"` is weighted by area or volume, "
                   "`\"sum\"` is the integral; areas and forces allow only `\"sum\"`"),
      field<Probe>(
          "axis", &Probe::axis, triple(number()),
          "direction of the axis of cylindrical components (`stress_r`, `stress_theta`, `stress_rtheta`), of any "
          "length; in an axisymmetric model always y"),
      field<Probe>("origin", &Probe::origin, triple(number()),
                   "a point of that axis; with `contact_moment_x|y|z` the point that moments refer to")
          .in("length"),
  });
  return converted<Probe>(keys, [=](Probe probe, const Item& item, Context& context) -> std::optional<Probe> {
    probe.location = item.location;
    check_place(item, context);
    for (const Quantity& quantity : vocabulary.quantities) {
      if (quantity.name != probe.quantity) continue;
      check_quantity(probe, quantity, item, context);
      check_axis(probe, quantity, vocabulary.quantities, item, context);
    }
    return probe;
  });
}

}  // namespace creepcontact::config
