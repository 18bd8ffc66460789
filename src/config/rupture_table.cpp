/// [materials.<name>.rupture]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

const std::vector<std::string> larson_miller_keys{"larson_miller_constant", "stress", "parameter", "absolute_zero",
                                                  "time_unit"};

void check_data(const Rupture& rupture, const Item& item, const Vocabulary& vocabulary, Context& context) {
  if (item.has("rupture_time")) {
    for (const std::string& key : given_keys(item, larson_miller_keys))
      context.errors.add(item.child(key).location, "given together with rupture_time", "one of the two");
    return;
  }
  const std::vector<std::string> given = given_keys(item, larson_miller_keys);
  if (given.empty()) {
    context.errors.add(item.location, "no rupture data", "rupture_time, or stress and parameter (Larson-Miller)");
    return;
  }
  require_keys(item,
               {{"stress", "a list of numbers > 0", true, "", ""}, {"parameter", "a list of numbers", true, "", ""}},
               context);
  if (rupture.stress.empty() || rupture.parameter.empty() || !vocabulary.validate_larson_miller) return;
  if (const auto mistake = vocabulary.validate_larson_miller(rupture.stress, rupture.parameter))
    context.errors.add(item.child(mistake->key).location, mistake->found, mistake->allowed);
}

void check_measure(const Rupture& rupture, const Item& item, Context& context) {
  const bool mixed = rupture.stress_measure == StressMeasure::mixed;
  if (mixed)
    require_keys(item, {{"alpha", "a number in [0, 1], with stress_measure = \"mixed\"", true, "", ""}}, context);
  if (!mixed && item.has("alpha"))
    context.errors.add(item.child("alpha").location, "has no effect", "with stress_measure = \"mixed\" only");
}

}  // namespace

Value<Rupture> rupture_table(const Vocabulary& vocabulary) {
  const auto keys = table<Rupture>({
      field<Rupture>("rupture_time", &Rupture::rupture_time, function({"q", "T"}, greater(0)),
                     "time to rupture; `q` is the stress of `stress_measure`")
          .in("time"),
      field<Rupture>("larson_miller_constant", &Rupture::larson_miller_constant, number(greater(0)),
                     "C in P = (T - absolute_zero) (C + log10 of the time to rupture)"),
      field<Rupture>("stress", &Rupture::stress, list(number(greater(0))),
                     "stresses of the Larson-Miller data: at least two, increasing")
          .in("stress")
          .otherwise("required without `rupture_time`"),
      field<Rupture>("parameter", &Rupture::parameter, list(number()), "values of P at these stresses; decreasing")
          .otherwise("required without `rupture_time`"),
      field<Rupture>("absolute_zero", &Rupture::absolute_zero, number(),
                     "absolute zero in your unit of temperature: -273.15 for degrees Celsius, 0 for kelvin")
          .in("temperature"),
      field<Rupture>(
          "time_unit", &Rupture::time_unit, number(greater(0)),
          "your unit of time, expressed in the unit of the data: 1/3600 if t is in seconds and the data in hours"),
      field<Rupture>("stress_measure", &Rupture::stress_measure, choice<StressMeasure>("stress measure"),
                     "stress that decides the time to rupture: `q`, max(sigma_1, 0), or `alpha` max(sigma_1, 0) + (1 - "
                     "`alpha`) q"),
      field<Rupture>("alpha", &Rupture::alpha, number({.min = 0, .max = 1}), "weight of the largest principal stress")
          .otherwise("required with `\"mixed\"`"),
  });
  return converted<Rupture>(
      keys, [vocabulary](Rupture rupture, const Item& item, Context& context) -> std::optional<Rupture> {
        rupture.location = item.location;
        check_data(rupture, item, vocabulary, context);
        check_measure(rupture, item, context);
        return rupture;
      });
}

}  // namespace creepcontact::config
