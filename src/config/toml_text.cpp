#include "toml_text.hpp"

#include <sstream>
#include <vector>

namespace creepcontact::config {

std::string path_part(std::string_view key) {
  const bool needs_marks = key.empty() || (key.find('"') == std::string_view::npos &&
                                           key.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                                                 "0123456789_-.[]") != std::string_view::npos);
  return needs_marks ? '"' + std::string(key) + '"' : std::string(key);
}

std::string printed(const toml::node& leaf) {
  std::ostringstream stream;
  leaf.visit([&](const auto& one) { stream << one; });
  return stream.str();
}

// Without recursion: dotted keys nest thousands of levels.
std::string toml_text(const toml::node& node, const std::function<std::string(const toml::node&)>& leaf_text) {
  struct Open {
    const toml::array* array;
    const toml::table* table;
    toml::table::const_iterator at;  // in a table
    std::size_t n_done = 0;
  };
  std::string text;
  std::vector<Open> open;
  const auto append = [&](const toml::node& one) {
    if (const auto* array = one.as_array()) {
      text += '[';
      open.push_back({array, nullptr, {}});
    } else if (const auto* table = one.as_table()) {
      text += "{ ";
      open.push_back({nullptr, table, table->begin()});
    } else {
      text += leaf_text(one);
    }
  };
  append(node);
  while (!open.empty()) {
    Open& last = open.back();
    if (last.n_done == (last.array != nullptr ? last.array->size() : last.table->size())) {
      text += last.array != nullptr ? "]" : " }";
      open.pop_back();
      continue;
    }
    if (last.n_done > 0) text += ", ";
    const std::size_t number = last.n_done++;
    if (last.array != nullptr) {
      append(*last.array->get(number));
    } else {
      const auto& [key, value] = *last.at;
      ++last.at;
      text.append(path_part(key.str())).append(" = ");
      append(value);
    }
  }
  return text;
}

}  // namespace creepcontact::config
