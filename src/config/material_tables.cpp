/// [materials.<name>] and its creep mechanisms

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

Range range_of(const LawKey& key) {
  return {.min = key.minimum, .max = key.maximum, .open_min = key.strict};
}

std::optional<CreepParameter> read_parameter(const Item& item, const LawKey& key, Context& context) {
  const Value<Function> value = function(key.variables, range_of(key));
  CreepParameter parameter{key.name, {}, item.location, true};
  if (key.list) {
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

/// The law's own opinion, once every value is there.
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
  for (const LawKey& key : law.keys) {
    names.push_back(key.name);
    if (key.required)
      required.push_back({key.name, function(key.variables, range_of(key)).type, true, "", key.description});
  }
  known_keys_only(item, names, context);
  require_keys(item, required, context);
  CreepMechanism mechanism{law.name, {}, item.location};
  for (const LawKey& key : law.keys) {
    const Item found = item.child(key.name);
    if (!found.node) {
      if (!key.required) mechanism.parameters.push_back({key.name, key.fallback, item.location, false});
      continue;
    }
    if (auto parameter = read_parameter(found, key, context)) mechanism.parameters.push_back(std::move(*parameter));
  }
  if (check_lengths(mechanism, law, context)) validate(mechanism, law, context);
  return mechanism;
}

KeyInfo law_key(const Law& law, const LawKey& key) {
  const Value<Function> one = function(key.variables, range_of(key));
  const Value<std::vector<Function>> several = list(one);
  return {.path = key.name,
          .type = key.list ? several.type : one.type,
          .required = key.required,
          .default_value = key.fallback.empty() ? "" : key.fallback.front().text(),
          .description = key.description,
          .brief = key.list ? several.brief : one.brief,
          .only_with = law.name};
}

std::vector<KeyInfo> law_keys(const std::vector<Law>& laws, const std::vector<std::string>& names) {
  std::vector<KeyInfo> keys{{.path = "law",
                             .type = choice("creep law", names).type,
                             .required = true,
                             .default_value = {},
                             .description = "creep law; the other keys are the constants of this law",
                             .brief = "creep law; see `creepcontact list laws`"}};
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
  for (const LawKey& key : law.keys) {
    const Value<Function> one = function(key.variables, range_of(key));
    Json& own = table["properties"][key.name] = key.list ? list(one).json() : one.json();
    own["description"] = key.description;
    if (key.required) table["required"].push_back(key.name);
  }
  return table;
}

Json laws_schema(const std::vector<Law>& laws, const std::vector<std::string>& names) {
  Json table{{"type", "object"}, {"required", Json::array({"law"})}, {"properties", {{"law", schema_of_words(names)}}}};
  for (const Law& law : laws)
    table["allOf"].push_back({{"if", {{"properties", {{"law", {{"const", law.name}}}}}}}, {"then", law_schema(law)}});
  return table;
}

/// The keys depend on `law`, so this is no plain table.
Value<CreepMechanism> mechanism_table(const std::vector<Law>& laws) {
  std::vector<std::string> names;
  names.reserve(laws.size());
  for (const Law& law : laws) names.push_back(law.name);
  Value<CreepMechanism> value{
      .type = "a table", .read = {}, .keys = law_keys(laws, names), .form = Form::table, .json = [=] {
        return laws_schema(laws, names);
      }};
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

}  // namespace

Value<Material> material_table(const Vocabulary& vocabulary) {
  const std::vector<std::string> T{"T"};
  const Range compressible{.min = -1.0, .max = 0.5, .open_min = true, .open_max = true};
  const auto keys = table<Material>({
      field<Material>("young_modulus", &Material::young_modulus, function(T, greater(0)), "Young's modulus",
                      Presence::required)
          .in("stress"),
      field<Material>("poisson_ratio", &Material::poisson_ratio, function(T, compressible), "Poisson's ratio",
                      Presence::required),
      field<Material>("thermal_expansion", &Material::thermal_expansion, function(T),
                      "secant coefficient: strain = alpha(T) (T - `reference_temperature`)")
          .in("1/temperature"),
      field<Material>("reference_temperature", &Material::reference_temperature, number(),
                      "temperature at which the thermal strain is zero")
          .otherwise("required with `thermal_expansion` and `[temperature]`")
          .in("temperature"),
      field<Material>("creep", &Material::creep, tables(mechanism_table(vocabulary.laws)),
                      "creep laws that act together: their rates are added")
          .otherwise("elastic"),
      field<Material>("rupture", &Material::rupture, rupture_table(vocabulary),
                      "time to rupture at constant stress, for the fraction of life used up"),
      field<Material>("data_range", &Material::data_range, data_range_table(),
                      "what the creep laws were fitted to: `run` warns where a body leaves it")
          .changeable(),
      field<Material>("sources", &Material::sources, text(),
                      "where the data come from, such as a standard or a test report; copied to `model.json` and "
                      "reports")
          .changeable(),
  });
  return converted<Material>(keys, [](Material material, const Item& item, Context&) -> std::optional<Material> {
    material.location = item.location;
    return material;
  });
}

}  // namespace creepcontact::config
