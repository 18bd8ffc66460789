/// [heat], and how contacts conduct

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

const std::vector<std::string> anywhere{"x", "y", "z", "t", "T"};

const auto surface = [] { return reference("a physical surface"); };
const auto body = [] { return reference("the name of a body"); };

/// Keys of the place of an entry, before others of its table. @param what  flows there, or is there
template <class T>
std::vector<Field<T>> with_place(const std::string& what, std::vector<Field<T>> others) {
  std::vector<Field<T>> keys{field<T>("on", &T::on, surface(), what, Presence::required),
                             field<T>("body", &T::body, body(), "only the faces of this body").otherwise("of all")};
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

Value<HeatFilm> film_table() {
  return written_inline(table<HeatFilm>(
      with_place<HeatFilm>("surface, in sections curve, along which a fluid flows",
                           {
                               field<HeatFilm>("coefficient", &HeatFilm::coefficient, function(anywhere, at_least(0)),
                                               "film coefficient", Presence::required)
                                   .in("power/(area temperature)"),
                               field<HeatFilm>("fluid", &HeatFilm::fluid, function(position_and_time),
                                               "temperature of the fluid", Presence::required)
                                   .in("temperature"),
                           })));
}

Value<HeatFlux> flux_table() {
  return written_inline(table<HeatFlux>(with_place<HeatFlux>(
      "surface, in sections curve", {
                                        field<HeatFlux>("value", &HeatFlux::value, function(anywhere),
                                                        "heat that flows into the body", Presence::required)
                                            .in("power/area"),
                                    })));
}

Value<HeatTemperature> given_table() {
  return written_inline(table<HeatTemperature>({
      field<HeatTemperature>("on", &HeatTemperature::on, reference("a physical surface, curve or point"),
                             "group whose nodes have a given temperature", Presence::required),
      field<HeatTemperature>("body", &HeatTemperature::body, body(), "only the nodes of this body").otherwise("of all"),
      field<HeatTemperature>("value", &HeatTemperature::value, function(position_and_time), "temperature",
                             Presence::required)
          .in("temperature"),
  }));
}

Value<HeatRadiation> radiation_table() {
  return written_inline(table<HeatRadiation>(with_place<HeatRadiation>(
      "surface, in sections curve",
      {
          field<HeatRadiation>("emissivity", &HeatRadiation::emissivity, function(anywhere, {.min = 0, .max = 1}),
                               "part of the black body's radiation", Presence::required),
          field<HeatRadiation>("ambient", &HeatRadiation::ambient, function(position_and_time),
                               "temperature of the surroundings", Presence::required)
              .in("temperature"),
      })));
}

Value<HeatSource> source_table() {
  return written_inline(table<HeatSource>({
      field<HeatSource>("body", &HeatSource::body, body(), "body in which heat arises", Presence::required),
      field<HeatSource>("value", &HeatSource::value, function(anywhere), "heat per volume", Presence::required)
          .in("power/volume"),
  }));
}

Value<HeatPointFlow> point_flow_table() {
  return written_inline(table<HeatPointFlow>({
      field<HeatPointFlow>("on", &HeatPointFlow::on, reference("a physical surface, curve or point"),
                           "group into each of whose nodes heat flows", Presence::required),
      field<HeatPointFlow>("body", &HeatPointFlow::body, body(), "only the nodes of this body").otherwise("of all"),
      field<HeatPointFlow>("value", &HeatPointFlow::value, function(position_and_time),
                           "heat per time into each node, in axisymmetric models on the whole circumference",
                           Presence::required)
          .in("power"),
  }));
}

/// The temperature at the start, or "steady".
Value<std::optional<Function>> start_value() {
  const Value<Function> given = function({"x", "y", "z"});
  Value<std::optional<Function>> value{.type = given.type + ", or \"steady\"",
                                       .read = {},
                                       .brief = given.brief + ", or `\"steady\"`",
                                       .words = words_of({"steady"}),
                                       .json = [given] {
                                         return schema_of_any({given.json(), schema_of_words({"steady"})});
                                       }};
  value.read = [given](const Item& item, Context& context) -> std::optional<std::optional<Function>> {
    if (item.node->value<std::string>() == "steady") return std::optional<Function>();
    auto found = given.read(item, context);
    if (!found) return std::nullopt;
    return std::optional<Function>(std::move(*found));
  };
  value.visit = [given](const std::optional<Function>& start, Visitor& to) {
    if (start) return given.visit(*start, to);
    to.leaf([] { return toml_of(std::string("steady")); });
  };
  return value;
}

struct HeatKeys : Heat {
  std::optional<std::optional<Function>> beginning;
};

}  // namespace

