/// [[criteria]]

#include <algorithm>

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

constexpr std::array strengths{"yield_strength", "rupture_strength"};

/// A function of t and T, or the name of a strength.
Value<CriterionLimit> allowed_value() {
  const Value<Function> given = function({"t", "T"});
  Value<CriterionLimit> value{.type = given.type + ", \"yield_strength\" or \"rupture_strength\"",
                              .read = {},
                              .brief = given.brief + ", `\"yield_strength\"` or `\"rupture_strength\"`",
                              .words = words_of({strengths[0], strengths[1]}),
                              .json = [given] {
                                return schema_of_any({given.json(), schema_of_words({strengths[0], strengths[1]})});
                              }};
  value.read = [given](const Item& item, Context& context) -> std::optional<CriterionLimit> {
    const auto text = item.node->value<std::string>();
    if (text == strengths[0]) return CriterionLimit{CriterionLimit::Kind::yield_strength, 0.0};
    if (text == strengths[1]) return CriterionLimit{CriterionLimit::Kind::rupture_strength, 0.0};
    const auto found = given.read(item, context);
    if (!found) return std::nullopt;
    return CriterionLimit{CriterionLimit::Kind::function, *found};
  };
  value.visit = [given](const CriterionLimit& allowed, Visitor& to) {
    if (allowed.kind == CriterionLimit::Kind::function) return given.visit(allowed.value, to);
    to.leaf([kind = allowed.kind] {
      return toml_of(std::string(strengths[kind == CriterionLimit::Kind::yield_strength ? 0 : 1]));
    });
  };
  return value;
}

Value<std::array<std::array<double, 3>, 2>> two_points() {
  const auto point = triple(number());
  const auto points = list(point);
  return converted<std::array<std::array<double, 3>, 2>>(
      points,
      [](const std::vector<std::array<double, 3>>& found, const Item& item,
         Context& context) -> std::optional<std::array<std::array<double, 3>, 2>> {
        if (found.size() == 2 && found[0] != found[1]) return std::array{found[0], found[1]};
        context.errors.add(item.location, fmt::format("{} points", found.size()), "two different points [x, y, z]");
        return std::nullopt;
      },
      [](const std::array<std::array<double, 3>, 2>& from) {
        return std::vector<std::array<double, 3>>(from.begin(), from.end());
      });
}

using Keys = std::vector<std::string>;

/// What counts for a criterion of this kind beyond name and times.
Keys keys_of(const Criterion& criterion) {
  if (!criterion.kind) {
    if (criterion.quantity.empty()) return {"min", "max", "safety"};
    if (criterion.path) return {"min", "max", "safety", "body", "path", "part", "life"};
    return {"min", "max", "safety", "body", "away_from", "distance", "life"};
  }
  switch (*criterion.kind) {
    case CriterionKind::yield:
      return {"body", "away_from", "distance", "safety"};
    case CriterionKind::creep_life:
      return {"body", "away_from", "distance", "max"};
    case CriterionKind::creep_strain:
      return {"body", "path", "strains"};
    case CriterionKind::leak:
      return {"contact", "min", "safety"};
    default:
      return {"contact", "min"};
  }
}

void check(const Criterion& criterion, const Item& item, Context& context) {
  const auto report = [&](const char* key, const std::string& what, const std::string& allowed) {
    context.errors.add(item.has(key) ? item.child(key).location : item.location, what, allowed);
  };
  const Keys of_what = given_keys(item, {"probe", "expression", "quantity", "kind"});
  if (of_what.size() != 1)
    return report("",
                  of_what.empty() ? "nothing that it is about" : fmt::format("'{}' and '{}'", of_what[0], of_what[1]),
                  "one of probe, expression, quantity, kind");
  const Keys known = keys_of(criterion);
  for (const std::string& key : given_keys(item, {"body", "contact", "away_from", "distance", "path", "part", "strains",
                                                  "min", "max", "safety", "life"}))
    if (std::ranges::find(known, key) == known.end())
      report(key.c_str(), fmt::format("has no meaning with '{}'", of_what[0]),
             fmt::format("{}", fmt::join(known, ", ")));
  const bool has_limit = item.has("min") || item.has("max");
  if (item.has("min") && item.has("max")) report("max", "given next to 'min'", "two criteria, one for each");
  const bool needs_limit = !criterion.kind || criterion.kind == CriterionKind::leak;
  if (needs_limit && !has_limit)
    report("", "no limit",
           criterion.kind ? "with 'min', the smallest mean pressure that is tight" : "with 'min' or 'max'");
  if (criterion.kind == CriterionKind::creep_strain && (!criterion.path || !criterion.body.given()))
    report("", "no path through the wall of a body", "with 'body' and path = [[x, y, z], [x, y, z]]");
  if (criterion.path && !criterion.quantity.empty() && criterion.quantity != "von_mises")
    report("path", fmt::format("along it '{}' is not linearised", criterion.quantity), "quantity = \"von_mises\"");
  if (criterion.path && !criterion.quantity.empty() && !criterion.body.given())
    report("path", "given without a body", "with 'body'");
  if ((criterion.kind == CriterionKind::leak || criterion.kind == CriterionKind::interference_lost) &&
      !criterion.contact.given())
    report("", "no contact", "with 'contact'");
  if (item.has("distance") != item.has("away_from"))
    report(item.has("distance") ? "distance" : "away_from", "given without the other one",
           "'away_from' and 'distance' together");
  for (const std::optional<CriterionLimit>* limit : {&criterion.min, &criterion.max}) {
    if (!*limit) continue;
    const char* const key = limit == &criterion.min ? "min" : "max";
    if (criterion.quantity.empty() &&
        ((*limit)->kind != CriterionLimit::Kind::function || (*limit)->value.depends_on_temperature()))
      report(key, "depends on the place or its temperature, which is not known here", "a number or a function of t");
  }
  if (item.has("life") && criterion.max.value_or(CriterionLimit()).kind != CriterionLimit::Kind::rupture_strength)
    report("life", "has no meaning here", "with max = \"rupture_strength\"");
  if (item.has("at"))
    for (const std::string& key : given_keys(item, {"from", "until"}))
      report(key.c_str(), "given next to 'at'", "either 'at', or 'from' and 'until'");
  if (criterion.from && criterion.until && !(*criterion.until > *criterion.from))
    report("until", fmt::format("{:g} after 'from' = {:g}", *criterion.until, *criterion.from), "a time after 'from'");
}

}  // namespace

