#include "overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>

#include "creepcontact/config/dotted_key.hpp"
#include "item.hpp"
#include "key_length.hpp"

namespace creepcontact::config {
namespace {

/// `key = value` parsed as a document of its own: dotted keys and values then mean what they mean in TOML.
class Override {
 public:
  Override(const std::string& text, Diagnostics& errors)
      : where_{std::string(override_prefix) + text}, errors_(errors) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      errors_.add(where_, "no '='", "key.path=value");
      return;
    }
    const std::string key = with_dots(text.substr(0, equals));
    if (find_long_key(key + '=' + text.substr(equals + 1))) {
      errors_.add(where_, long_key_mistake);
      return;
    }
    if (!is_key(key)) {
      errors_.add(where_, "no valid key before the '='", "key.path=value");
      return;
    }
    parse(key, text.substr(equals + 1));
  }

  void put_into(toml::table& document) {
    if (parsed_) put(*parsed_, document, "");
  }

 private:
  static bool is_key(const std::string& key) {
    try {
      return toml::parse(key + " = 0").size() == 1;
    } catch (const toml::parse_error&) {
      return false;
    }
  }

  void parse(const std::string& key, const std::string& value) {
    try {
      parsed_ = toml::parse(key + " = " + value, where_.file);
    } catch (const toml::parse_error& error) {
      const std::size_t begin = std::min(value.find_first_not_of(" \t"), value.size());
      const std::string word = value.substr(begin, value.find_last_not_of(" \t") + 1 - begin);
      if (!word.empty() && std::string_view("[{\"'").find(word[0]) != std::string_view::npos) {
        errors_.add(where_, std::string(error.description()));
        return;
      }
      std::ostringstream quoted;
      quoted << toml::value<std::string>(word);
      parsed_ = toml::parse(key + " = " + quoted.str(), where_.file);
    }
  }

  static bool is_value(const toml::node& node) { return !node.is_table() || node.as_table()->is_inline(); }

  /// @param chain  one key, and below it the next of the path, down to the value
  void put(toml::table& chain, toml::node& into, const std::string& path) {
    const toml::key key = chain.begin()->first;
    toml::node& next = *chain.get(key.str());
    if (auto* array = into.as_array()) {
      put_into_array(key, next, *array, path);
    } else {
      put_into_table(key, next, *into.as_table(), path);
    }
  }

  void put_into_table(const toml::key& key, toml::node& next, toml::table& into, const std::string& path) {
    toml::node* existing = into.get(key.str());
    if (is_value(next) || !existing || !(existing->is_table() || existing->is_array())) {
      if (!is_value(next) && !existing && (path == "bodies" || path == "materials")) return report_new(key, into, path);
      into.insert_or_assign(key, std::move(next));
    } else {
      put(*next.as_table(), *existing, join_key(path, key.str()));
    }
  }

  void put_into_array(const toml::key& key, toml::node& next, toml::array& into, const std::string& path) {
    std::size_t index = into.size();
    const std::string_view digits = key.str();
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (parsed.ec != std::errc() || parsed.ptr != digits.data() + digits.size() || index >= into.size()) {
      errors_.add(where_, fmt::format("{}.{}: there is no entry '{}'", path, digits, digits),
                  into.empty() ? "none, the list is empty" : fmt::format("an index from 0 to {}", into.size() - 1));
      return;
    }
    toml::node& existing = *into.get(index);
    if (!is_value(next) && (existing.is_table() || existing.is_array())) {
      put(*next.as_table(), existing, fmt::format("{}[{}]", path, index));
    } else {
      into.replace(into.cbegin() + index, std::move(next));
    }
  }

  /// A single key of a new body or material is a mistyped name rather than the whole of a new one.
  void report_new(const toml::key& key, const toml::table& table, const std::string& path) {
    std::vector<std::string> names;
    for (const auto& [name, node] : table) names.emplace_back(name.str());
    Location where = where_;
    where.key = join_key(path, key.str());
    errors_.add_unknown(where, "unknown name", std::string(key.str()), names);
  }

  Location where_;
  Diagnostics& errors_;
  std::optional<toml::table> parsed_;
};

}  // namespace

void apply_override(const std::string& override_text, toml::table& document, Diagnostics& errors) {
  Override(override_text, errors).put_into(document);
}

}  // namespace creepcontact::config
