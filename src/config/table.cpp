#include "table.hpp"

namespace creepcontact::config {

bool known_keys_only(const Item& table, const std::vector<std::string>& keys, Context& context) {
  bool all_known = true;
  for (const auto& [key, node] : *table.node->as_table()) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    const Location where = locate(key.source(), join_key(table.location.key, key.str()), table.location);
    context.errors.add_unknown_key(where, std::string(key.str()), keys);
    all_known = false;
  }
  return all_known;
}

void require_keys(const Item& table, const std::vector<KeyInfo>& keys, Context& context) {
  for (const KeyInfo& key : keys) {
    if (!key.required || table.has(key.path)) continue;
    Location where = table.location;
    where.key = join_key(where.key, key.path);
    context.errors.add(where, "missing", key.type);
  }
}

bool has_wrong_brackets(const Item& item, Form form, Context& context) {
  if (item.location.line == 0) return false;  // an override has no headings
  const std::string heading = without_indices(item.location.key);
  const toml::table* table = item.node->as_table();
  if (form == Form::tables && table && !table->is_inline()) {
    context.errors.add(
        item.location, fmt::format("written [{}]", heading),
        fmt::format("[[{}]], with two brackets: there may be several, each with its own heading", heading));
    return true;
  }
  if (form != Form::tables && item.node->is_array_of_tables()) {
    const bool named = form == Form::named;
    context.errors.add(item.location, fmt::format("written [[{}]]", heading),
                       named ? fmt::format("[{}.<name>], with single brackets and a name of yours", heading)
                             : fmt::format("[{}], with single brackets: there is only one", heading));
    return true;
  }
  return false;
}

Json schema_of_table() {
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
}

void add_key(const KeyInfo& key, Json value, Json& table) {
  value["description"] =
      key.dimension.empty() ? key.description : fmt::format("{} [{}]", key.description, key.dimension);
  if (const Json shown = Json::parse(key.default_value, nullptr, false); !shown.is_discarded())
    value["default"] = shown;
  table["properties"][key.path] = std::move(value);
  if (key.required) table["required"].push_back(key.path);
}

Json schema_of_list(const Json& entry, int size) {
  Json schema{{"type", "array"}, {"items", entry}};
  if (size > 0) schema["minItems"] = schema["maxItems"] = size;
  return schema;
}

std::string brief_type(const std::string& type, const std::string& brief) {
  if (!brief.empty()) return brief;
  for (const std::string_view article : {"a ", "an ", "the "})
    if (type.starts_with(article)) return type.substr(article.size());
  return type;
}

void append_below(const std::string& parent, const std::vector<KeyInfo>& keys, std::vector<KeyInfo>& all) {
  for (KeyInfo key : keys) {
    key.path = key.path.starts_with('[') ? parent + key.path : parent + '.' + key.path;
    all.push_back(key);
  }
}

namespace {

/// @param entry  of one value; its argument is what is allowed, for messages
template <class T>
Value<std::vector<T>> one_or_more_of(Value<T> (*entry)(const std::string&), const std::string& what) {
  const std::string type = what + " or a list of them";
  Value<std::vector<T>> value{.type = type, .read = {}};
  value.json = [=] {
    const Json one = entry(what).json();
    Json several = schema_of_list(one);
    several["minItems"] = 1;
    return schema_of_any({one, several});
  };
  value.read = [=](const Item& item, Context& context) -> std::optional<std::vector<T>> {
    if (item.node->is_array()) {
      auto all = list(entry(what)).read(item, context);
      if (!all || !all->empty()) return all;
    } else if (item.node->is_string()) {
      if (const auto one = entry(type).read(item, context)) return std::vector{*one};
      return std::nullopt;
    }
    context.errors.add(item.location, describe(*item.node), type);
    return std::nullopt;
  };
  value.visit = [=](const std::vector<T>& all, Visitor& to) {
    if (all.empty()) return;  // no file has an empty list of them
    if (all.size() == 1) return entry(what).visit(all.front(), to);
    list(entry(what)).visit(all, to);
  };
  return value;
}

}  // namespace

Value<std::vector<Reference>> one_or_more(const std::string& what) {
  return one_or_more_of<Reference>(reference, what);
}

Value<std::vector<std::string>> one_or_more_texts(const std::string& what) {
  return one_or_more_of<std::string>(name, what);
}

Value<Interval> interval(const Value<double>& entry) {
  const std::string type = "[low, high], the smaller number first";
  const Value<std::vector<double>> numbers = list(entry);
  Value<Interval> value{.type = type, .read = {}, .brief = "`[low, high]`, numbers", .json = [entry] {
                          return schema_of_list(entry.json(), 2);
                        }};
  value.read = [=](const Item& item, Context& context) -> std::optional<Interval> {
    if (!item.node->is_array()) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    const auto found = numbers.read(item, context);
    if (!found) return std::nullopt;
    if (found->size() == 2 && (*found)[0] <= (*found)[1]) return Interval{(*found)[0], (*found)[1]};
    context.errors.add(item.location, fmt::format("[{}]", fmt::join(*found, ", ")), type);
    return std::nullopt;
  };
  value.visit = [numbers](const Interval& one, Visitor& to) { numbers.visit({one.low, one.high}, to); };
  return value;
}

}  // namespace creepcontact::config