Value<Criterion> criterion_table(const Vocabulary& vocabulary) {
  std::vector<std::string> fields;
  for (const Quantity& quantity : vocabulary.quantities)
    if (!quantity.surface_only && !quantity.sum_only && !quantity.body_only && !quantity.section)
      fields.push_back(quantity.name);
  Value<std::string> quantity = text();
  quantity.type = "a quantity of points in a body; see `creepcontact list quantities`";
  quantity.words = words_of(fields);
  quantity.json = [fields] { return schema_of_words(fields); };
  quantity.read = [fields, type = quantity.type](const Item& item, Context& context) -> std::optional<std::string> {
    auto found = name(type).read(item, context);
    if (!found || std::ranges::find(fields, *found) != fields.end()) return found;
    context.errors.add_unknown(item.location, fmt::format("unknown quantity '{}'", *found), *found, fields, type);
    return std::nullopt;
  };
  const auto time = number({.min = 0});
  const auto keys = table<Criterion>({
      field<Criterion>("name", &Criterion::name, name("a name"), "its name in `summary.json`, log and report; unique",
                       Presence::required),
      field<Criterion>("probe", &Criterion::probe, reference("the name of a probe"), "judges this probe, or ..."),
      field<Criterion>("expression", &Criterion::expression, reference("an expression of names of probes and t"),
                       "... an expression of names of probes and t, or ..."),
      field<Criterion>("quantity", &Criterion::quantity, quantity,
                       "... a quantity at all integration points of a body, or ..."),
      field<Criterion>("kind", &Criterion::kind, choice<CriterionKind>("kind of criterion"),
                       "... by a kind that is known: `\"yield\"`, `\"creep_life\"`, `\"creep_strain\"`, `\"leak\"`, "
                       "`\"interference_lost\"`")
          .otherwise("none"),
      field<Criterion>("body", &Criterion::body, reference("the name of a body"),
                       "body of `quantity`, yield, creep_life, creep_strain")
          .otherwise("all bodies"),
      field<Criterion>("contact", &Criterion::contact, reference("the name of a contact"),
                       "contact of leak and interference_lost"),
      field<Criterion>("min", &Criterion::min, allowed_value(),
                       "what is found must not be smaller, at any time that counts; of a field the function may "
                       "depend on T")
          .otherwise("none"),
      field<Criterion>("max", &Criterion::max, allowed_value(),
                       "what is found must not be larger; of a field it may depend on T, or be the strength of the "
                       "material at the temperature of the place")
          .otherwise("none; 1 for creep_life"),
      field<Criterion>("safety", &Criterion::safety, number(greater(0)),
                       "factor by which the limit is made stricter: `max` is divided by it, `min` multiplied"),
      field<Criterion>("life", &Criterion::life, number(greater(0)),
                       "time to rupture for which the rupture strength counts")
          .in("time")
          .otherwise("`time.end`"),
      field<Criterion>("away_from", &Criterion::away_from, list(triple(number())),
                       "points near which the field does not count, such as singular corners")
          .in("length")
          .otherwise("none"),
      field<Criterion>("distance", &Criterion::distance, number({.min = 0}), "how near").in("length"),
      field<Criterion>("path", &Criterion::path, two_points(),
                       "a line through the wall, along which the strain of creep_strain, or the stress of "
                       "`quantity = \"von_mises\"`, is linearised")
          .in("length")
          .otherwise("required for creep_strain; else none"),
      field<Criterion>("part", &Criterion::part, choice<LinearisedPart>("part of a linearised stress"),
                       "with `path` and `quantity`: what of the linearised stress counts"),
      field<Criterion>("strains", &Criterion::strains, triple(number(greater(0)), "three numbers"),
                       "creep_strain: largest principal inelastic strain on average (membrane), with the linear part "
                       "(bending), and anywhere on the path"),
      field<Criterion>("from", &Criterion::from, time, "first time that counts").in("time").otherwise("the start"),
      field<Criterion>("until", &Criterion::until, time, "last time that counts").in("time").otherwise("the end"),
      field<Criterion>("at", &Criterion::at, time, "the only time that counts").in("time").otherwise("all times"),
  });
  return converted<Criterion>(keys, [](Criterion criterion, const Item& item, Context& context) {
    criterion.location = item.location;
    check(criterion, item, context);
    return std::optional(std::move(criterion));
  });
}

}  // namespace creepcontact::config
