#include "configured_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "item.hpp"
#include "toml_text.hpp"

namespace creepcontact::config {
namespace {

/// 1 and 1.0 are the same number, 'x' and "x" the same text.
std::string canonical_leaf(const toml::node& node) {
  if (const auto* text = node.as_string()) return '"' + text->get() + '"';
  if (node.is_number()) return fmt::format("{}", node.value<double>().value());
  return printed(node);
}

/// Keys below a key have entries of their own; the schema has them right after it.
bool has_keys_below(std::size_t number, const std::vector<KeyInfo>& schema) {
  if (number + 1 == schema.size()) return false;
  const std::string &path = schema[number].path, &next = schema[number + 1].path;
  return next.starts_with(path + '.') || next.starts_with(path + '[');
}

class Collector {
 public:
  Collector(const KeyInfo& key, const std::vector<KeyInfo>& schema) : key_(key), schema_(schema) {}

  /// @param path  what is left of the key's, below `table`
  void collect(const toml::table& table, std::string_view path, const std::string& prefix) {
    if (!key_.only_with.empty() && path.find_first_of(".[") == std::string_view::npos &&
        table["law"].value<std::string>() != key_.only_with)
      return;
    const std::size_t end = path.find_first_of(".[");
    const std::string_view name = path.substr(0, end);
    if (name == "<name>") {
      for (const auto& [own, node] : table)
        if (const toml::table* inner = node.as_table())
          collect(*inner, path.substr(end + 1), fmt::format("{}.{}", prefix, own.str()));
      return;
    }
    const std::string here = join_key(prefix, name);
    const toml::node* node = table.get(name);
    if (end == std::string_view::npos) {
      if (node != nullptr)
        values.push_back({here, toml_text(*node, canonical_leaf)});
      else if (!key_.default_value.empty())
        values.push_back({here, key_.default_value});
    } else if (path[end] == '[') {
      const toml::array* array = node != nullptr ? node->as_array() : nullptr;
      for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
        if (const toml::table* inner = array->get(i)->as_table())
          collect(*inner, path.substr(end + 3), fmt::format("{}[{}]", here, i));
    } else if (const toml::table* inner = node != nullptr ? node->as_table() : nullptr) {
      collect(*inner, path.substr(end + 1), here);
    } else if (is_implied(key_.path.substr(0, key_.path.size() - path.size() + end))) {
      collect({}, path.substr(end + 1), here);
    }
  }

  std::vector<ConfiguredValue> values;

 private:
  bool is_implied(const std::string& path) const {
    return std::ranges::any_of(schema_, [&](const KeyInfo& key) { return key.path == path && key.implied; });
  }

  const KeyInfo& key_;
  const std::vector<KeyInfo>& schema_;
};

}  // namespace

bool ConfiguredFunction::may_depend_on(const std::string& variable) const {
  return std::ranges::find(variables, variable) != variables.end();
}

bool ConfiguredFunction::is_of_position_and_time() const {
  return std::ranges::all_of(variables, [](const std::string& variable) {
    return variable == "x" || variable == "y" || variable == "z" || variable == "t";
  });
}

std::vector<ConfiguredValue> configured_values(const toml::table& document, const std::vector<KeyInfo>& schema) {
  std::vector<ConfiguredValue> all;
  for (std::size_t i = 0; i < schema.size(); ++i) {
    const KeyInfo& key = schema[i];
    if (!key.identifies_model || has_keys_below(i, schema)) continue;
    Collector collector(key, schema);
    collector.collect(document, key.path, "");
    std::ranges::move(collector.values, std::back_inserter(all));
  }
  return all;
}

}  // namespace creepcontact::config
