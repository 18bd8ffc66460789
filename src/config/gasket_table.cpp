/// [gaskets.<name>]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

std::vector<Field<GasketCurve>> gasket_curve_keys() {
  return {
      field<GasketCurve>("closure", &GasketCurve::closure, list(number()),
                         "closures, by how much thinner the gasket is: increasing", Presence::required)
          .in("length"),
      field<GasketCurve>("pressure", &GasketCurve::pressure, list(number({.min = 0})),
                         "pressures at these closures, from 0 on, increasing; linear in between, and beyond the last "
                         "one with the last slope",
                         Presence::required)
          .in("stress")};
}

Value<GasketCurve> loading_table() {
  std::vector<Field<GasketCurve>> keys = gasket_curve_keys();
  keys.insert(keys.begin(), field<GasketCurve>("T", &GasketCurve::T, number(), "temperature of this curve")
                                .otherwise("required if there are several")
                                .in("temperature"));
  return written_inline(table<GasketCurve>(keys));
}

Value<GasketUnloading> unloading_table() {
  return written_inline(table<GasketUnloading>({
      field<GasketUnloading>("T", &GasketUnloading::T, number(), "temperature, one of those of `loading`")
          .otherwise("at all temperatures")
          .in("temperature"),
      field<GasketUnloading>("from", &GasketUnloading::from, list(number(greater(0))),
                             "pressures at which unloading begins, increasing")
          .otherwise("required without `curves`")
          .in("stress"),
      field<GasketUnloading>("modulus", &GasketUnloading::modulus, list(number(greater(0))),
                             "unloading moduli E_G from there: straight lines of the slope modulus/thickness")
          .otherwise("required with `from`")
          .in("stress"),
      field<GasketUnloading>(
          "curves", &GasketUnloading::curves, list(written_inline(table<GasketCurve>(gasket_curve_keys()))),
          "measured unloading curves instead, each from its residual closure at pressure 0 up to the "
          "loading curve")
          .otherwise("none"),
  }));
}

Value<GasketRelaxation> relaxation_table() {
  const auto positive = number(greater(0));
  return written_inline(table<GasketRelaxation>({
      field<GasketRelaxation>("factor", &GasketRelaxation::factor, number({.min = 0, .max = 1, .open_min = true}),
                              "P_QR: pressure at the end of the test over that at its beginning", Presence::required),
      field<GasketRelaxation>("pressure", &GasketRelaxation::pressure, positive, "pressure at the beginning",
                              Presence::required)
          .in("stress"),
      field<GasketRelaxation>("stiffness", &GasketRelaxation::stiffness, positive,
                              "stiffness of the rig, in EN 13555 500, 1000 or 1500 kN/mm: the factor means nothing "
                              "without it",
                              Presence::required)
          .in("force/length"),
      field<GasketRelaxation>("area", &GasketRelaxation::area, positive, "area of the gasket that was tested",
                              Presence::required)
          .in("area"),
      field<GasketRelaxation>("time", &GasketRelaxation::time, positive, "duration of the test, usually 4 h",
                              Presence::required)
          .in("time"),
      field<GasketRelaxation>(
          "T", &GasketRelaxation::T, number(),
          "temperature of the test, for `loading` and `unloading` that depend on it; the creep found "
          "acts at all temperatures")
          .otherwise("the reference temperature")
          .in("temperature"),
      field<GasketRelaxation>("n", &GasketRelaxation::n, number(at_least(1)),
                              "exponent of the pressure in Norton's law, which the factor does not tell; 4 to 6"),
  }));
}

void check(const Gasket& given, const Item& item, Context& context) {
  const std::vector<GasketCurve>& loading = given.loading;
  for (std::size_t i = 0; i < loading.size() && loading.size() > 1; ++i) {
    const bool is_later = i == 0 || !loading[i - 1].T || !loading[i].T || *loading[i].T > *loading[i - 1].T;
    if (!loading[i].T || !is_later)
      context.errors.add(item.child("loading").location,
                         loading[i].T ? fmt::format("T = {:g} after {:g}", *loading[i].T, *loading[i - 1].T)
                                      : fmt::format("curve {} has no T", i + 1),
                         "several curves with increasing temperatures T");
  }
  const auto is_of_a_curve = [&](const GasketUnloading& one) {
    return one.T && std::ranges::any_of(loading, [&](const GasketCurve& curve) { return curve.T == one.T; });
  };
  if (given.unloading.size() > 1 &&
      (given.unloading.size() != loading.size() || !std::ranges::all_of(given.unloading, is_of_a_curve)))
    context.errors.add(item.child("unloading").location, "several tables",
                       "one for all temperatures, or one with each T of 'loading'");
  for (const GasketUnloading& one : given.unloading)
    if (one.from.empty() && one.modulus.empty() && one.curves.empty())
      context.errors.add(item.child("unloading").location, "nothing about how it unloads",
                         "'from' and 'modulus', or 'curves'");
  if (given.relaxation && !given.creep.empty())
    context.errors.add(item.child("relaxation").location, "given together with 'creep'",
                       "one of the two: both describe the creep of the gasket");
}

}  // namespace

Value<Gasket> gasket_table(const Vocabulary& vocabulary) {
  const auto keys = table<Gasket>({
      field<Gasket>("thickness", &Gasket::thickness, number(greater(0)), "uncompressed", Presence::required)
          .in("length"),
      field<Gasket>("loading", &Gasket::loading, written_inline(one_or_more_tables(loading_table())),
                    "pressure over closure when it is compressed for the first time; a list with `T`",
                    Presence::required),
      field<Gasket>("unloading", &Gasket::unloading, written_inline(one_or_more_tables(unloading_table())),
                    "how it unloads and is compressed again, from the largest closure it has had")
          .otherwise("along `loading`"),
      field<Gasket>("thermal_expansion", &Gasket::thermal_expansion, function({"T"}),
                    "through the thickness, secant from `reference_temperature`")
          .in("1/temperature"),
      field<Gasket>("reference_temperature", &Gasket::reference_temperature, number(),
                    "temperature at which it has its thickness, and that of the gasket without `[temperature]`")
          .otherwise("required with `thermal_expansion` and `[temperature]`")
          .in("temperature"),
      field<Gasket>(
          "creep", &Gasket::creep, laws_elsewhere(vocabulary),
          "creep laws that act together, of the strain closure/thickness under the pressure as uniaxial stress")
          .otherwise("none"),
      field<Gasket>("relaxation", &Gasket::relaxation, relaxation_table(),
                    "creep by Norton's law from a relaxation test of EN 13555, instead of `creep`"),
  });
  return converted<Gasket>(keys, [](Gasket given, const Item& item, Context& context) {
    given.location = item.location;
    check(given, item, context);
    return std::optional(std::move(given));
  });
}

}  // namespace creepcontact::config
