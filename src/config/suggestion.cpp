#include "creepcontact/config/suggestion.hpp"

#include <algorithm>
#include <cctype>

namespace creepcontact::config {
namespace {

int letter_distance(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? 1 : 2;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);  // distances of a's first i letters to every beginning of b
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = static_cast<int>(2 * j);
  for (std::size_t i = 0; i < a.size(); ++i) {
    int diagonal = row[0];
    row[0] += 2;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int replaced = diagonal + letter_distance(a[i], b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 2, row[j + 1] + 2});
    }
  }
  return row.back();
}

std::string nearest(std::string_view name, const std::vector<std::string>& names) {
  constexpr std::size_t telling = 3;  // letters of a beginning that can be meant as one
  const auto distance = [&](const std::string& candidate) {
    return name.size() >= telling && candidate.starts_with(name) ? 0 : edit_distance(name, candidate);
  };
  const auto found = std::min_element(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return distance(a) < distance(b);
  });
  return found == names.end() ? std::string() : *found;
}

}  // namespace creepcontact::config
