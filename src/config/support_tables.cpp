/// [[supports]], [generalized_plane_strain] and [temperature]

#include <algorithm>

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

struct Displacement {
  std::array<std::optional<Function>, 3> components, cylindrical;
  std::optional<Function> normal, along;
};

/// What is not given, which Temperature cannot tell.
enum class ThousandsSign { point, comma, blank, apostrophe };
constexpr auto names_of(ThousandsSign) {
  return std::to_array<settings::EnumName<ThousandsSign>>({{".", ThousandsSign::point},
                                                           {",", ThousandsSign::comma},
                                                           {" ", ThousandsSign::blank},
                                                           {"'", ThousandsSign::apostrophe}});
}

constexpr std::array<const char*, 6> column_keys{"x", "y", "z", "r", "t", "T"};
using ColumnNames = std::array<std::optional<std::string>, column_keys.size()>;

struct TemperatureKeys : Temperature {
  std::optional<ThousandsSign> separator;
  std::optional<Function> given;
  ColumnNames names;
};

/// One path or a list of them.
Value<std::vector<std::filesystem::path>> paths() {
  const auto one = path();
  const auto several = list(one);
  Value<std::vector<std::filesystem::path>> value{
      .type = "a path, or a list of paths", .read = {}, .brief = "path or list of paths", .json = [=] {
        return schema_of_any({one.json(), several.json()});
      }};
  value.read = [=](const Item& item, Context& context) -> std::optional<std::vector<std::filesystem::path>> {
    if (item.node->is_array()) return several.read(item, context);
    auto found = one.read(item, context);
    if (!found) return std::nullopt;
    return std::vector{std::move(*found)};
  };
  value.visit = [=](const std::vector<std::filesystem::path>& all, Visitor& to) {
    if (all.empty()) return;  // no file has an empty list of them
    if (all.size() == 1) return one.visit(all.front(), to);
    several.visit(all, to);
  };
  return value;
}

Value<ColumnNames> column_names() {
  const auto of = [](std::size_t i, const char* meaning) {
    return field<ColumnNames>(
        column_keys[i], [i](auto& names) -> auto& { return names[i]; }, name("the name of a column"), meaning);
  };
  return written_inline(table<ColumnNames>({of(0, "column of x"), of(1, "column of y"), of(2, "column of z"),
                                            of(3, "column of the distance from the axis"), of(4, "column of the time"),
                                            of(5, "column, or array of a `.vtu`, of the temperature")}));
}

TemperatureKeys keys_of_temperature(const Temperature& temperature) {
  TemperatureKeys keys{temperature, {}, {}, {}};
  if (temperature.files.empty()) keys.given = temperature.value;
  for (const auto& [name, sign] : names_of(ThousandsSign{}))
    if (name == temperature.thousands) keys.separator = sign;
  for (std::size_t i = 0; i < column_keys.size(); ++i)
    if (const auto found = temperature.columns.find(column_keys[i]); found != temperature.columns.end())
      keys.names[i] = found->second;
  return keys;
}

void check_files(const TemperatureKeys& keys, const Item& item, Context& context) {
  const auto report = [&](const char* key, const std::string& what, const std::string& allowed) {
    context.errors.add(item.child(key).location, what, allowed);
  };
  for (const std::string& key : given_keys(item, {"times", "columns", "thousands", "period", "axis", "origin"}))
    if (!item.has("file"))
      report(key.c_str(), "has no meaning without 'file'", "with temperatures at points: 'file' = \"...\"");
  if (item.has("file") && keys.files.empty() && item.child("file").node->is_array())
    report("file", "an empty list", "at least one path");
  if (item.has("times") && item.has("file") && keys.times.size() != keys.files.size())
    report("times", fmt::format("{} times for {} in 'file'", keys.times.size(), keys.files.size()),
           "a list with one time per file");
  for (std::size_t i = 1; i < keys.times.size(); ++i)
    if (!(keys.times[i] > keys.times[i - 1]))
      report("times", fmt::format("{} after {}", keys.times[i], keys.times[i - 1]), "times that increase");
  const auto has_star = [](const std::filesystem::path& file) { return file.string().find('*') != std::string::npos; };
  if (keys.files.size() > 1 && std::any_of(keys.files.begin(), keys.files.end(), has_star))
    report("file", "a list with a '*'", "one path with a '*', or a list of paths without");
  if (keys.files.size() == 1 && has_star(keys.files[0]) && item.has("times"))
    report("times", "has no meaning for files of a pattern, whose names hold their times", "with a list of paths");
  if (item.has("axis") && keys.axis == std::array<double, 3>{}) report("axis", "[0, 0, 0]", "a direction");
}

