#include "table.hpp"

namespace creepcontact::config {

bool known_keys_only(const Item& table, const std::vector<std::string>& keys, Context& context) {
  bool all_known = true;
  for (const auto& [key, node] : *table.node->as_table()) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    const Location where = locate(key.source(), join_key(table.location.key, key.str()), table.location);
    context.errors.add_unknown(where, "unknown key", std::string(key.str()), keys);
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

void append_below(const std::string& parent, const std::vector<KeyInfo>& keys, std::vector<KeyInfo>& all) {
  for (KeyInfo key : keys) {
    key.path = key.path.starts_with('[') ? parent + key.path : parent + '.' + key.path;
    all.push_back(key);
  }
}

}  // namespace creepcontact::config
