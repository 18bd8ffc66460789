/// [materials.<name>] and its creep mechanisms

#include "creepcontact/config/material_library.hpp"
#include "library_use.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

Value<Function> value_of(const LawKey& key) {
  return function(key.variables, {.min = key.minimum, .max = key.maximum, .open_min = key.strict});
}

/// A value of the key: what is allowed, in words, and its schema.
struct LawValue {
  std::string type, brief;
  MakeJson json;
  std::vector<Word> words;
};

LawValue allowed(const LawKey& key) {
  if (!key.words.empty()) {
    const Value<std::string> word = choice(key.name, key.words);
    return {word.type, word.brief, word.json, word.words};
  }
  const Value<Function> one = value_of(key);
  if (!key.list) return {one.type, one.brief, one.json, {}};
  const Value<std::vector<Function>> several = list(one);
  return {several.type, several.brief, several.json, {}};
}

/// Returns a default as it is written in a file.
std::string default_of(const LawKey& key) {
  if (key.fallback.empty()) return "";
  if (key.words.empty()) return key.fallback.front().text();
  return fmt::format("\"{}\"", key.words.at(static_cast<std::size_t>(key.fallback.front()({}))));
}

}  // namespace

void describe_parameter(const LawKey& key, CreepParameter& parameter) {
  parameter.is_list = key.list;
  parameter.variables = key.variables;
}

CreepParameter default_parameter(const LawKey& key, const Location& location) {
  CreepParameter parameter{.key = key.name, .values = key.fallback, .location = location, .given = false};
  describe_parameter(key, parameter);
  return parameter;
}