Value<Displacement> displacement_table() {
  const Value<Function> value = function(position_and_time);
  const auto component = [](std::size_t i) {
    return [i](auto& into) -> auto& {
      return into.components[i];
    };
  };
  const auto cylindrical = [](std::size_t i) {
    return [i](auto& into) -> auto& {
      return into.cylindrical[i];
    };
  };
  const auto keys = written_inline(table<Displacement>({
      field<Displacement>("x", component(0), value, "displacement along x").in("length"),
      field<Displacement>("y", component(1), value, "displacement along y").in("length"),
      field<Displacement>("z", component(2), value, "displacement along z").in("length"),
      field<Displacement>("normal", &Displacement::normal, value,
                          "displacement along the outward normal; surfaces only, in sections curves")
          .in("length"),
      field<Displacement>("radial", cylindrical(0), value, "displacement away from the `axis`").in("length"),
      field<Displacement>("tangential", cylindrical(1), value, "displacement around the `axis`, by the right-hand rule")
          .in("length"),
      field<Displacement>("axial", cylindrical(2), value, "displacement along the `axis`").in("length"),
      field<Displacement>("along", &Displacement::along, value, "displacement along `direction`").in("length"),
  }));
  return converted<Displacement>(
      keys, [](Displacement found, const Item& item, Context& context) -> std::optional<Displacement> {
        if (item.node->as_table()->empty()) {
          context.errors.add(item.location, "an empty table",
                             "at least one of x, y, z, normal, radial, tangential, axial, along");
        }
        return found;
      });
}

struct SupportKeys : Support {
  Displacement prescribed;
};

void check_directions(const Support& support, const Item& item, Context& context) {
  const bool is_cylindrical = std::ranges::any_of(support.cylindrical, [](const auto& one) { return one.has_value(); });
  for (const std::string& key : given_keys(item, {"axis", "origin"}))
    if (!is_cylindrical)
      context.errors.add(item.child(key).location, "has no meaning here",
                         "with displacement.radial, tangential or axial");
  if (is_cylindrical && support.axis == std::array<double, 3>{})
    context.errors.add(item.child("axis").location, "[0, 0, 0]", "a direction");
  if (support.along && !item.has("direction"))
    context.errors.add(item.child("displacement").child("along").location, "needs 'direction'",
                       "direction = [x, y, z]");
  if (item.has("direction") && !support.along)
    context.errors.add(item.child("direction").location, "has no meaning here", "with displacement.along");
  if (support.from && support.until && !(*support.until > *support.from))
    context.errors.add(item.child("until").location,
                       fmt::format("{:g} after 'from' = {:g}", *support.until, *support.from), "a time after 'from'");
  if (support.relative && !(support.from && *support.from > 0))
    context.errors.add(item.child("relative").location, "needs 'from'", "with from = a time after the start");
  if (support.direction == std::array<double, 3>{})
    context.errors.add(item.child("direction").location, "[0, 0, 0]", "a direction");
}

}  // namespace

Value<Support> support_table() {
  const auto keys = table<SupportKeys>({
      field<SupportKeys>("on", &SupportKeys::on, reference("a physical surface, curve or point"),
                         "group that is supported", Presence::required),
      field<SupportKeys>("body", &SupportKeys::body, reference("the name of a body"),
                         "support only the nodes of this body"),
      field<SupportKeys>("displacement", &SupportKeys::prescribed, displacement_table(), "at least one of those below",
                         Presence::required),
      field<SupportKeys>("axis", &SupportKeys::axis, triple(number()),
                         "direction of the axis of `radial`, `tangential` and `axial`, of any length"),
      field<SupportKeys>("origin", &SupportKeys::origin, triple(number()), "a point of that axis").in("length"),
      field<SupportKeys>("direction", &SupportKeys::direction, triple(number()),
                         "direction of `along`, of any length; required with it"),
      field<SupportKeys>("from", &SupportKeys::from, number(), "time from which on the support acts; free before")
          .in("time")
          .otherwise("from the start"),
      field<SupportKeys>("until", &SupportKeys::until, number(), "time at which it is taken away")
          .in("time")
          .otherwise("to the end"),
      field<SupportKeys>(
          "relative", &SupportKeys::relative, boolean(),
          "the displacement counts from what is reached at `from`: with 0 the nodes stay where they are"),
  });
  return converted<Support>(
      keys,
      [](SupportKeys found, const Item& item, Context& context) -> std::optional<Support> {
        found.displacement = std::move(found.prescribed.components);
        found.normal = std::move(found.prescribed.normal);
        found.cylindrical = std::move(found.prescribed.cylindrical);
        found.along = std::move(found.prescribed.along);
        found.location = item.location;
        check_directions(found, item, context);
        return Support(std::move(found));
      },
      [](const Support& support) {
        return SupportKeys{support, {support.displacement, support.cylindrical, support.normal, support.along}};
      });
}

