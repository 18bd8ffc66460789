#include "creepcontact/material/law_reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "creepcontact/material/registry.hpp"

namespace creepcontact::material {
namespace {

std::string quoted(const std::string& word) {
  return fmt::format("`\"{}\"`", word);
}

std::string allowed(const ParameterInfo& key) {
  if (!key.words.empty()) {
    std::vector<std::string> words;
    for (const std::string& word : key.words) words.push_back(quoted(word));
    return fmt::format("{}", fmt::join(words, ", "));
  }
  std::string text = key.list ? "list of " : "";
  if (key.variables.empty())
    text += key.list ? "numbers" : "number";
  else
    text += fmt::format("{} of {}", key.list ? "functions" : "function", fmt::join(key.variables, ", "));
  if (std::isfinite(key.maximum) && !std::isfinite(key.minimum))
    text += fmt::format(", <= {}", key.maximum);
  else if (std::isfinite(key.maximum))
    text += fmt::format(", in {}{}, {}]", key.strict ? '(' : '[', key.minimum, key.maximum);
  else if (std::isfinite(key.minimum))
    text += fmt::format(", {} {}", key.strict ? ">" : ">=", key.minimum);
  return text;
}

std::string fallback(const ParameterInfo& key) {
  if (!key.fallback) return "*required*";
  if (!key.words.empty()) return quoted(key.words.at(static_cast<std::size_t>(key.fallback->front()({}))));
  return key.fallback->empty() ? "" : fmt::format("`{}`", key.fallback->front().text());
}

}  // namespace

std::string law_reference() {
  std::string text;
  for (const LawInfo& law : creep_laws()) {
    text += fmt::format("### `{}`\n\n`{}` ({})\n\n", law.name, law.formula, law.source);
    text += "| key | type | default | meaning |\n|---|---|---|---|\n";
    for (const ParameterInfo& key : law.parameters)
      text += fmt::format("| `{}` | {} | {} | {} |\n", key.key, allowed(key), fallback(key), key.description);
    text += "\n";
  }
  return text;
}

}  // namespace creepcontact::material
