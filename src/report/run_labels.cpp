#include "run_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "creepcontact/base/utf8.hpp"

namespace creepcontact::report {
namespace {

/// "gap" of "contacts[0].gap"; "temperature.value" whole, since many keys end like that
std::string end_of_key(const std::string& key) {
  std::size_t dot = key.rfind('.');
  if (dot != std::string::npos && dot > 0 && key.substr(dot) == ".value") dot = key.rfind('.', dot - 1);
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

std::string cut(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && continues_utf8(text[end])) --end;
  return text.substr(0, end) + "…";
}

}  // namespace

std::vector<InputDifference> input_differences(const std::vector<const io::ModelRecord*>& runs) {
  std::vector<std::string> keys;
  std::set<std::string> seen;
  std::vector<std::map<std::string, std::string>> values;
  for (const io::ModelRecord* run : runs) {
    if (run->inputs.empty()) return {};
    auto& own = values.emplace_back();
    for (const io::RecordedInput& input : run->inputs) {
      own[input.key] = input.value;
      if (seen.insert(input.key).second && input.key != "title" && !input.key.starts_with("remarks"))
        keys.push_back(input.key);
    }
  }
  std::vector<InputDifference> all;
  for (const std::string& key : keys) {
    InputDifference one{key, {}};
    for (const auto& own : values) {
      const auto found = own.find(key);
      one.values.push_back(found == own.end() ? "-" : found->second);
    }
    if (std::ranges::any_of(one.values, [&](const std::string& value) { return value != one.values.front(); }))
      all.push_back(std::move(one));
  }
  return all;
}

std::vector<std::string> labels_by_inputs(const std::vector<InputDifference>& differences,
                                          const std::vector<std::string>& directories) {
  constexpr std::size_t most_keys = 2, longest_value = 24;
  std::vector<std::string> labels(directories.size());
  for (std::size_t d = 0; d < std::min(differences.size(), most_keys); ++d)
    for (std::size_t r = 0; r < labels.size(); ++r)
      labels[r] += fmt::format("{}{} = {}", d > 0 ? ", " : "", end_of_key(differences[d].key),
                               cut(differences[d].values[r], longest_value));
  const std::set<std::string> all(labels.begin(), labels.end());
  if (all.size() == labels.size() && !all.contains("")) return labels;
  for (std::size_t r = 0; r < labels.size(); ++r)
    labels[r] = labels[r].empty() ? directories[r] : fmt::format("{} ({})", directories[r], labels[r]);
  return labels;
}

}  // namespace creepcontact::report
