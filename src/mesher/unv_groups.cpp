#include "unv_groups.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace creepcontact::mesher {
namespace {

constexpr std::array group_datasets{"2429", "2430", "2432", "2435", "2452", "2467", "2477"};
constexpr int node_code = 7, element_code = 8;

std::string trimmed(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r"), end = line.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : line.substr(begin, end - begin + 1);
}

std::vector<std::int64_t> numbers(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::int64_t> all;
  for (std::int64_t number = 0; stream >> number;) all.push_back(number);
  return all;
}

/// A head with the number of members, the name, then code, number and two more fields of each member.
void read_dataset(std::istream& stream, std::vector<NumberedGroup>& groups) {
  std::string line;
  while (std::getline(stream, line) && trimmed(line) != "-1") {
    const std::vector<std::int64_t> head = numbers(line);
    if (head.size() < 8 || !std::getline(stream, line)) continue;
    NumberedGroup group{trimmed(line), {}, {}};
    for (std::int64_t left = head[7]; left > 0 && std::getline(stream, line);) {
      if (trimmed(line) == "-1") return;
      const std::vector<std::int64_t> fields = numbers(line);
      const std::size_t width = fields.size() % 4 == 0 ? 4 : 2;  // older datasets have two fields
      if (fields.size() < width) break;
      for (std::size_t i = 0; i + width <= fields.size() && left > 0; i += width, --left)
        if (fields[i] == node_code)
          group.nodes.push_back(static_cast<std::uint64_t>(fields[i + 1]));
        else if (fields[i] == element_code)
          group.elements.push_back(static_cast<std::uint64_t>(fields[i + 1]));
    }
    groups.push_back(std::move(group));
  }
}

}  // namespace

std::vector<NumberedGroup> unv_groups(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<NumberedGroup> groups;
  for (std::string line; std::getline(stream, line);) {
    if (trimmed(line) != "-1" || !std::getline(stream, line)) continue;
    const std::string dataset = trimmed(line);
    if (dataset == "-1") continue;
    if (std::ranges::find(group_datasets, dataset) != group_datasets.end()) {
      read_dataset(stream, groups);
      continue;
    }
    while (std::getline(stream, line) && trimmed(line) != "-1") {
    }
  }
  return groups;
}

}  // namespace creepcontact::mesher
