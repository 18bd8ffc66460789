#include "creepcontact/base/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace creepcontact {
namespace {

int letter_distance(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? 1 : 2;
}

bool same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char c, char d) { return letter_distance(c, d) < 2; });
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before, row(b.size() + 1), next(b.size() + 1);  // distances of a's first letters to b's
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = static_cast<int>(2 * j);
  for (std::size_t i = 0; i < a.size(); ++i) {
    next[0] = row[0] + 2;
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j] + letter_distance(a[i], b[j]), next[j] + 2, row[j + 1] + 2});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        next[j + 1] = std::min(next[j + 1], before[j - 1] + 2);
    }
    before = row;
    row.swap(next);
  }
  return row.back();
}

std::string nearest(std::string_view name, const std::vector<std::string>& names) {
  constexpr std::size_t telling = 3;  // letters of a part that can be meant as one
  const auto distance = [&](const std::string& candidate) {
    if (same_but_for_case(name, candidate)) return 0;
    const bool is_part = ('_' + candidate + '_').find('_' + std::string(name) + '_') != std::string::npos;
    return name.size() >= telling && (is_part || candidate.starts_with(name)) ? 0 : edit_distance(name, candidate);
  };
  const auto found = std::min_element(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return distance(a) < distance(b);
  });
  if (found == names.end() || 3 * distance(*found) > 2 * static_cast<int>(name.size())) return {};
  return *found;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& names) {
  const std::string near = nearest(name, names);
  return near.empty() ? near : fmt::format("; did you mean '{}'?", near);
}

}  // namespace creepcontact