namespace {

std::optional<CreepParameter> read_parameter(const Item& item, const LawKey& key, Context& context) {
  const Value<Function> value = value_of(key);
  CreepParameter parameter{.key = key.name, .values = {}, .location = item.location};
  describe_parameter(key, parameter);
  if (!key.words.empty()) {
    const auto number = read_choice(item, context, key.name, key.words);
    if (!number) return std::nullopt;
    parameter.values = {static_cast<double>(*number)};
    parameter.word = key.words[*number];
  } else if (key.list) {
    const auto values = list(value).read(item, context);
    if (!values) return std::nullopt;
    if (values->empty()) {
      context.errors.add(item.location, "an empty list", "at least one value");
      return std::nullopt;
    }
    parameter.values = *values;
  } else {
    const auto one = value.read(item, context);
    if (!one) return std::nullopt;
    parameter.values = {*one};
  }
  return parameter;
}

/// Keys of all laws.
const std::vector<Field<CreepMechanism>>& common_keys() {
  static const std::vector<Field<CreepMechanism>> keys{
      field<CreepMechanism>("units", &CreepMechanism::units, text(),
                            "units of the constants and ranges of this block, such as \"MPa, h, degC\": they are "
                            "converted to `units` of the model")
          .otherwise("those of the model"),
      field<CreepMechanism>("stress_range", &CreepMechanism::stress_range, interval(number()),
                            "von Mises stresses for which the constants were determined; warns where the stress is "
                            "larger, or smaller everywhere")
          .in("stress")
          .changeable(),
      field<CreepMechanism>("temperature_range", &CreepMechanism::temperature_range, interval(number()),
                            "temperatures for which the constants were determined; warns outside")
          .in("temperature")
          .changeable(),
      field<CreepMechanism>("time_range", &CreepMechanism::time_range, interval(number()),
                            "times of the readings for which the constants were determined; warns if the run is longer")
          .in("time")
          .changeable()};
  return keys;
}

/// @returns true if the lists are of one length
bool check_lengths(const CreepMechanism& mechanism, const Law& law, Context& context) {
  bool right = true;
  const CreepParameter* first = nullptr;
  for (const LawKey& key : law.keys) {
    for (const CreepParameter& parameter : mechanism.parameters) {
      if (!key.list || parameter.key != key.name || parameter.values.empty()) continue;
      if (!first) first = &parameter;
      if (parameter.values.size() == first->values.size()) continue;
      context.errors.add(parameter.location, fmt::format("a list of {}", parameter.values.size()),
                         fmt::format("as many values as '{}' has: {}", first->key, first->values.size()));
      right = false;
    }
  }
  return right;
}

/// Asks the law to check its constants, once every value is there.
void validate(CreepMechanism& mechanism, const Law& law, Context& context) {
  if (!law.validate || mechanism.parameters.size() != law.keys.size()) return;
  std::vector<std::vector<Function>> values;
  for (const CreepParameter& parameter : mechanism.parameters) values.push_back(parameter.values);
  const LawValidation verdict = law.validate(values);
  mechanism.depends_on_temperature = verdict.depends_on_temperature;
  if (!verdict.mistake) return;
  const auto at = std::find_if(mechanism.parameters.begin(), mechanism.parameters.end(),
                               [&](const CreepParameter& parameter) { return parameter.key == verdict.mistake->key; });
  context.errors.add(at == mechanism.parameters.end() ? mechanism.location : at->location, verdict.mistake->found,
                     verdict.mistake->allowed);
}

std::optional<CreepMechanism> read_law(const Item& item, const Law& law, Context& context) {
  std::vector<std::string> names{"law"};
  std::vector<KeyInfo> required;
  for (const Field<CreepMechanism>& key : common_keys()) names.push_back(key.info.path);
  for (const LawKey& key : law.keys) {
    names.push_back(key.name);
    if (key.required) required.push_back({key.name, allowed(key).type, true, "", key.description});
  }
  known_keys_only(item, names, context);
  require_keys(item, required, context);
  CreepMechanism mechanism{law.name, {}, item.location};
  for (const Field<CreepMechanism>& key : common_keys())
    if (const Item found = item.child(key.info.path); found.node) key.read(found, context, mechanism);
  for (const LawKey& key : law.keys) {
    const Item found = item.child(key.name);
    if (!found.node) {
      if (!key.required) mechanism.parameters.push_back(default_parameter(key, item.location));
      continue;
    }
    if (auto parameter = read_parameter(found, key, context)) mechanism.parameters.push_back(std::move(*parameter));
  }
  if (check_lengths(mechanism, law, context)) validate(mechanism, law, context);
  return mechanism;
}

KeyInfo law_key(const Law& law, const LawKey& key) {
  const LawValue value = allowed(key);
  return {.path = key.name,
          .type = value.type,
          .required = key.required,
          .default_value = default_of(key),
          .description = key.description,
          .brief = value.brief,
          .words = value.words,
          .only_with = law.name};
}

std::vector<KeyInfo> law_keys(const std::vector<Law>& laws, const std::vector<std::string>& names) {
  std::vector<KeyInfo> keys{{.path = "law",
                             .type = choice("creep law", names).type,
                             .required = true,
                             .default_value = {},
                             .description = "creep law; the other keys are the constants of this law",
                             .brief = "creep law; see `creepcontact list laws`"}};
  for (const Field<CreepMechanism>& key : common_keys()) keys.push_back(key.info);
  for (const Law& law : laws) {
    keys.front().words.push_back({law.name, law.formula});
    for (const LawKey& key : law.keys) keys.push_back(law_key(law, key));
  }
  return keys;
}

/// The keys that go with a law, and no others.
Json law_schema(const Law& law) {
  Json table = schema_of_table();
  table["properties"]["law"] = {{"const", law.name}};
  table["required"] = Json::array({"law"});
  for (const Field<CreepMechanism>& key : common_keys()) add_key(key.info, key.json(), table);
  for (const LawKey& key : law.keys) {
    Json& own = table["properties"][key.name] = allowed(key).json();
    own["description"] = key.description;
    if (key.required) table["required"].push_back(key.name);
  }
  return table;
}

Json laws_schema(const std::vector<Law>& laws, const std::vector<std::string>& names) {
  Json table{{"type", "object"}, {"required", Json::array({"law"})}, {"properties", {{"law", schema_of_words(names)}}}};
  for (const Field<CreepMechanism>& key : common_keys()) add_key(key.info, key.json(), table);
  for (const Law& law : laws)
    table["allOf"].push_back({{"if", {{"properties", {{"law", {{"const", law.name}}}}}}}, {"then", law_schema(law)}});
  return table;
}

void visit_parameter(const CreepParameter& parameter, Visitor& to) {
  if (!parameter.word.empty()) return to.leaf([&] { return toml_of(parameter.word); });
  if (!parameter.is_list && parameter.values.size() == 1)
    return to.function(parameter.values.front(), parameter.variables);
  to.list([&] {
    for (std::size_t i = 0; i < parameter.values.size(); ++i)
      to.element(i, [&](Visitor& inner) { inner.function(parameter.values[i], parameter.variables); });
  });
}

/// The constants are those of the struct; a default that is a word is the number of it.
void visit_law(const CreepMechanism& mechanism, Visitor& to) {
  const auto never = [] { return false; };
  KeyInfo info;
  info.path = "law";
  to.key({info.path, &info, false, true, never},
         [&](Visitor& inner) { inner.leaf([&] { return toml_of(mechanism.law); }); });
  for (const Field<CreepMechanism>& key : common_keys()) key.visit(key, mechanism, to);
  for (const CreepParameter& parameter : mechanism.parameters) {
    if (parameter.values.empty()) continue;
    info.path = parameter.key;
    info.default_value = parameter.values.front().text();
    const auto is_default = [&] { return !parameter.given; };
    to.key({info.path, &info, false, true, is_default}, [&](Visitor& inner) { visit_parameter(parameter, inner); });
  }
}

}  // namespace