Value<Conductance> conductance_value() {
  const Value<Function> given = function({"x", "y", "z", "t", "T", "p", "gap"}, at_least(0));
  Value<Conductance> value{.type = given.type + ", \"perfect\" or \"insulated\"",
                           .read = {},
                           .brief = given.brief + ", `\"perfect\"` or `\"insulated\"`",
                           .words = words_of({"perfect", "insulated"}),
                           .json = [given] {
                             return schema_of_any({given.json(), schema_of_words({"perfect", "insulated"})});
                           }};
  value.read = [given](const Item& item, Context& context) -> std::optional<Conductance> {
    const auto text = item.node->value<std::string>();
    if (text == "perfect") return Conductance{Conductance::Kind::perfect};
    if (text == "insulated") return Conductance{Conductance::Kind::insulated};
    const auto found = given.read(item, context);
    if (!found) return std::nullopt;
    return Conductance{Conductance::Kind::function, *found};
  };
  value.visit = [given](const Conductance& conductance, Visitor& to) {
    using Kind = Conductance::Kind;
    if (conductance.kind == Kind::function) return given.visit(conductance.value, to);
    if (conductance.kind == Kind::not_given) return;
    to.leaf(
        [kind = conductance.kind] { return toml_of(std::string(kind == Kind::perfect ? "perfect" : "insulated")); });
  };
  return value;
}

Value<Heat> heat_table() {
  const auto keys = table<HeatKeys>({
      field<HeatKeys>("start", &HeatKeys::beginning, start_value(),
                      "temperature at t = 0; `\"steady\"`: the steady one with the loads of that time",
                      Presence::required)
          .in("temperature"),
      field<HeatKeys>(
          "time_unit", &HeatKeys::time_unit, number(greater(0)),
          "the unit of t in the unit of time of the heat data: 3600 if t is in hours and watts are joules per "
          "second")
          .otherwise("required unless the temperature is steady"),
      field<HeatKeys>("films", &HeatKeys::films, list(film_table()), "surfaces along which a fluid flows")
          .otherwise("none"),
      field<HeatKeys>("fluxes", &HeatKeys::fluxes, list(flux_table()), "surfaces through which a given heat flows")
          .otherwise("none"),
      field<HeatKeys>("temperatures", &HeatKeys::temperatures, list(given_table()), "places of given temperature")
          .otherwise("none"),
      field<HeatKeys>("radiation", &HeatKeys::radiation, list(radiation_table()),
                      "surfaces that exchange radiation with their surroundings, not with each other")
          .otherwise("none"),
      field<HeatKeys>("sources", &HeatKeys::sources, list(source_table()), "heat that arises in a body")
          .otherwise("none"),
      field<HeatKeys>("point_flows", &HeatKeys::point_flows, list(point_flow_table()), "heat that flows into nodes")
          .otherwise("none"),
      field<HeatKeys>("stefan_boltzmann", &HeatKeys::stefan_boltzmann, number(greater(0)),
                      "constant of radiation in the units of the data: 5.670374e-8 W/(m^2 K^4), 5.670374e-11 "
                      "mW/(mm^2 K^4)")
          .in("power/(area temperature^4)")
          .otherwise("required with `radiation`"),
      field<HeatKeys>("absolute_zero", &HeatKeys::absolute_zero, number(),
                      "-273.15 if temperatures are in degrees Celsius")
          .in("temperature")
          .otherwise("required with `radiation`"),
      field<HeatKeys>("alone", &HeatKeys::alone, boolean(), "computes the temperature alone, without any mechanics")
          .otherwise("true if no material has elastic constants"),
      field<HeatKeys>("tolerance", &HeatKeys::tolerance, number({.min = 1e-9, .max = 0.1}),
                      "error of temperatures, relative to the range of those given")
          .changeable(),
      field<HeatKeys>("refactor_change", &HeatKeys::refactor_change, number({.min = 0, .max = 0.5}),
                      "relative change of the stiffness with temperature above which it is factorised again; affects "
                      "the run time, not the results")
          .changeable(),
      field<HeatKeys>("keep", &HeatKeys::keep, path(),
                      "file in which the computed temperatures are kept, for runs whose heat is the same: `run` and "
                      "`check` read it if it fits, else they write it")
          .changeable()
          .otherwise("they are computed in each run"),
  });
  return converted<Heat>(
      keys,
      [](HeatKeys found, const Item& item, Context& context) -> std::optional<Heat> {
        if (found.beginning) found.start = std::move(*found.beginning);
        found.location = item.location;
        if (!found.radiation.empty() && (!found.stefan_boltzmann || !found.absolute_zero))
          context.errors.add(
              item.child("radiation").location,
              fmt::format("radiation without '{}'", found.stefan_boltzmann ? "absolute_zero" : "stefan_boltzmann"),
              "both of stefan_boltzmann and absolute_zero, in the units of the data");
        if (found.absolute_zero && found.start && found.start->is_constant() &&
            (*found.start)({}) < *found.absolute_zero)
          context.errors.add(item.child("start").location,
                             fmt::format("{:g} is below absolute_zero", (*found.start)({})), "temperatures above it");
        return Heat(std::move(found));
      },
      [](const Heat& heat) {
        return HeatKeys{heat, heat.start};
      });
}

}  // namespace creepcontact::config
