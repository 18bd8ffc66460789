/// [[supports]], [generalized_plane_strain] and [temperature]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

struct Displacement {
  std::array<std::optional<Function>, 3> components;
  std::optional<Function> normal;
};

struct TemperatureKeys {
  std::optional<Function> value;
  std::filesystem::path file;
  double refactor_change = Temperature{}.refactor_change;
};

Value<Displacement> displacement_table() {
  const Value<Function> value = function(position_and_time);
  const auto component = [](std::size_t i) {
    return [i](Displacement& into) -> std::optional<Function>& { return into.components[i]; };
  };
  const auto keys = written_inline(table<Displacement>({
      field<Displacement>("x", component(0), value, "displacement along x").in("length"),
      field<Displacement>("y", component(1), value, "displacement along y").in("length"),
      field<Displacement>("z", component(2), value, "displacement along z").in("length"),
      field<Displacement>("normal", &Displacement::normal, value,
                          "displacement along the outward normal; surfaces only, in sections curves")
          .in("length"),
  }));
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
      field<SupportKeys>("on", &SupportKeys::on, reference("a physical surface, curve or point"),
                         "group that is supported", Presence::required),
      field<SupportKeys>("body", &SupportKeys::body, reference("the name of a body"),
                         "support only the nodes of this body"),
      field<SupportKeys>("displacement", &SupportKeys::prescribed, displacement_table(),
                         "at least one of the four below", Presence::required),
  });
  return converted<Support>(keys, [](SupportKeys found, const Item& item, Context&) -> std::optional<Support> {
    found.displacement = std::move(found.prescribed.components);
    found.normal = std::move(found.prescribed.normal);
    found.location = item.location;
    return Support(std::move(found));
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
  });
  return converted<Table>(keys, [](Table found, const Item& item, Context& context) -> std::optional<Table> {
    if (item.has("strain") && item.has("force"))
      context.errors.add(item.location, "both 'strain' and 'force'", "one of them; the other one follows");
    return found;
  });
}

Value<Temperature> temperature_table() {
  const auto keys = table<TemperatureKeys>({
      field<TemperatureKeys>("value", &TemperatureKeys::value, function(position_and_time),
                             "temperature of all bodies, or ...")
          .in("temperature"),
      field<TemperatureKeys>("file", &TemperatureKeys::file, path(),
                             "... temperatures at points, `.csv`, `.h5` or `.hdf5`, interpolated to all bodies")
          .changeable(),
      field<TemperatureKeys>("refactor_change", &TemperatureKeys::refactor_change, number({.min = 0, .max = 0.5}),
                             "relative change of the stiffness with temperature above which it is factorised again; "
                             "affects the run time, not the results")
          .changeable(),
  });
  return converted<
      Temperature>(keys, [](TemperatureKeys found, const Item& item, Context& context) -> std::optional<Temperature> {
    const std::vector<std::string> given = given_keys(item, {"value", "file"});
    if (given.size() != 1)
      context.errors.add(item.location, given.empty() ? "no temperature" : "both 'value' and 'file'",
                         "exactly one of value, file");
    return Temperature{found.value.value_or(Function()), std::move(found.file), found.refactor_change, item.location};
  });
}

}  // namespace creepcontact::config