/// The keys depend on `law`, so this is not a plain table.
Value<CreepMechanism> mechanism_table(const std::vector<Law>& laws) {
  std::vector<std::string> names;
  names.reserve(laws.size());
  for (const Law& law : laws) names.push_back(law.name);
  Value<CreepMechanism> value{
      .type = "a table", .read = {}, .keys = law_keys(laws, names), .form = Form::table, .json = [=] {
        return laws_schema(laws, names);
      }};
  value.visit = [](const CreepMechanism& mechanism, Visitor& to) { to.table([&] { visit_law(mechanism, to); }); };
  value.read = [=](const Item& item, Context& context) -> std::optional<CreepMechanism> {
    if (!item.node->is_table()) {
      context.errors.add(item.location, describe(*item.node), "a table");
      return std::nullopt;
    }
    require_keys(item, {value.keys.front()}, context);
    const Item chosen = item.child("law");
    const auto index = chosen.node ? read_choice(chosen, context, "creep law", names) : std::nullopt;
    if (!index) return std::nullopt;  // which keys are right is not known
    return read_law(item, laws[*index], context);
  };
  return value;
}

/// Their keys are those of materials: lists name them once.
Value<std::vector<CreepMechanism>> laws_elsewhere(const Vocabulary& vocabulary) {
  auto laws = written_inline(tables(mechanism_table(vocabulary.laws)));
  laws.keys.clear();
  laws.brief = "list of tables as in `[[materials.<name>.creep]]`";
  return laws;
}

