#include "diagnostics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "known_words.hpp"

namespace creepcontact::config {

std::string Location::prefix() const {
  std::string text = file;
  if (line > 0) text += fmt::format(":{}:{}", line, column);
  if (!text.empty()) text += ": ";
  if (!key.empty()) text += key + ": ";
  return text;
}

void Diagnostics::add(const Location& where, const std::string& found, const std::string& allowed) {
  problems_.push_back({where, allowed.empty() ? found : fmt::format("{}; allowed: {}", found, allowed)});
}

void Diagnostics::add_unknown(const Location& where, const std::string& found, const std::string& name,
                              const std::vector<std::string>& names, const std::string& allowed) {
  if (const std::string familiar = said_of_value(where.key, name); !familiar.empty()) {
    problems_.push_back({where, fmt::format("{}: {}", found, familiar)});
    return;
  }
  const std::string all = allowed.empty() ? fmt::format("{}", fmt::join(names, ", ")) : allowed;
  const std::string question = did_you_mean(name, names);
  if (question.empty()) return add(where, found, all);
  problems_.push_back({where, fmt::format("{}{} (allowed: {})", found, question, all)});
}

void Diagnostics::add_unknown_key(const Location& where, const std::string& name,
                                  const std::vector<std::string>& names) {
  const std::string familiar = said_of_key(where.key, name);
  if (familiar.empty())
    add_unknown(where, "unknown key", name, names);
  else
    problems_.push_back({where, familiar.starts_with(absent_feature) ? familiar : "unknown key: " + familiar});
}

void Diagnostics::throw_if_any() const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    const bool a_placed = a.where.line > 0, b_placed = b.where.line > 0;  // overrides come last
    return std::tuple(!a_placed, a.where.line, a.where.column) < std::tuple(!b_placed, b.where.line, b.where.column);
  });
  std::string message;
  for (const Problem& problem : sorted) {
    if (!message.empty()) message += '\n';
    message += problem.where.prefix() + problem.text;
  }
  throw ConfigError(message);
}

}  // namespace creepcontact::config