Value<GeneralizedPlaneStrain> generalized_plane_strain_table() {
  using Table = GeneralizedPlaneStrain;
  const auto keys = table<Table>({
      field<Table>("strain", &Table::strain, function({"t"}), "prescribed axial strain, or ..."),
      field<Table>("force", &Table::force, function({"t"}),
                   "... axial force on the cross-sections of all bodies together; the strain follows from it")
          .in("force")
          .otherwise("no force"),
      field<Table>("per_body", &Table::per_body, boolean(),
                   "each body has an axial strain of its own, which follows from the axial force on it alone: "
                   "`bodies.<name>.axial_force`"),
  });
  return converted<Table>(keys, [](Table found, const Item& item, Context& context) -> std::optional<Table> {
    if (item.has("strain") && item.has("force"))
      context.errors.add(item.location, "both 'strain' and 'force'", "one of them; the other one follows");
    if (found.per_body && item.has("strain"))
      context.errors.add(item.child("per_body").location, "'per_body' with a 'strain', which all bodies have",
                         "one of them");
    if (found.per_body && item.has("force"))
      context.errors.add(item.child("force").location, "'force' on all bodies together with 'per_body = true'",
                         "the force on each body, 'axial_force' in its table [bodies.<name>]; without it 0");
    return found;
  });
}

Value<Temperature> temperature_table() {
  const auto keys = table<TemperatureKeys>({
      field<TemperatureKeys>("value", &TemperatureKeys::given, function(position_and_time),
                             "temperature of all bodies, or ...")
          .in("temperature"),
      field<TemperatureKeys>("file", &TemperatureKeys::files, paths(),
                             "... temperatures at points, `.csv`, `.vtu`, `.frd`, `.h5` or `.hdf5`, interpolated to "
                             "all bodies: one file, one per time (a list, or a pattern `t_*.csv`)")
          .changeable(),
      field<TemperatureKeys>("times", &TemperatureKeys::times, list(number()),
                             "times of the files of a list, one each, increasing")
          .in("time")
          .changeable()
          .otherwise("those in the files"),
      field<TemperatureKeys>("columns", &TemperatureKeys::names, column_names(),
                             "names of columns, where the reader does not find them itself")
          .changeable(),
      field<TemperatureKeys>("thousands", &TemperatureKeys::separator, choice<ThousandsSign>("separator of thousands"),
                             "what separates thousands in CSV files; the decimal sign is then the comma or the point "
                             "that is left")
          .changeable()
          .otherwise("nothing"),
      field<TemperatureKeys>("period", &TemperatureKeys::period, number(greater(0)),
                             "the files repeat in time: they begin at t = 0 and end at this time or before")
          .in("time")
          .changeable(),
      field<TemperatureKeys>("axis", &TemperatureKeys::axis, triple(number()),
                             "solids: direction of the axis about which the points of a section are revolved, of any "
                             "length")
          .changeable()
          .otherwise("`[0, 0, 1]` for files with columns r and z"),
      field<TemperatureKeys>("origin", &TemperatureKeys::origin, triple(number()),
                             "the point of that axis where z is 0")
          .in("length")
          .changeable()
          .otherwise("the origin of the coordinates"),
      field<TemperatureKeys>("refactor_change", &TemperatureKeys::refactor_change, number({.min = 0, .max = 0.5}),
                             "relative change of the stiffness with temperature above which it is factorised again; "
                             "affects the run time, not the results")
          .changeable(),
      field<TemperatureKeys>("scale", &TemperatureKeys::scale, function({"t"}),
                             "factor on the temperature less `scale_about`: one field, an amplitude in time")
          .otherwise("1, of files"),
      field<TemperatureKeys>("scale_about", &TemperatureKeys::scale_about, number(),
                             "temperature that `scale` leaves as it is")
          .in("temperature")
          .otherwise("0, of files"),
  });
  return converted<Temperature>(
      keys,
      [](TemperatureKeys found, const Item& item, Context& context) -> std::optional<Temperature> {
        const std::vector<std::string> given = given_keys(item, {"value", "file"});
        if (given.size() != 1)
          context.errors.add(item.location, given.empty() ? "no temperature" : "both 'value' and 'file'",
                             "exactly one of value, file");
        check_files(found, item, context);
        for (const std::string& key : given_keys(item, {"scale", "scale_about"}))
          if (!item.has("file"))
            context.errors.add(item.child(key).location, "has no effect without 'file'",
                               "with a file only; a 'value' is an expression, in which it can be written");
        if (found.separator) found.thousands = settings::name_of(*found.separator);
        found.value = found.given.value_or(Function());
        for (std::size_t i = 0; i < column_keys.size(); ++i)
          if (found.names[i]) found.columns[column_keys[i]] = std::move(*found.names[i]);
        found.location = item.location;
        return Temperature(std::move(found));
      },
      keys_of_temperature);
}

}  // namespace creepcontact::config