namespace {

constexpr const char* three = "a list of three";

Value<Orthotropic> orthotropic_table() {
  const std::vector<std::string> T{"T"};
  return table<Orthotropic>({
      field<Orthotropic>("young_moduli", &Orthotropic::young_moduli, triple(function(T, greater(0)), three),
                         "Young's moduli along the material axes: `[E1, E2, E3]`", Presence::required)
          .in("stress"),
      field<Orthotropic>(
          "poisson_ratios", &Orthotropic::poisson_ratios, triple(function(T), three),
          "Poisson's ratios `[nu12, nu23, nu13]`: nu12 is the contraction along axis 2 under stress along "
          "axis 1",
          Presence::required),
      field<Orthotropic>("shear_moduli", &Orthotropic::shear_moduli, triple(function(T, greater(0)), three),
                         "shear moduli `[G12, G23, G13]`", Presence::required)
          .in("stress"),
  });
}

/// One for all directions, or three along the material axes.
Value<std::vector<Function>> one_or_three(const Value<Function>& one) {
  const auto several = triple(one, three);
  Value<std::vector<Function>> value{.type = one.type + ", or three in a list: along the material axes 1, 2, 3",
                                     .read = {},
                                     .brief = one.brief + ", or a list of three",
                                     .json = [=] {
                                       return schema_of_any({one.json(), several.json()});
                                     }};
  value.read = [=, type = value.type](const Item& item, Context& context) -> std::optional<std::vector<Function>> {
    const toml::array* array = item.node->as_array();
    if (array != nullptr && array->size() == 3) return list(one).read(item, context);
    if (array != nullptr) {
      context.errors.add(item.location, fmt::format("a list of {}", array->size()), type);
      return std::nullopt;
    }
    const auto found = one.read(item, context);
    if (!found) return std::nullopt;
    return std::vector{*found};
  };
  value.visit = [one](const std::vector<Function>& all, Visitor& to) {
    if (all.size() == 1) return one.visit(all.front(), to);
    list(one).visit(all, to);
  };
  return value;
}

Value<Hill> hill_table() {
  const auto ratios = triple(number(greater(0)), three);
  return table<Hill>({
      field<Hill>("normal", &Hill::normal, ratios,
                  "`[R11, R22, R33]`: stresses along the material axes that cause the creep rate of the same von Mises "
                  "stress of the isotropic law, relative to it"),
      field<Hill>("shear", &Hill::shear, ratios,
                  "`[R12, R23, R13]`: the same for shear stresses times sqrt(3); below 1: creeps faster"),
  });
}

/// Names of the material library, and files of the user's own. @param materials  directory of the library
Value<std::vector<std::string>> library_names(const std::filesystem::path& materials) {
  Value<std::vector<std::string>> value = one_or_more_texts(library_use_type());
  value.brief = "name in the material library, or a list of them";
  value.json = [materials] {
    const Json one = schema_of_any(
        {schema_of_words(names_of(material_library(materials))), {{"type", "string"}, {"pattern", "\\.toml(/|$)"}}});
    Json several = schema_of_list(one);
    several["minItems"] = 1;
    return schema_of_any({one, several});
  };
  return value;
}

/// The reader has put the values where they belong, unless there is no `use`.
Value<LibraryOverrides> overrides_table() {
  Value<LibraryOverrides> value{.type = "a table of values by path, such as \"creep[0].A\" = 1e-20",
                                .read = {},
                                .brief = "table of values by path, such as `\"creep[0].A\" = 1e-20`",
                                .json = [] {
                                  return Json{{"type", "object"}};
                                }};
  value.read = [](const Item& item, Context& context) -> std::optional<LibraryOverrides> {
    context.errors.add(item.location, "has no effect", "with `use` only");
    return std::nullopt;
  };
  value.visit = [](const LibraryOverrides& /*none*/, Visitor& to) { to.table([] {}); };
  return value;
}

}  // namespace

