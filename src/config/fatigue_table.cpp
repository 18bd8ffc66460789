/// [materials.<name>.fatigue]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

const std::vector<std::string> curve_keys{"strain_range", "cycles"};

Value<std::vector<double>> pair_of_fractions() {
  Value<std::vector<double>> pair = list(number({.min = 0, .max = 1, .open_min = true, .open_max = true}));
  pair.type = "[life fraction, cycle fraction], numbers in (0, 1)";
  pair.brief = pair.plural = "`[life, cycles]`, in (0, 1)";
  pair.read = [read = pair.read, type = pair.type](const Item& item,
                                                   Context& context) -> std::optional<std::vector<double>> {
    auto found = read(item, context);
    if (found && found->size() == 2) return found;
    if (found) context.errors.add(item.location, fmt::format("a list of {}", found->size()), type);
    return std::nullopt;
  };
  return pair;
}

void check_curve(const Fatigue& fatigue, const Item& item, const Vocabulary& vocabulary, Context& context) {
  if (item.has("cycles_to_failure")) {
    for (const std::string& key : given_keys(item, curve_keys))
      context.errors.add(item.child(key).location, "given together with cycles_to_failure", "one of the two");
  } else if (given_keys(item, curve_keys).empty()) {
    context.errors.add(item.location, "no fatigue data", "cycles_to_failure, or strain_range and cycles");
    return;
  } else {
    require_keys(
        item,
        {{"strain_range", "a list of numbers > 0", true, "", ""}, {"cycles", "a list of numbers > 0", true, "", ""}},
        context);
  }
  if (!vocabulary.validate_fatigue || fatigue.strain_range.empty() != fatigue.cycles.empty()) return;
  if (const auto mistake = vocabulary.validate_fatigue(fatigue.strain_range, fatigue.cycles, fatigue.interaction))
    context.errors.add(item.child(mistake->key).location, mistake->found, mistake->allowed);
}

}  // namespace

Value<Fatigue> fatigue_table(const Vocabulary& vocabulary) {
  const auto keys = table<Fatigue>({
      field<Fatigue>(
          "cycles_to_failure", &Fatigue::cycles_to_failure, function({"eps", "T"}, greater(0)),
          "number of cycles to failure; `eps` is the equivalent range of the total strain in a cycle, `T` the "
          "highest temperature"),
      field<Fatigue>("strain_range", &Fatigue::strain_range, list(number(greater(0))),
                     "strain ranges of a fatigue curve: at least two, increasing; between them it is straight in a "
                     "double logarithmic plot, as beyond them")
          .otherwise("required without `cycles_to_failure`"),
      field<Fatigue>("cycles", &Fatigue::cycles, list(number(greater(0))),
                     "cycles to failure at these strain ranges; decreasing")
          .otherwise("required without `cycles_to_failure`"),
      field<Fatigue>(
          "interaction", &Fatigue::interaction, list(pair_of_fractions()),
          "points `[life fraction, cycle fraction]` of the interaction diagram between `[0, 1]` and `[1, 0]`, "
          "such as `[[0.3, 0.3]]`")
          .otherwise("the straight line: the sum of both is 1"),
  });
  return converted<Fatigue>(
      keys, [vocabulary](Fatigue fatigue, const Item& item, Context& context) -> std::optional<Fatigue> {
        fatigue.location = item.location;
        check_curve(fatigue, item, vocabulary, context);
        return fatigue;
      });
}

}  // namespace creepcontact::config