Value<Material> material_table(const Vocabulary& vocabulary) {
  const std::vector<std::string> T{"T"};
  const Range compressible{.min = -1.0, .max = 0.5, .open_min = true, .open_max = true};
  const auto is_isotropic = [](const Material& material) {
    return !material.orthotropic && !material.young_modulus.is_zero();
  };
  const std::vector<Field<Material>> isotropic{
      field<Material>("young_modulus", &Material::young_modulus, function(T, greater(0)), "Young's modulus")
          .otherwise("required without `orthotropic`, unless only the heat is computed")
          .needed_if(is_isotropic)
          .in("stress"),
      field<Material>("poisson_ratio", &Material::poisson_ratio, function(T, compressible), "Poisson's ratio")
          .otherwise("required without `orthotropic`, unless only the heat is computed")
          .needed_if(is_isotropic),
  };
  const auto keys = table<Material>({
      field<Material>("use", &Material::use, library_names(vocabulary.materials),
                      "takes elasticity, expansion, creep, rupture and fatigue from the library: blocks that one name "
                      "does not have come from the next. Keys next to it replace what the library has. Needs `units`"),
      field<Material>("override", &Material::overrides, overrides_table(),
                      "replaces single values that `use` takes, in the units of the model")
          .otherwise("none"),
      field<Material>("units", &Material::units, text(),
                      "units of the numbers of this material: they are converted to `units` of the model")
          .otherwise("those of the model"),
      isotropic[0],
      isotropic[1],
      field<Material>("orthotropic", &Material::orthotropic, orthotropic_table(),
                      "elasticity along three axes, instead of the isotropic constants"),
      field<Material>("hill", &Material::hill, hill_table(),
                      "anisotropic creep: the equivalent stress of Hill in all creep laws"),
      field<Material>("thermal_expansion", &Material::thermal_expansion, one_or_three(function(T)),
                      "secant coefficient: strain = alpha(T) (T - `reference_temperature`); three: along the material "
                      "axes 1, 2, 3")
          .in("1/temperature"),
      field<Material>("reference_temperature", &Material::reference_temperature, number(),
                      "temperature at which the thermal strain is zero")
          .otherwise("required with `thermal_expansion` and `[temperature]`")
          .in("temperature"),
      field<Material>("conductivity", &Material::conductivity, one_or_three(function(T, greater(0))),
                      "of heat, for `[heat]`; three: along the material axes 1, 2, 3")
          .in("power/(length temperature)")
          .otherwise("required with `[heat]`"),
      field<Material>("heat_capacity", &Material::heat_capacity, function(T, greater(0)), "specific heat, for `[heat]`")
          .in("energy/(mass temperature)")
          .otherwise("required with `[heat]` unless the temperature is steady"),
      field<Material>("density", &Material::density, number(greater(0)), "mass per volume, for `heat_capacity`")
          .in("mass/volume")
          .otherwise("required with `heat_capacity`"),
      field<Material>("creep", &Material::creep, tables(mechanism_table(vocabulary.laws)),
                      "creep laws that act together: their rates are added")
          .otherwise("elastic"),
      field<Material>("plasticity", &Material::plasticity, plasticity_table(),
                      "yielding that does not depend on the rate (von Mises)"),
      field<Material>(
          "yield_strength", &Material::yield_strength, function(T, greater(0)),
          "what `check --start`, the table at the end and the report compare the von Mises stress with; does "
          "not make the material plastic")
          .otherwise("not compared")
          .in("stress")
          .changeable(),
      field<Material>("rupture", &Material::rupture, rupture_table(vocabulary),
                      "time to rupture at constant stress, for the fraction of life used up"),
      field<Material>("data_range", &Material::data_range, data_range_table(),
                      "older form of the ranges of all creep laws")
          .changeable(),
      field<Material>("fatigue", &Material::fatigue, fatigue_table(vocabulary),
                      "cycles to failure, for the life that the cycles of `time.cycle` use up"),
      field<Material>("sources", &Material::sources, one_or_more_texts("a text"),
                      "where the data come from, such as a standard or a test report; copied to `summary.json`, "
                      "`model.json` and reports")
          .changeable(),
  });
  return converted<Material>(keys, [isotropic](Material material, const Item& item, Context& context) {
    material.location = item.location;
    if (material.plasticity) {
      const Location& at = material.plasticity->location;
      if (material.orthotropic)
        context.errors.add(at, "with 'orthotropic' elasticity", "plasticity of materials with isotropic elasticity");
      if (material.hill)
        context.errors.add(at, "with 'hill'",
                           "one of the two: yielding is that of von Mises, 'hill' is for creep alone");
      for (const CreepMechanism& mechanism : material.creep)
        if (mechanism.law == "chaboche")
          context.errors.add(at, "next to the law 'chaboche', which has a yield stress of its own",
                             "one of the two: plasticity does not depend on the rate, chaboche does");
    }
    if (!material.orthotropic) {
      std::vector<KeyInfo> needed{isotropic[0].info, isotropic[1].info};
      for (KeyInfo& key : needed) key.required = !context.is_heat_alone;
      require_keys(item, needed, context);
    } else {
      for (const std::string& key : given_keys(item, {"young_modulus", "poisson_ratio"}))
        context.errors.add(item.child(key).location, "the elasticity is given by 'orthotropic' too",
                           "either isotropic constants or 'orthotropic'");
    }
    return std::optional(std::move(material));
  });
}

}  // namespace creepcontact::config
